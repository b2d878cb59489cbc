#include "screen/raster_picture.hpp"

#include "screen/damaged_pixels.hpp"
#include "screen/qt_rect.hpp"
#include "screen/quality.hpp"
#include "screen/raster_finish.hpp"
#include "screen/sheet_painter.hpp"
#include "shade/cell_span.hpp"

#include <algorithm>
#include <cmath>

#include <QElapsedTimer>
#include <QPainter>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::screen {
namespace {

/// The layers of so many cells are made at once.
constexpr double kCellsAtOnce = 1 << 22;

/// A picture of every third frame of a screen of 60 Hz still follows the hand; while that moves, more
/// than a quarter of a frame would be taken from the paint that it lays.
constexpr double kMostWork_s = 0.025, kQuickWork_s = 0.004;

/// Pixels for each cell below which a draft has no relief.
constexpr double kFlatZoom = 0.25;

/// Of canvases up to so large the layers are kept: 28 bytes a cell.
constexpr double kMostCellsKept = 12e6;

/// Layers are kept of so many cells beyond the canvas, too: a pixel at its edge reaches over it.
constexpr int kKeptAround = 2 * shade::kLayersAround;

/// All cells that a picture of these pixels needs the layers of, and a few more.
grid::Rect cells_needed(const CanvasSheet& sheet, const grid::Rect& pixels) {
    const shade::Lattice& lattice = sheet.lattice;
    const auto cell = [](double origin, int pixel, double scale) {
        return static_cast<int>(std::floor(origin + pixel / scale));
    };
    return shade::grown({cell(lattice.left_cells, pixels.x0, lattice.scale_x),
                         cell(lattice.top_cells, pixels.y0, lattice.scale_y),
                         cell(lattice.left_cells, pixels.x1, lattice.scale_x) + 1,
                         cell(lattice.top_cells, pixels.y1, lattice.scale_y) + 1},
                        shade::kLayersAround);
}

/// `work(strip)` for strips below which are not too many cells.
template <class Work>
void for_strips(const grid::Rect& pixels, const CanvasSheet& sheet, const Work& work) {
    const double cells_a_row = pixels.width() / (sheet.lattice.scale_x * sheet.lattice.scale_y);
    const int rows = std::max(1, static_cast<int>(kCellsAtOnce / cells_a_row));
    for (int y = pixels.y0; y < pixels.y1; y += rows)
        work(grid::Rect{pixels.x0, y, pixels.x1, std::min(y + rows, pixels.y1)});
}

/// `paint(pixels)` gives the picture of pixels of the sheet.
template <class Paint>
void paint_part(QImage& image, const QRect& part, const CanvasSheet& sheet, bool upright,
                const Paint& paint) {
    const grid::Rect pixels = sheet.pixels_below(part);
    if (pixels.empty()) return;
    for_strips(pixels, sheet, [&](const grid::Rect& strip) {
        const QImage picture = paint(strip);
        QPainter onto(&image);
        onto.setClipRect(part);
        onto.setRenderHint(QPainter::SmoothPixmapTransform, !upright);
        onto.setTransform(sheet.to_window);
        onto.drawImage(QPoint(strip.x0, strip.y0), picture);
    });
}

/// Pieces of a region that are nowhere long, as those of a canvas that lies askew would be wide.
std::vector<QRect> squares_of(const QRegion& region) {
    constexpr int kSide_px = 64;
    std::vector<QRect> squares;
    for (const QRect& part : region)
        for (int y = part.top(); y <= part.bottom(); y += kSide_px)
            for (int x = part.left(); x <= part.right(); x += kSide_px)
                squares.push_back(part & QRect(x, y, kSide_px, kSide_px));
    return squares;
}

bool same_canvas(const film::FilmState& a, const film::FilmState& b) {
    return a.shape == b.shape && a.cell_mm == b.cell_mm;
}

bool same_finish(const RasterScene& a, const RasterScene& b) {
    return a.colours == b.colours && a.squint_px == b.squint_px;
}

/// Whether the layers of unchanged cells are those of before.
bool same_layers(const Sight& a, const Sight& b) {
    return a.viewing.to_rgb == b.viewing.to_rgb && a.lighting.azimuth_deg == b.lighting.azimuth_deg &&
           a.lighting.elevation_deg == b.lighting.elevation_deg;
}

}  // namespace

