#include "brush/preset.hpp"
#include "core/text_file.hpp"
#include "document/action_checks.hpp"
#include "io/image.hpp"
#include "io/recording_json.hpp"
#include "project/mask_bits.hpp"
#include "project/project.hpp"
#include "project/project_archive.hpp"
#include "project/project_index.hpp"
#include "project/project_layout.hpp"
#include "project/surface_tiles.hpp"

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
    add(document::UseMedium{painting.medium});
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

/// The active layer, on the canvas and with the memory of its solver.
LayerIndex add_active(const PaintingState& painting, std::size_t place, ZipWriter& archive,
                      core::ThreadPool& pool) {
    LayerIndex layer{
        painting.layers.layers[place], layer_picture(place), surface_index(painting.canvas), {}};
    layer.surface.entries =
        add_tiles({painting.canvas, &painting.bare_support_mm}, layer_folder(place), archive, pool);
    if (painting.settings.support != "image")
        layer.bare_support_checksum =
            bare_support_checksum(painting.bare_support_mm, layer.surface.entries);
    return layer;
}

LayerIndex add_asleep(const document::Layer& layer, std::size_t place, ZipWriter& archive,
                      core::ThreadPool& pool) {
    const document::SurfaceState surface{*layer.asleep, {}};
    LayerIndex index{layer, layer_picture(place), surface_index(surface), {}};
    index.surface.entries = add_tiles({surface}, layer_folder(place), archive, pool);
    return index;
}

void add_layers(const PaintingState& painting, ProjectIndex& index, ZipWriter& archive,
                core::ThreadPool& pool) {
    const document::LayerStack& stack = painting.layers;
    index.groups = stack.groups;
    index.active_layer = stack.active;
    index.next_layer = stack.next_layer;
    index.next_group = stack.next_group;
    for (std::size_t place = 0; place < stack.layers.size(); ++place)
        index.layers.push_back(place == stack.active
                                   ? add_active(painting, place, archive, pool)
                                   : add_asleep(stack.layers[place], place, archive, pool));
}

/// A height image of the painter's own may be gone when the file is opened.
void add_bare_support(const PaintingState& painting, ProjectIndex& index, ZipWriter& archive,
                      core::ThreadPool& pool) {
    if (painting.settings.support != "image") return;
    const film::FilmState& canvas = painting.canvas.film;
    document::SurfaceState bare{film::FilmState(canvas.shape, canvas.cell_mm), {}};
    bare.film.support_mm = painting.bare_support_mm;
    index.bare_support = surface_index(bare);
    index.bare_support->entries = add_tiles({bare}, kBareSupportFolder, archive, pool);
}

/// Of a support that has a name, no tile of which is background.
ProjectIndex add_painting(const Project& project, ZipWriter& archive, core::ThreadPool& pool) {
    const PaintingState& painting = project.painting;
    ProjectIndex index{.program = PASTOSO_VERSION,
                       .tick = painting.tick,
                       .ageing = painting.ageing,
                       .taken = painting.taken,
                       .wiped = painting.wiped,
                       .forgotten_run_off = painting.forgotten_run_off};
    add_layers(painting, index, archive, pool);
    add_bare_support(painting, index, archive, pool);
    index.support_form = film::form_of(painting.bare_support_mm);
    if (painting.well) {
        index.well = surface_index(*painting.well);
        index.well->entries = add_tiles({*painting.well}, kWellFolder, archive, pool);
    }
    if (painting.brush) {
        const auto held = std::as_bytes(std::span(painting.brush->held));
        index.brush = {painting.brush->strokes_begun, add_packed(kBrushEntry, held, archive)};
    }
    if (painting.selection)
        index.selection = add_packed(kSelectionEntry, mask_bits(*painting.selection), archive);
    if (painting.tracing) {
        const layers::Tracing& tracing = *painting.tracing;
        index.tracing = {tracing.place, tracing.opacity};
        archive.add(kTracingEntry, io::png_file(*tracing.picture));
    }
    const std::string strokes = io::recording_to_json(project.strokes);
    index.strokes = add_packed(kStrokesEntry, packing::bytes_of(strokes), archive);
    return index;
}

}  // namespace

/// The pictures' files are made on a thread of their own while the tiles are packed.
ZipWriter project_archive(const Project& project, const Pictures& pictures, core::ThreadPool& pool) {
    auto files = std::async(std::launch::async, [&] { return picture_files(pictures); });
    ZipWriter tiles;
    const ProjectIndex index = add_painting(project, tiles, pool);

    ZipWriter archive;
    archive.add("mimetype", std::string(kMimeType));
    archive.add("stack.xml", stack_xml(pictures));
    for (auto& [entry, content] : files.get())
        archive.add(entry, content);
    archive.add(kIndexEntry, index_to_json(index));
    archive.add(kSetupEntry, io::recording_to_json(setup_of(project.painting)));
    archive.append(std::move(tiles));
    return archive;
}

void save_project(const std::filesystem::path& path, const Project& project, core::ThreadPool& pool) {
    core::write_aside(path, [&](const std::filesystem::path& temporary) {
        const Pictures pictures = pictures_of(project.painting, pool);
        project_archive(project, pictures, pool).write(temporary, path.string());
    });
}

bool is_project_path(const std::filesystem::path& path) {
    return path.extension() == ".pastoso";
}

}  // namespace pastoso::project
