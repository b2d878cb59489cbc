#include "recordings/painting_export.hpp"

#include "core/error.hpp"
#include "document/layered_canvas.hpp"
#include "document/painting.hpp"
#include "document/well.hpp"
#include "files/file_access.hpp"
#include "recordings/layer_export.hpp"
#include "recordings/picture_export.hpp"
#include "recordings/relief_export.hpp"

#include <optional>

namespace pastoso::recordings {
namespace {

using document::PaintingState;
using film::FilmState;

/// The share of a relief's time that goes by before its file is begun.
constexpr double kSampling = 0.5;

void check_relief_path(const std::filesystem::path& path) {
    if (!is_relief_path(path)) {
        throw core::InputError(
            "%1: a relief is saved as .stl, .ply or .obj; this name ends in none of them.",
            path.string());
    }
    files::check_writable(path);
}

FilmState seen_film(const PaintingState& painting, const ExportChoice& choice, core::ThreadPool& pool) {
    if (choice.of_well) return painting.value.well ? *painting.value.well : document::bare_well();
    return document::view_of(painting.value.film, painting.value.bare->support_mm, painting.value.layers,
                             pool);
}

ExportSource source_of(const FilmState& film, const ExportChoice& choice, const PictureStyle& style) {
    shade::RenderSettings settings;
    settings.scale = choice.scale;
    const shade::Varnish varnish = choice.lit ? choice.varnish : shade::Varnish{};
    settings.lighting = shade::varnished(choice.lighting, varnish);
    settings.viewing = shade::varnished(style.viewing, varnish);
    return {film, document::kPrimedGround, settings, choice.lit};
}

files::ExportStatus write_pictures(const PaintingState& painting, const ExportChoice& choice,
                                   const FilmState& film, core::ThreadPool& pool,
                                   const files::KeepGoing& keep_going, ExportReport& report) {
    const PictureStyle style = picture_style(choice.picture);
    const ExportSource source = source_of(film, choice, style);
    const shade::Lattice lattice = export_lattice(source);
    report.width_px = lattice.width;
    report.height_px = lattice.height;
    if (choice.kind == ExportKind::Picture)
        return export_picture(choice.path, source, style.encoding, pool, keep_going);
    if (choice.kind == ExportKind::Layers) {
        return export_layers(
            choice.path, source,
            channel_layers(painting.value.film, painting.value.bare->support_mm, painting.value.layers),
            pool, keep_going);
    }
    report.files = map_paths(choice.path);
    return export_maps(choice.path, source, style.encoding, pool, keep_going, &report.heights);
}

files::ExportStatus write_relief(const ExportChoice& choice, const FilmState& film,
                                 core::ThreadPool& pool, const files::KeepGoing& keep_going,
                                 ExportReport& report) {
    const auto sampling = [&](double done) { return keep_going(kSampling * done); };
    const auto writing = [&](double done) { return keep_going(kSampling + (1.0 - kSampling) * done); };
    const std::optional<Relief> relief = relief_of(film, choice.relief, pool, sampling);
    if (!relief) return files::ExportStatus::Stopped;
    report.triangles = relief->triangle_count();
    return export_relief(choice.path, *relief, writing);
}

}  // namespace

ExportedCells exported_cells(const ExportedCells& canvas, const ExportChoice& choice) {
    if (!choice.of_well) return canvas;
    const FilmState well = document::bare_well();
    return {well.shape, well.cell_mm};
}

grid::Shape export_size(const ExportedCells& canvas, const ExportChoice& choice) {
    const ExportedCells cells = exported_cells(canvas, choice);
    if (choice.kind == ExportKind::Relief) {
        const ReliefGrid grid = relief_grid(cells.shape, cells.cell_mm, choice.relief);
        return {grid.columns, grid.rows};
    }
    const shade::Lattice lattice =
        shade::picture_lattice(cells.shape, cells.shape.cells(), choice.scale);
    files::check_picture_size(choice.path, lattice.width, lattice.height);
    return {lattice.width, lattice.height};
}

void check_export(const ExportChoice& choice) {
    if (choice.kind == ExportKind::Relief) return check_relief_path(choice.path);
    const files::PictureEncoding encoding = picture_style(choice.picture).encoding;
    if (choice.kind == ExportKind::Maps) return check_map_paths(choice.path, encoding);
    files::check_picture_path(choice.path, encoding);
    if (choice.kind == ExportKind::Layers && !files::is_linear_format(choice.path))
        throw core::InputError("%1: only .exr files hold layers.", choice.path.string());
}

ExportReport export_painting(const PaintingState& painting, const ExportChoice& choice,
                             core::ThreadPool& pool, const files::KeepGoing& keep_going) {
    check_export(choice);
    const FilmState film = seen_film(painting, choice, pool);
    ExportReport report;
    report.files = {choice.path};
    report.width_mm = film.shape.width * film.cell_mm;
    report.height_mm = film.shape.height * film.cell_mm;
    report.status = choice.kind == ExportKind::Relief
                        ? write_relief(choice, film, pool, keep_going, report)
                        : write_pictures(painting, choice, film, pool, keep_going, report);
    return report;
}

}  // namespace pastoso::recordings