bool RasterPicture::show(const RasterScene& scene, core::ThreadPool& pool) {
    const auto seen = ground_.below(scene.sight.painting, scene.sight.tracing, pool);
    if (seen_ != nullptr && !same_canvas(seen_->film, seen->film)) seen_.reset();
    if (seen_ == nullptr) light_.reset();
    const double scale_before_mm = scale_top_mm_;
    const std::vector<int> tiles = changed_tiles(seen_.get(), *seen);
    measure_heights(scene, *seen, tiles, pool);
    const QRegion cells = changed_cells(scene, *seen, tiles);
    update_layers(scene, *seen, cells, pool);
    if (light_ && same_light(*light_, scene.sight))
        far_.forget(cells);
    else
        far_.begin(seen->film.shape);
    if (scale_top_mm_ != scale_before_mm) scene_.reset();
    const QRegion region = changed_pixels(scene, cells);
    const std::optional<glm::ivec2> moved = way_moved(scene);
    const bool finished_anew = moved || (scene_ && !same_finish(*scene_, scene));
    if (image_.size() != scene.window_px) {
        canvas_ = QImage(scene.window_px, QImage::Format_RGBX64);
        image_ = QImage(scene.window_px, QImage::Format_RGB32);
    } else if (moved) {
        move_by(*moved);
    }
    light_ = scene.sight;
    scene_ = scene;
    seen_ = seen;
    const QRegion known = known_from_afar(region);
    const QRegion rest = region - known;
    paint(known, Quality::Full, pool);
    const Quality quality = affordable_quality(rest);
    paint_measured(rest, quality, pool);
    if (finished_anew) finish(image_.rect(), scene, pool);
    finish_for_squint(pool);
    return quality != Quality::Full;
}

/// From afar, and where cells are large, none between has fewer samples: a draft would be made twice.
Quality RasterPicture::affordable_quality(const QRegion& region) const {
    const auto takes_s = [&](Quality quality) { return budget_.expected_s(work_of(region, quality)); };
    const double zoom = scene_->view.zoom;
    const bool fair_is_less = !seen_from_afar() && samples_per_pixel(Quality::Fair, zoom) <
                                                       samples_per_pixel(Quality::Full, zoom);
    if (takes_s(Quality::Full) <= (fair_is_less ? kQuickWork_s : kMostWork_s)) return Quality::Full;
    const bool fair = fair_is_less && takes_s(Quality::Fair) <= kMostWork_s;
    return fair ? Quality::Fair : Quality::Plain;
}

/// A pixel's samples or, where that is more and no layers are kept, the cells below it.
double RasterPicture::work_per_pixel(Quality quality) const {
    const double zoom = scene_->view.zoom, cells = 1.0 / (zoom * zoom);
    const double samples = seen_from_afar()
                               ? samples_per_pixel(Quality::Full, kFarZoom) * kFarZoom * kFarZoom * cells
                               : samples_per_pixel(quality, zoom);
    return layers_.cells.empty() ? std::max(samples, cells) : samples;
}

double RasterPicture::work_of(const QRegion& region, Quality quality) const {
    double pixels = 0.0;
    for (const QRect& part : region)
        pixels += 1.0 * part.width() * part.height();
    return pixels * work_per_pixel(quality);
}

/// By which whole pixels the picture that is there is moved along; none: it is not.
std::optional<glm::ivec2> RasterPicture::way_moved(const RasterScene& scene) const {
    if (!scene_ || scene_->view == scene.view || !same_but_for_view(*scene_, scene)) return std::nullopt;
    return whole_pixels_between(scene_->view, scene.view);
}

