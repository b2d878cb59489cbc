#include "brush/preset.hpp"
#include "core/text_file.hpp"
#include "document/action_checks.hpp"
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

/// What puts medium, brush and all else in hand again, as a recording. The brush is told in full: one
/// that comes with the program may be another in a later version.
document::Recording setup_of(const PaintingState& painting) {
    document::Recording setup;
    setup.canvas = painting.settings;
    const auto add = [&](document::Action action) { setup.events.push_back({0, std::move(action)}); };
    add(painting.medium);
    add(painting.tilt);
    add(document::SetDrying{painting.air});
    add(document::SetStabiliser{painting.aids.stabiliser});
    add(document::SetGuide{painting.aids.guide});
    add(document::SetSymmetry{painting.symmetry});
    if (painting.brush) {
        document::TakeBrush take = painting.brush->taken;
        take.definition = brush::preset_to_json(document::preset_of(take));
        add(std::move(take));
    }
    return setup;
}

SurfaceIndex surface_index(const document::SurfaceState& surface) {
    const film::FilmState& film = surface.film;
    return {.shape = film.shape,
            .cell_mm = film.cell_mm,
            .varied = film.varied,
            .fixed = film.strata.fixed,
            .evaporated = film.strata.evaporated,
            .calls = surface.solver.calls,
            .runoff = surface.solver.runoff,
            .entries = {}};
}

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
    for (LayerIndex& layer : index.layers)
        surfaces.push_back(&layer.surface);
    if (index.bare_support) surfaces.push_back(&*index.bare_support);
    if (index.well) surfaces.push_back(&*index.well);
    return surfaces;
}

SurfaceIndex add_surface(const document::SurfaceState& surface, const std::string& folder, Draft& draft,
                         const film::SupportHeights* bare_support_mm = nullptr) {
    draft.surfaces.emplace_back(surface, bare_support_mm, folder, draft.archive);
    SurfaceIndex index = surface_index(surface);
    index.entries = draft.surfaces.back().entries();
    return index;
}

/// The active layer, on the canvas and with the memory of its solver.
LayerIndex add_active(const PaintingState& painting, std::size_t place, Draft& draft) {
    LayerIndex layer{painting.layers.layers[place],
                     layer_picture(place),
                     add_surface(painting.canvas, layer_folder(place), draft, &painting.bare_support_mm),
                     {}};
    if (painting.settings.support != "image")
        layer.bare_support_checksum =
            bare_support_checksum(painting.bare_support_mm, layer.surface.entries);
    return layer;
}

LayerIndex add_asleep(const document::Layer& layer, std::size_t place, Draft& draft) {
    return {
        layer, layer_picture(place), add_surface({*layer.asleep, {}}, layer_folder(place), draft), {}};
}

void add_layers(const PaintingState& painting, Draft& draft) {
    const document::LayerStack& stack = painting.layers;
    ProjectIndex& index = draft.index;
    index.groups = stack.groups;
    index.active_layer = stack.active;
    index.next_layer = stack.next_layer;
    index.next_group = stack.next_group;
    for (std::size_t place = 0; place < stack.layers.size(); ++place)
        index.layers.push_back(place == stack.active ? add_active(painting, place, draft)
                                                     : add_asleep(stack.layers[place], place, draft));
}

/// A height image of the painter's own may be gone when the file is opened.
void add_bare_support(const PaintingState& painting, Draft& draft) {
    if (painting.settings.support != "image") return;
    const film::FilmState& canvas = painting.canvas.film;
    document::SurfaceState bare{film::FilmState(canvas.shape, canvas.cell_mm), {}};
    bare.film.support_mm = painting.bare_support_mm;
    draft.index.bare_support = add_surface(bare, kBareSupportFolder, draft);
}

void add_painting(const Project& project, Draft& draft) {
    const PaintingState& painting = project.painting;
    ProjectIndex& index = draft.index;
    index = {.program = PASTOSO_VERSION,
             .tick = painting.tick,
             .ageing = painting.ageing,
             .taken = painting.taken,
             .wiped = painting.wiped,
             .forgotten_run_off = painting.forgotten_run_off};
    add_layers(painting, draft);
    add_bare_support(painting, draft);
    index.support_form = film::form_of(painting.bare_support_mm);
    if (painting.well) index.well = add_surface(*painting.well, kWellFolder, draft);
    if (painting.brush) {
        const auto held = std::as_bytes(std::span(painting.brush->held));
        index.brush = {painting.brush->strokes_begun, add_packed(kBrushEntry, held, draft.archive)};
    }
    if (painting.selection)
        index.selection = add_packed(kSelectionEntry, mask_bits(*painting.selection), draft.archive);
    if (painting.tracing) {
        const layers::Tracing& tracing = *painting.tracing;
        index.tracing = {tracing.place, tracing.opacity};
        draft.archive.add(kTracingEntry, files::png_file(*tracing.picture));
    }
    const std::string strokes = recordings::recording_to_json(project.strokes);
    index.strokes = add_packed(kStrokesEntry, packing::bytes_of(strokes), draft.archive);
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
                   const std::filesystem::path& path, const std::string& name) {
    Draft draft;
    draft.archive.add("mimetype", std::string(kMimeType));
    draft.archive.add("stack.xml", stack_xml(pictures));
    for (PictureFile& file : picture_files(pictures))
        draft.archive.add(file.entry, std::move(file.content));
    draft.archive.add(kSetupEntry, recordings::recording_to_json(setup_of(project.painting)));
    add_painting(project, draft);
    std::future<void> packed = std::async(std::launch::async, [&draft, &pool] {
        for (TilePacking& surface : draft.surfaces)
            surface.pack(pool);
    });
    add_index(draft, packed);
    draft.archive.write(path, name);
}

void save_project(const std::filesystem::path& path, const Project& project, core::ThreadPool& pool) {
    core::write_aside(path, [&](const std::filesystem::path& temporary) {
        const Pictures pictures = pictures_of(project.painting, pool);
        write_archive(project, pictures, pool, temporary, path.string());
    });
}

bool is_project_path(const std::filesystem::path& path) {
    return path.extension() == ".pastoso";
}

}  // namespace pastoso::project
