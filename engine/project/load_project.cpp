#include "core/error.hpp"
#include "core/memory.hpp"
#include "document/canvas.hpp"
#include "document/cloth.hpp"
#include "document/contents.hpp"
#include "document/set_up.hpp"
#include "document/well.hpp"
#include "files/image.hpp"
#include "film/support/support.hpp"
#include "project/mask_bits.hpp"
#include "project/project.hpp"
#include "project/project_index.hpp"
#include "project/project_layout.hpp"
#include "project/surface_tiles.hpp"
#include "recordings/consistency_record.hpp"
#include "recordings/recording_json.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <utility>

namespace pastoso::project {
namespace {

using document::PaintingState;
using recordings::told_by_paint;

std::string text_of(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string place_of(const ZipReader& archive, const char* entry) {
    return archive.name() + ", " + entry;
}

void check_kind(const ZipReader& archive) {
    if (!archive.has("mimetype") || text_of(archive.read("mimetype", 64)) != kMimeType)
        throw core::InputError("%1: is no painting of Pastoso.", archive.name());
    if (!archive.has(kIndexEntry)) {
        throw core::InputError("%1: is an OpenRaster picture of another program; it holds no wet paint.",
                               archive.name());
    }
}

ProjectIndex read_index(const ZipReader& archive) {
    check_kind(archive);
    return index_from_json(text_of(archive.read(kIndexEntry, kMostIndexBytes)),
                           place_of(archive, kIndexEntry));
}

document::Recording read_setup(const ZipReader& archive) {
    return recordings::recording_from_json(text_of(archive.read(kSetupEntry, kMostSetupBytes)),
                                           place_of(archive, kSetupEntry));
}

void check_memory(const ZipReader& archive, const document::CanvasSettings& canvas) {
    try {
        document::check_canvas_fits(canvas, core::available_memory_bytes());
    } catch (const core::InputError& error) {
        archive.fail(kSetupEntry, error.message());
    }
}

film::SupportHeights named_support(const ZipReader& archive, const document::CanvasSettings& canvas,
                                   film::SupportForm form, core::ThreadPool& pool) {
    try {
        return document::heights_of_cloth(canvas, pool, form);
    } catch (const core::InputError& error) {
        archive.fail(kSetupEntry, error.message());
    }
}

void check_surface(const ZipReader& archive, const core::Message& which, const SurfaceIndex& index,
                   const grid::Shape& shape, double cell_mm) {
    if (index.shape == shape && index.cell_mm == cell_mm) return;
    archive.fail(kIndexEntry, "the %1 has %2 x %3 cells, but %4 x %5 of another size are expected.",
                 which, index.shape.width, index.shape.height, shape.width, shape.height);
}

/// Reads the tiles, which tell what the index does not.
void fill(const ZipReader& archive, const SurfaceIndex& index, const film::Medium& in_hand,
          document::SurfaceState& surface, core::ThreadPool& pool) {
    read_tiles(archive, index.entries, surface, pool);
    film::FilmState& film = surface.film;
    if (!index.consistencies)
        film.consistencies =
            told_by_paint(document::contents_of(film::totals(film), film.cell_mm), in_hand);
}

/// The heights that a painter's own image gave.
film::SupportHeights read_bare_support(const ZipReader& archive, const SurfaceIndex& index,
                                       const grid::Shape& shape, double cell_mm,
                                       core::ThreadPool& pool) {
    check_surface(archive, core::message("bare support"), index, shape, cell_mm);
    document::SurfaceState bare = empty_surface(index);
    read_tiles(archive, index.entries, bare, pool);
    return bare.film.support_mm;
}

/// The support as its name tells it; says where it is not what was painted on.
film::SupportHeights make_named_support(const ZipReader& archive, const ProjectIndex& index,
                                        LoadedProject& project, const document::CanvasSettings& canvas,
                                        core::ThreadPool& pool) {
    const LayerIndex& layer = index.layers[index.active_layer];
    film::SupportHeights support_mm = named_support(archive, canvas, index.support_form, pool);
    if (layer.bare_support_checksum &&
        bare_support_checksum(support_mm, layer.surface.entries) != layer.bare_support_checksum)
        project.notes.push_back(
            core::message("%1: was saved by Pastoso with another form of %2; where nothing is painted, "
                          "the canvas looks different.",
                          archive.name(), canvas.support));
    return support_mm;
}

/// The active layer lies on the canvas.
void read_active(const ZipReader& archive, const ProjectIndex& index,
                 const document::CanvasSettings& canvas, LoadedProject& project,
                 core::ThreadPool& pool) {
    const LayerIndex& layer = index.layers[index.active_layer];
    const grid::Shape& shape = layer.surface.shape;
    document::SurfaceState surface = empty_surface(layer.surface);
    const bool is_named = canvas.support != "image";
    document::BareCanvas bare{canvas, film::SupportHeights(shape)};
    if (is_named) bare.support_mm = make_named_support(archive, index, project, canvas, pool);
    if (index.bare_support)
        bare.support_mm =
            read_bare_support(archive, *index.bare_support, shape, layer.surface.cell_mm, pool);
    surface.film.support_mm = bare.support_mm;
    PaintingState& painting = project.painting;
    fill(archive, layer.surface, document::medium_of(painting.value.medium), surface, pool);
    // Format 1 does not tell what an image gave: all that is dry counts as part of it.
    if (!is_named && !index.bare_support) bare.support_mm = surface.film.support_mm;
    painting.value.bare = std::make_shared<const document::BareCanvas>(std::move(bare));
    painting.value.film = std::move(surface.film);
    painting.solver = std::move(surface.solver);
}

/// Paint apart from what it lies on.
std::shared_ptr<const film::FilmState> read_apart(const ZipReader& archive, const SurfaceIndex& index,
                                                  const film::Medium& in_hand, core::ThreadPool& pool) {
    document::SurfaceState surface = empty_surface(index);
    fill(archive, index, in_hand, surface, pool);
    return std::make_shared<const film::FilmState>(std::move(surface.film));
}

void read_layers(const ZipReader& archive, const ProjectIndex& index,
                 const document::CanvasSettings& canvas, LoadedProject& project,
                 core::ThreadPool& pool) {
    for (const LayerIndex& layer : index.layers)
        check_surface(archive, core::message("canvas"), layer.surface, document::canvas_shape(canvas),
                      1.0 / canvas.px_per_mm);
    read_active(archive, index, canvas, project, pool);
    const film::Medium in_hand = document::medium_of(project.painting.value.medium);
    document::LayerStack& stack = project.painting.value.layers = stack_of(index);
    for (std::size_t place = 0; place < stack.layers.size(); ++place)
        if (place != stack.active)
            stack.layers[place].inactive =
                read_apart(archive, index.layers[place].surface, in_hand, pool);
}

void read_well(const ZipReader& archive, const SurfaceIndex& index, PaintingState& painting,
               core::ThreadPool& pool) {
    const film::FilmState bare = document::bare_well();
    check_surface(archive, core::message("mixing well"), index, bare.shape, bare.cell_mm);
    document::SurfaceState surface = empty_surface(index);
    fill(archive, index, document::medium_of(painting.value.medium), surface, pool);
    painting.value.well = std::move(surface.film);
    painting.well_solver = std::move(surface.solver);
}

/// Brushes hold millilitres, of paint that no channel counts more than a few thousand of per millimetre.
bool is_possible(const brush::Contents& held) {
    constexpr double kRounding = 1e-3, kMost_mm3 = 1e7, kMostPerVolume = 1e5;
    if (!(held.volume_mm3 >= -kRounding && held.volume_mm3 <= kMost_mm3)) return false;
    const double most = kMostPerVolume * std::max(0.0, held.volume_mm3) + kRounding;
    return std::all_of(held.paint.begin(), held.paint.end(),
                       [most](double amount) { return amount >= -kRounding && amount <= most; });
}

/// What the index tells of a brush that the set-up has put there.
void read_brush(const ZipReader& archive, const std::optional<BrushIndex>& told,
                const core::Message& which, const film::Medium& medium, document::BrushInHand* set_up) {
    if (told.has_value() != (set_up != nullptr))
        archive.fail(kIndexEntry, "the brush %1 is told of only in part.", which);
    if (!told) return;
    const BrushIndex& index = *told;
    brush::Brush& brush = set_up->brush;
    brush.gathering = index.gathering;
    brush.shape_tip();
    const Bytes content = read_packed(archive, index.held);
    if (content.size() != brush.held.size() * sizeof(brush::Contents)) {
        archive.fail(index.held.entry,
                     "holds the paint of another brush than the one %1, which has %2 bristles.", which,
                     brush.held.size());
    }
    std::memcpy(static_cast<void*>(brush.held.data()), content.data(), content.size());
    brush.strokes_begun = index.strokes_begun;
    if (!std::all_of(brush.held.begin(), brush.held.end(), is_possible))
        archive.fail(index.held.entry, "a bristle holds what none can.");
    if (index.media) brush.media = *index.media;
    brush.consistencies = index.consistencies.value_or(told_by_paint(brush.contents(), medium));
}

std::shared_ptr<const grid::Mask> read_mask(const ZipReader& archive, const PackedEntry& packed,
                                            const grid::Shape& shape, bool may_be_soft) {
    const bool is_soft = may_be_soft && packed.size == soft_mask_bytes(shape);
    if (packed.size != mask_bytes(shape) && !is_soft)
        archive.fail(packed.entry, "holds cells of another canvas than this one.");
    grid::Mask mask = mask_of_content(shape, read_packed(archive, packed));
    if (grid::chosen_area(mask).empty()) archive.fail(packed.entry, "holds no cell.");
    return std::make_shared<const grid::Mask>(std::move(mask));
}

document::Masking read_masking(const ZipReader& archive, const ProjectIndex& index,
                               const grid::Shape& shape) {
    document::Masking masking;
    if (index.masking) masking.cells = read_mask(archive, *index.masking, shape, false);
    if (!index.masking_tape) return masking;
    masking.tape = read_mask(archive, *index.masking_tape, shape, false);
    const auto is_masked = [&](const grid::Mask& cells) {
        return grid::chosen_area(grid::combined(*masking.tape, cells, grid::Combination::Subtract))
            .empty();
    };
    if (!masking.cells || !is_masked(*masking.cells))
        archive.fail(index.masking_tape->entry, "holds a cell that is not masked.");
    return masking;
}

pigment::Picture decoded(const ZipReader& archive, const std::string& entry, std::string_view file) {
    try {
        return files::decode_png(file);
    } catch (const core::InputError& error) {
        archive.fail(entry, error.message());
    }
}

void read_tracing(const ZipReader& archive, const document::SetTracing& set,
                  document::PaintingValue& painting) {
    const std::string file = text_of(archive.read(kTracingEntry, kMostTracingBytes));
    const auto picture = std::make_shared<const pigment::Picture>(decoded(archive, kTracingEntry, file));
    painting.tracing =
        std::make_shared<const layers::Tracing>(layers::Tracing{picture, set.place, set.opacity});
}

document::SharedReferencePicture read_reference_picture(const ZipReader& archive,
                                                        const std::string& entry) {
    auto picture = std::make_shared<document::ReferencePicture>();
    picture->png = text_of(archive.read(entry, kMostReferenceBytes));
    picture->pixels = decoded(archive, entry, picture->png);
    return picture;
}

void read_references(const ZipReader& archive, const ProjectIndex& index,
                     document::PaintingValue& painting) {
    if (index.next_reference == 1) return;
    auto board = std::make_shared<document::ReferenceBoard>();
    board->next = index.next_reference;
    for (const ReferenceIndex& told : index.references) {
        const std::string entry = reference_entry(told.set.reference);
        board->references.push_back({told.set.reference, told.name,
                                     read_reference_picture(archive, entry), told.set.place,
                                     told.set.look});
        if (document::pixel_count(*board) > document::kMostReferencePixels)
            archive.fail(entry, "makes the references larger than any board holds.");
    }
    painting.references = std::move(board);
}

/// Strokes that cannot be read cost their replay, not the painting.
void read_strokes(const ZipReader& archive, const PackedEntry& strokes,
                  const document::CanvasSettings& canvas, std::int64_t tick, LoadedProject& project) {
    const std::string text = text_of(read_packed(archive, strokes));
    try {
        project.strokes = recordings::recording_from_json(text, place_of(archive, kStrokesEntry),
                                                          recordings::Names::MayBeUnknown);
    } catch (const core::InputError& error) {
        project.strokes = {canvas, {}, 0};
        project.notes.push_back(core::message(
            "The painting is whole, but its strokes cannot be replayed: %1", error.message()));
    }
    if (!project.strokes.events.empty() && project.strokes.events.back().tick > tick)
        archive.fail(kStrokesEntry, "tells of strokes that are later than the painting.");
    const core::Message older = document::arithmetic_note(project.strokes.arithmetic);
    if (!project.strokes.events.empty() && !older.empty())
        project.notes.push_back(
            core::message("The painting is as it was saved, but its strokes %1", older));
    project.strokes.end_tick = tick;
}

LoadedProject loaded(const ZipReader& archive, core::ThreadPool& pool) {
    const ProjectIndex index = read_index(archive);
    const document::Recording setup = read_setup(archive);
    check_memory(archive, setup.canvas);
    LoadedProject project;
    PaintingState& painting = project.painting;
    document::PaintingValue& value = painting.value;
    document::set_up(setup, value);
    if (value.medium.name.empty()) archive.fail(kSetupEntry, "there is no medium in hand.");
    painting.tick = index.tick;
    painting.ageing = index.ageing;
    value.flows = index.flows;
    read_layers(archive, index, setup.canvas, project, pool);
    if (index.well) read_well(archive, *index.well, painting, pool);
    const film::Medium medium = document::medium_of(value.medium);
    read_brush(archive, index.brush, core::message("in hand"), medium,
               value.brush ? &*value.brush : nullptr);
    const auto aside =
        value.brush_aside ? std::make_shared<document::BrushInHand>(*value.brush_aside) : nullptr;
    read_brush(archive, index.brush_aside, core::message("aside"), medium, aside.get());
    value.brush_aside = aside;
    if (index.copied) {
        if (!recordings::is_possible_cell(index.copied->cell_mm))
            archive.fail(kIndexEntry, "the copied paint has cells of a size that no painting has.");
        value.copied = read_apart(archive, *index.copied, medium, pool);
    }
    if (index.selection) value.selection = read_mask(archive, *index.selection, value.film.shape, true);
    value.masking = read_masking(archive, index, value.film.shape);
    if (index.tracing) read_tracing(archive, *index.tracing, value);
    read_references(archive, index, value);
    read_strokes(archive, index.strokes, setup.canvas, painting.tick, project);
    return project;
}

void add_sizes(const SurfaceIndex& surface, std::map<std::string, KindSize>& sizes) {
    for (const TileEntry& entry : surface.entries) {
        KindSize& size = sizes[entry.kind];
        size.packed_bytes += entry.packed.packed_size;
        size.bytes += entry.packed.size;
    }
}

}  // namespace

LoadedProject load_project(const std::filesystem::path& path, core::ThreadPool& pool,
                           const core::Progress& progress) {
    return loaded(ZipReader(path, progress), pool);
}

LoadedProject parse_project(std::span<const std::byte> file, const std::string& name,
                            core::ThreadPool& pool) {
    return loaded(ZipReader(file, name), pool);
}

document::Recording load_strokes(const std::filesystem::path& path, std::vector<core::Message>& notes) {
    const ZipReader archive(path);
    const ProjectIndex index = read_index(archive);
    LoadedProject project;
    read_strokes(archive, index.strokes, read_setup(archive).canvas, index.tick, project);
    notes.insert(notes.end(), project.notes.begin(), project.notes.end());
    return project.strokes;
}

std::string load_thumbnail(const std::filesystem::path& path) {
    constexpr std::size_t kMostThumbnailBytes = std::size_t{1} << 20;
    return text_of(ZipReader(path).read("Thumbnails/thumbnail.png", kMostThumbnailBytes));
}

ProjectSummary project_summary(const std::filesystem::path& path) {
    const ZipReader archive(path);
    const ProjectIndex index = read_index(archive);
    const document::Recording setup = read_setup(archive);
    document::PaintingValue painting;
    document::set_up(setup, painting);
    std::map<std::string, KindSize> sizes;
    for (const LayerIndex& layer : index.layers)
        add_sizes(layer.surface, sizes);
    if (index.well) add_sizes(*index.well, sizes);
    if (index.copied) add_sizes(*index.copied, sizes);
    sizes["strokes"] = {"strokes", index.strokes.packed_size, index.strokes.size};
    ProjectSummary summary{.canvas = setup.canvas,
                           .program = index.program,
                           .tick = index.tick,
                           .medium = painting.medium.name,
                           .brush = painting.brush ? painting.brush->taken.preset : ""};
    for (auto& [kind, size] : sizes) {
        size.kind = kind;
        summary.sizes.push_back(size);
    }
    return summary;
}

}  // namespace pastoso::project
