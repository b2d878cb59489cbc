#include "core/version.hpp"
#include "document/set_up.hpp"
#include "files/image.hpp"
#include "project/mask_bits.hpp"
#include "project/project.hpp"
#include "project/project_archive.hpp"
#include "project/project_index.hpp"
#include "project/project_layout.hpp"
#include "project/surface_tiles.hpp"
#include "recordings/recording_json.hpp"

#include <future>
#include <utility>

namespace pastoso::project {
namespace {

using document::PaintingState;

std::string layer_folder(std::size_t place) {
    return "pastoso/layer" + std::to_string(place) + "/";
}

/// An archive in the making: what is in it, and the tiles that are still to be packed.
struct Draft {
    ZipWriter archive;
    ProjectIndex index;
    std::vector<TilePacking> surfaces;  ///< in the order of surfaces_of(index)
};

std::vector<SurfaceIndex*> surfaces_of(ProjectIndex& index) {
    std::vector<SurfaceIndex*> surfaces;
    if (index.bare_support) surfaces.push_back(&*index.bare_support);
    for (LayerIndex& layer : index.layers)
        surfaces.push_back(&layer.surface);
    if (index.well) surfaces.push_back(&*index.well);
    if (index.copied) surfaces.push_back(&*index.copied);
    return surfaces;
}

SurfaceIndex add_surface(const document::SurfaceState& surface, const std::string& folder, Draft& draft,
                         const film::SupportHeights* bare_support_mm = nullptr) {
    draft.surfaces.emplace_back(surface, bare_support_mm, folder, draft.archive);
    SurfaceIndex index = recordings::surface_index(surface);
    index.entries = draft.surfaces.back().entries();
    return index;
}

/// The active layer, on the canvas and with the memory of its solver.
LayerIndex add_active(const PaintingState& painting, std::size_t place, Draft& draft) {
    const document::PaintingValue& value = painting.value;
    const document::BareCanvas& bare = *value.bare;
    LayerIndex layer{
        value.layers.layers[place],
        layer_picture(place),
        add_surface({value.film, painting.solver}, layer_folder(place), draft, &bare.support_mm),
        {}};
    if (bare.settings.support != "image")
        layer.bare_support_checksum = bare_support_checksum(bare.support_mm, layer.surface.entries);
    return layer;
}

LayerIndex add_inactive(const document::Layer& layer, std::size_t place, Draft& draft) {
    return {
        layer, layer_picture(place), add_surface({*layer.inactive, {}}, layer_folder(place), draft), {}};
}

/// A height image of the painter's own may be gone when the file is opened.
void add_bare_support(const document::BareCanvas& bare, double cell_mm, Draft& draft) {
    if (bare.settings.support != "image") return;
    document::SurfaceState surface{film::FilmState(bare.support_mm.shape(), cell_mm), {}};
    surface.film.support_mm = bare.support_mm;
    draft.index.bare_support = add_surface(surface, kBareSupportFolder, draft);
}

/// Puts each field of a painting into the archive; what is in the set-up is in an entry of its own.
struct FieldKeeper {
    const PaintingState& painting;
    Draft& draft;

