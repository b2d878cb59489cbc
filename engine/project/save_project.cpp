#include "brush/preset.hpp"
#include "core/text_file.hpp"
#include "document/action_checks.hpp"
#include "document/painting.hpp"
#include "io/image.hpp"
#include "io/recording_json.hpp"
#include "project/open_raster.hpp"
#include "project/project.hpp"
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

/// Pictures for other programs, as PNG files.
struct Pictures {
    std::string layer, thumbnail;
};

Pictures encoded(const shade::LinearImage& picture, double px_per_mm) {
    return {io::png_file(shade::encode_srgb8(picture), px_per_mm),
            io::png_file(shade::encode_srgb8(thumbnail_of(picture)))};
}

LayerIndex add_layer(const PaintingState& painting, ZipWriter& archive, core::ThreadPool& pool) {
    LayerIndex layer{"Paint", kLayerPicture, surface_index(painting.canvas), {}};
    // A height image of the painter's own may be gone when the file is opened.
    const bool has_name = painting.settings.support != "image";
    layer.surface.entries = add_tiles({painting.canvas, has_name ? &painting.bare_support_mm : nullptr},
                                      kLayerFolder, archive, pool);
    layer.bare_support_checksum = bare_support_checksum(painting.bare_support_mm, layer.surface.entries);
    return layer;
}

ProjectIndex add_painting(const Project& project, ZipWriter& archive, core::ThreadPool& pool) {
    const PaintingState& painting = project.painting;
    ProjectIndex index{.program = PASTOSO_VERSION,
                       .tick = painting.tick,
                       .ageing = painting.ageing,
                       .taken = painting.taken,
                       .wiped = painting.wiped,
                       .forgotten_run_off = painting.forgotten_run_off};
    index.layers.push_back(add_layer(painting, archive, pool));
    if (painting.well) {
        index.well = surface_index(*painting.well);
        index.well->entries = add_tiles({*painting.well}, kWellFolder, archive, pool);
    }
    if (painting.brush) {
        const auto held = std::as_bytes(std::span(painting.brush->held));
        index.brush = {painting.brush->strokes_begun, add_packed(kBrushEntry, held, archive)};
    }
    const std::string strokes = io::recording_to_json(project.strokes);
    index.strokes = add_packed(kStrokesEntry, packing::bytes_of(strokes), archive);
    return index;
}

}  // namespace

/// The pictures' files are made on a thread of their own while the tiles are packed.
ZipWriter project_archive(const Project& project, const shade::LinearImage& picture,
                          core::ThreadPool& pool) {
    const PaintingState& painting = project.painting;
    const double px_per_mm = picture.width / painting.settings.width_mm;
    auto pictures = std::async(std::launch::async, [&] { return encoded(picture, px_per_mm); });
    ZipWriter tiles;
    const ProjectIndex index = add_painting(project, tiles, pool);

    ZipWriter archive;
    archive.add("mimetype", std::string(kMimeType));
    archive.add("stack.xml", stack_xml(picture, px_per_mm, index.layers[0].name, kLayerPicture));
    const Pictures made = pictures.get();
    archive.add("mergedimage.png", made.layer);
    archive.add(kLayerPicture, made.layer);
    archive.add("Thumbnails/thumbnail.png", made.thumbnail);
    archive.add(kIndexEntry, index_to_json(index));
    archive.add(kSetupEntry, io::recording_to_json(setup_of(painting)));
    archive.append(std::move(tiles));
    return archive;
}

void save_project(const std::filesystem::path& path, const Project& project, core::ThreadPool& pool) {
    core::write_aside(path, [&](const std::filesystem::path& temporary) {
        const shade::LinearImage picture =
            open_raster_picture(project.painting.canvas.film, document::kPrimedGround, pool);
        project_archive(project, picture, pool).write(temporary, path.string());
    });
}

bool is_project_path(const std::filesystem::path& path) {
    return path.extension() == ".pastoso";
}

}  // namespace pastoso::project