void RasterPicture::move_by(const glm::ivec2& pixels) {
    QImage moved(canvas_.size(), canvas_.format());
    QPainter onto(&moved);
    onto.setCompositionMode(QPainter::CompositionMode_Source);
    onto.drawImage(QPoint(pixels.x, pixels.y), canvas_);
    onto.end();
    canvas_ = moved;
    draft_.translate(pixels.x, pixels.y);
    draft_ &= canvas_.rect();
}

bool RasterPicture::seen_from_afar() const {
    const Look look = scene_->sight.look;
    return scene_->view.zoom <= kFarZoom && (look == Look::Lit || look == Look::Flat);
}

/// Of a part of the window, what of it can be drawn as the canvas is known from afar.
QRegion RasterPicture::known_from_afar(const QRegion& region) const {
    QRegion known;
    if (!seen_from_afar()) return known;
    for (const QRect& part : squares_of(region))
        if (far_.missing(scene_->view, part).isEmpty()) known += part;
    return known;
}

void RasterPicture::paint(const QRegion& region, Quality quality, core::ThreadPool& pool) {
    if (quality == Quality::Full && seen_from_afar())
        paint_from_afar(region, pool);
    else
        paint_sheet(region, quality, pool);
    for (const QRect& part : region)
        finish(part, *scene_, pool);
    draft_ = quality == Quality::Full ? draft_ - region : draft_ + region;
    draft_ &= QRect(QPoint(0, 0), scene_->window_px);
}

void RasterPicture::paint_measured(const QRegion& region, Quality quality, core::ThreadPool& pool) {
    QElapsedTimer timer;
    timer.start();
    paint(region, quality, pool);
    if (quality != Quality::Plain)
        budget_.measured(work_of(region, quality), 1e-9 * static_cast<double>(timer.nsecsElapsed()));
}

/// The renderer would look for the canvas's highest place each time.
template <class Paint>
void RasterPicture::with_layers(const CanvasSheet& sheet, const grid::Rect& pixels,
                                core::ThreadPool& pool, const Paint& paint) const {
    const grid::Rect needed = cells_needed(sheet, pixels);
    const bool kept = grid::intersection(layers_.cells, needed) == needed;
    if (kept || scene_->sight.look == Look::Height) return paint(layers_);
    paint(shade::cell_layers(seen_->film, seen_->ground, needed, scene_->sight.lighting, range_, pool,
                             scene_->sight.viewing.to_rgb));
}

void RasterPicture::paint_sheet(const QRegion& region, Quality quality, core::ThreadPool& pool) {
    const CanvasSheet sheet(seen_->film.shape, scene_->view);
    const bool flat = layers_.cells.empty() && scene_->sight.look == Look::Lit &&
                      scene_->view.zoom < kFlatZoom && quality != Quality::Full;
    const auto paint_pixels = [&](const grid::Rect& pixels) {
        if (flat) return flat_picture(*scene_, *seen_, sheet, pixels, pool);
        QImage picture;
        with_layers(sheet, pixels, pool, [&](const shade::CellLayers& layers) {
            picture =
                SheetPainter(*scene_, *seen_, sheet, scale_top_mm_, quality, layers, pool).paint(pixels);
        });
        return picture;
    };
    for (const QRect& part : region)
        paint_part(canvas_, part, sheet, scene_->view.upright(), paint_pixels);
}

void RasterPicture::paint_from_afar(const QRegion& region, core::ThreadPool& pool) {
    QRegion missing;
    for (const QRect& part : squares_of(region))
        missing += far_.missing(scene_->view, part);
    const CanvasSheet sheet(seen_->film.shape, FarPicture::view());
    for (const QRect& part : missing)
        for_strips(cell_rect(part), sheet, [&](const grid::Rect& pixels) {
            with_layers(sheet, pixels, pool, [&](const shade::CellLayers& layers) {
                const SheetPainter painter(*scene_, *seen_, sheet, scale_top_mm_, Quality::Full, layers,
                                           pool);
                far_.put(pixels, painter.light(pixels), pool);
            });
        });
    for (const QRect& part : region)
        far_.draw(scene_->view, part, canvas_, pool);
}