    void operator()(const std::shared_ptr<const document::BareCanvas>& bare) const {
        add_bare_support(*bare, painting.value.film.cell_mm, draft);
        draft.index.support_form = film::form_of(bare->support_mm);
    }
    /// With the stack.
    void operator()(const film::FilmState&) const {}
    void operator()(const document::LayerStack& stack) const {
        ProjectIndex& index = draft.index;
        index.groups = stack.groups;
        index.active_layer = stack.active;
        index.next_layer = stack.next_layer;
        index.next_group = stack.next_group;
        for (std::size_t place = 0; place < stack.layers.size(); ++place)
            index.layers.push_back(place == stack.active
                                       ? add_active(painting, place, draft)
                                       : add_inactive(stack.layers[place], place, draft));
    }
    void operator()(const std::optional<film::FilmState>& well) const {
        if (well) draft.index.well = add_surface({*well, painting.well_solver}, kWellFolder, draft);
    }
    void operator()(const std::optional<document::BrushInHand>& in_hand) const {
        if (in_hand) draft.index.brush = add_brush(in_hand->brush, kBrushEntry);
    }
    void operator()(const document::BrushAside& aside) const {
        if (aside) draft.index.brush_aside = add_brush(aside->brush, kBrushAsideEntry);
    }
    BrushIndex add_brush(const brush::Brush& brush, const char* entry) const {
        return {brush.strokes_begun, brush.gathering, brush.consistencies, brush.media,
                add_packed(entry, std::as_bytes(std::span(brush.held)), draft.archive)};
    }
    void operator()(const document::Selection& selection) const {
        if (selection)
            draft.index.selection = add_packed(kSelectionEntry, mask_content(*selection), draft.archive);
    }
    void operator()(const document::Masking& masking) const {
        if (masking.cells)
            draft.index.masking = add_packed(kMaskingEntry, mask_content(*masking.cells), draft.archive);
        if (masking.tape)
            draft.index.masking_tape =
                add_packed(kMaskingTapeEntry, mask_content(*masking.tape), draft.archive);
    }
    void operator()(const document::SharedTracing& tracing) const {
        if (!tracing) return;
        draft.index.tracing = {tracing->place, tracing->opacity};
        draft.archive.add(kTracingEntry, files::png_file(*tracing->picture));
    }
    void operator()(const document::SharedReferences& board) const {
        if (!board) return;
        draft.index.next_reference = board->next;
        for (const document::Reference& reference : board->references) {
            draft.index.references.push_back(
                {reference.name, {reference.id, reference.place, reference.look}});
            draft.archive.add(reference_entry(reference.id),
                              [picture = reference.picture] { return picture->png; });
        }
    }
    void operator()(const document::CopiedPaint& copied) const {
        if (copied) draft.index.copied = add_surface({*copied, {}}, kCopiedFolder, draft);
    }
    void operator()(const document::PaintFlows& flows) const { draft.index.flows = flows; }
    void operator()(const document::UseMedium&) const {}
    void operator()(const document::TiltCanvas&) const {}
    void operator()(const film::DryingAir&) const {}
    void operator()(const brush::HandAids&) const {}
    void operator()(const brush::Symmetry&) const {}
};

void add_painting(const Project& project, Draft& draft) {
    const PaintingState& painting = project.painting;
    draft.index.program = core::version();
    draft.index.tick = painting.tick;
    draft.index.ageing = painting.ageing;
    document::for_each_field(FieldKeeper{painting, draft}, painting.value);
    const std::string strokes = recordings::recording_to_json(project.strokes);
    draft.index.strokes = add_packed(kStrokesEntry, packing::bytes_of(strokes), draft.archive);
}

/// The last entry, which says how large all packed ones are.
void add_index(Draft& draft, std::future<void>& packed) {
    draft.archive.add(kIndexEntry, [&draft, &packed] {
        packed.get();
        const std::vector<SurfaceIndex*> surfaces = surfaces_of(draft.index);
        for (std::size_t i = 0; i < surfaces.size(); ++i)
            surfaces[i]->entries = draft.surfaces[i].entries();
        return index_to_json(draft.index);
    });
}

}  // namespace

/// Tiles are packed by the pool while this thread makes the pictures' files and writes.
void write_archive(const Project& project, const Pictures& pictures, core::ThreadPool& pool,
                   core::OutputFile& file) {
    Draft draft;
    draft.archive.add("mimetype", std::string(kMimeType));
    // The second entry, so that the first bytes of the file tell a painting from any other OpenRaster
    // file.
    draft.archive.add(kSetupEntry,
                      recordings::recording_to_json(document::set_up_of(project.painting.value)));
    draft.archive.add("stack.xml", stack_xml(pictures));
    for (PictureFile& picture : picture_files(pictures))
        draft.archive.add(picture.entry, std::move(picture.content));
    add_painting(project, draft);
    std::future<void> packed = std::async(std::launch::async, [&draft, &pool] {
        for (TilePacking& surface : draft.surfaces)
            surface.pack(pool);
    });
    add_index(draft, packed);
    draft.archive.write(file);
}

void save_project(const std::filesystem::path& path, const Project& project, core::ThreadPool& pool,
                  core::Replaced replaced) {
    const auto write = [&](core::OutputFile& file) {
        write_archive(project, pictures_of(project.painting, pool), pool, file);
    };
    core::write_aside(path, write, replaced);
}

bool is_project_path(const std::filesystem::path& path) {
    return path.extension() == ".pastoso";
}

}  // namespace pastoso::project