void RasterPicture::refine(core::ThreadPool& pool) {
    if (!is_draft()) return;
    paint_measured(draft_ & next_strip(), Quality::Full, pool);
    finish_for_squint(pool);
}

QRect RasterPicture::next_strip() const {
    QRect strip = draft_.boundingRect();
    const double rows =
        budget_.affordable_samples(kMostWork_s) / (work_per_pixel(Quality::Full) * strip.width());
    strip.setHeight(static_cast<int>(std::clamp(rows, 1.0, static_cast<double>(strip.height()))));
    return strip;
}

/// Of the layers; all of them at first, and where the light is another.
QRegion RasterPicture::changed_cells(const RasterScene& scene, const document::Snapshot& seen,
                                     const std::vector<int>& tiles) {
    const shade::HeightRange before = range_;
    ranges_.update(seen.film, tiles);
    range_ = ranges_.all();
    if (!light_ || !same_layers(*light_, scene.sight))
        return qt_rect(shade::grown(seen.film.shape.cells(), kKeptAround));
    return relief_region(seen.film, tiles, scene.sight.lighting, united(before, range_), kKeptAround);
}

void RasterPicture::update_layers(const RasterScene& scene, const document::Snapshot& seen,
                                  const QRegion& changed, core::ThreadPool& pool) {
    const grid::Rect all = shade::grown(seen.film.shape.cells(), kKeptAround);
    if (static_cast<double>(all.width()) * all.height() > kMostCellsKept) {
        layers_ = {};
        return;
    }
    if (layers_.cells != all) layers_ = shade::CellLayers(all);
    std::vector<grid::Rect> parts;
    for (const QRect& part : changed)
        parts.push_back(cell_rect(part));
    fill_layers(seen.film, seen.ground, parts, scene.sight.lighting, range_, pool,
                scene.sight.viewing.to_rgb, layers_);
}

/// A picture from afar reaches two of its pixels farther.
QRegion RasterPicture::changed_pixels(const RasterScene& scene, const QRegion& changed_cells) const {
    const QRegion window(QRect(QPoint(0, 0), scene.window_px));
    if (seen_ == nullptr || !scene_) return window;
    QRegion changed;
    if (!same_place(*scene_, scene)) {
        const std::optional<glm::ivec2> moved = way_moved(scene);
        if (!moved) return window;
        changed = window - window.translated(moved->x, moved->y);
    }
    const int reach =
        scene.view.zoom <= kFarZoom ? static_cast<int>(std::ceil(2.0 / scene.view.zoom)) : 0;
    for (const QRect& part : changed_cells)
        changed += damaged_pixels(scene.view, part.adjusted(-reach, -reach, reach, reach));
    return changed & window;
}

/// For half-closed eyes all of it is made anew, once it is painted.
void RasterPicture::finish(const QRect& part, const RasterScene& scene, core::ThreadPool& pool) {
    if (scene.squint_px > 0.0) {
        changed_ = image_.rect();
        return;
    }
    changed_ += part;
    finish_part(canvas_, part, scene, pool, image_);
}

void RasterPicture::finish_for_squint(core::ThreadPool& pool) {
    if (scene_->squint_px > 0.0 && !changed_.isEmpty()) finish_squinted(canvas_, *scene_, pool, image_);
}

void RasterPicture::measure_heights(const RasterScene& scene, const document::Snapshot& seen,
                                    const std::vector<int>& changed, core::ThreadPool& pool) {
    if (scene.sight.look != Look::Height) return;
    const bool begins = !light_ || light_->look != Look::Height;
    const std::vector<int> tiles = begins ? changed_tiles(nullptr, seen) : changed;
    const double now_mm = highest_mm(look_patches(seen, Look::Height, tiles, pool));
    highest_mm_ = begins ? now_mm : std::max(highest_mm_, now_mm);
    scale_top_mm_ = screen::scale_top_mm(highest_mm_);
}

}  // namespace pastoso::screen
