#include "screen/raster_picture.hpp"

#include "pigment/colour.hpp"
#include "screen/damaged_pixels.hpp"
#include "screen/dither.hpp"
#include "screen/qt_rect.hpp"
#include "screen/quality.hpp"
#include "screen/window_pixels.hpp"
#include "shade/cell_span.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QPainter>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace pastoso::screen {
namespace {

/// The layers of so many cells are made at once.
constexpr double kCellsAtOnce = 1 << 22;

/// Samples, or cells whose layers are made, that take some hundredths of a second.
constexpr double kMostWork = 2e6;

/// Pixels for each cell below which a draft has no relief.
constexpr double kFarZoom = 0.25;

/// Of canvases up to so large the layers are kept: 28 bytes a cell.
constexpr double kMostCellsKept = 12e6;

/// The canvas in its own orientation, as large as it is seen. Where it stands upright in the window,
/// the sheet's pixels are the window's.
struct Sheet {
    shade::Lattice lattice;
    QTransform to_window;  ///< from its pixels

    Sheet(const grid::Shape& canvas, const ViewTransform& view);

    /// The pixels below a rectangle of the window.
    grid::Rect pixels_below(const QRect& window) const;
};

Sheet::Sheet(const grid::Shape& canvas, const ViewTransform& view) {
    const glm::dmat2 axes = view.axes();
    const glm::dvec2 along_axes = glm::transpose(axes) * view.origin_px;
    // Of the canvas's corner from the sheet's.
    const glm::dvec2 shift_px = along_axes - glm::floor(along_axes);
    lattice = {-shift_px.x / view.zoom,
               -shift_px.y / view.zoom,
               view.zoom,
               view.zoom,
               static_cast<int>(std::ceil(canvas.width * view.zoom + shift_px.x)),
               static_cast<int>(std::ceil(canvas.height * view.zoom + shift_px.y))};
    const glm::dvec2 corner = axes * glm::floor(along_axes);
    to_window = {axes[0].x, axes[0].y, axes[1].x, axes[1].y, corner.x, corner.y};
}

grid::Rect Sheet::pixels_below(const QRect& window) const {
    const QRectF part = to_window.inverted().mapRect(QRectF(window));
    const grid::Rect pixels{
        static_cast<int>(std::floor(part.left())) - 1, static_cast<int>(std::floor(part.top())) - 1,
        static_cast<int>(std::ceil(part.right())) + 1, static_cast<int>(std::ceil(part.bottom())) + 1};
    return grid::intersection(pixels, {0, 0, lattice.width, lattice.height});
}

constexpr double kMost16 = 65535.0;

QRgba64 encoded(const glm::dvec3& colour) {
    const glm::dvec3 levels = glm::floor(kMost16 * glm::clamp(colour, 0.0, 1.0) + 0.5);
    return qRgba64(static_cast<quint16>(levels.r), static_cast<quint16>(levels.g),
                   static_cast<quint16>(levels.b), 0xFFFF);
}

pigment::EncodedRgb colour_of(const QRgba64& pixel) {
    constexpr auto kMost = static_cast<float>(kMost16);
    return {static_cast<float>(pixel.red()) / kMost, static_cast<float>(pixel.green()) / kMost,
            static_cast<float>(pixel.blue()) / kMost};
}

QRgb dithered_pixel(const pigment::EncodedRgb& colour, int x, int y) {
    const float threshold = dither_threshold(x, y);
    return qRgb(dithered(colour[0], threshold), dithered(colour[1], threshold),
                dithered(colour[2], threshold));
}

glm::dvec3 vec3(const Rgb& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

/// Over the lit picture or in its place, what a look shows at one pixel.
struct LookPixels {
    const document::Snapshot& seen;
    Look look;
    double scale_top_mm;
    const Sheet& sheet;
    const grid::Rect& pixels;

    double thickness_mm(int x, int y) const {
        const shade::Lattice& lattice = sheet.lattice;
        const auto cell = [](double first, int pixel, double scale, int cells) {
            return std::clamp(static_cast<int>(std::floor(first + (pixel + 0.5) / scale)), 0, cells - 1);
        };
        const grid::Shape& shape = seen.film.shape;
        return look_thickness_mm(seen, look,
                                 cell(lattice.left_cells, pixels.x0 + x, lattice.scale_x, shape.width),
                                 cell(lattice.top_cells, pixels.y0 + y, lattice.scale_y, shape.height));
    }

    QRgba64 height_at(int x, int y) const {
        const double step = std::floor(kHeightSteps * thickness_mm(x, y) / scale_top_mm);
        return encoded(vec3(kHeightColours[std::clamp(static_cast<int>(step), 0, kHeightSteps - 1)]));
    }

    QRgba64 wet_at(int x, int y, float luminance) const {
        const double grey = kGreyShare * pigment::encode_srgb(std::clamp(luminance, 0.0F, 1.0F));
        return encoded(glm::mix(glm::dvec3(grey), vec3(kWetTint), wet_tint(thickness_mm(x, y))));
    }
};

QRgba64 normal_of(const shade::SurfaceSample& sample) {
    return encoded(0.5 + 0.5 * glm::normalize(glm::dvec3(-sample.slope_x, sample.slope_y, 1.0)));
}

/// `pixel(x, y, index)` for all pixels of a picture.
template <class Pixel>
QImage made_of(int width, int height, const Pixel& pixel) {
    QImage image(width, height, QImage::Format_RGBX64);
    std::size_t index = 0;
    for (int y = 0; y < height; ++y) {
        auto* line = reinterpret_cast<QRgba64*>(image.scanLine(y));
        for (int x = 0; x < width; ++x, ++index)
            line[x] = pixel(x, y, index);
    }
    return image;
}

/// The curve of sRGB to 16 bits, between the entries of a table over roots: there it is nearly straight.
class Encoder {
  public:
    Encoder() {
        for (int i = 0; i <= kSteps + 1; ++i) {
            const double root = std::min(1.0, static_cast<double>(i) / kSteps);
            values_[i] = static_cast<float>(kMost16 * pigment::encode_srgb(root * root));
        }
    }

    /// Of a value in [0, 1].
    quint16 operator()(float linear) const {
        const float along = kSteps * std::sqrt(linear);
        const int step = static_cast<int>(along);
        const float share = along - static_cast<float>(step);
        return static_cast<quint16>(values_[step] + share * (values_[step + 1] - values_[step]) + 0.5F);
    }

  private:
    static constexpr int kSteps = 2048;
    std::array<float, kSteps + 2> values_{};
};

/// As pigment::encode_srgb16() does it, to a level.
QImage as_image(const pigment::LinearImage& picture, core::ThreadPool& pool) {
    static const Encoder encode;
    QImage image(picture.width, picture.height, QImage::Format_RGBX64);
    uchar* const first = image.bits();
    pool.run(static_cast<std::size_t>(picture.height), [&](std::size_t y, int) {
        auto* line =
            reinterpret_cast<QRgba64*>(first + static_cast<qsizetype>(y) * image.bytesPerLine());
        const float* rgb = picture.rgb.data() + 3 * y * static_cast<std::size_t>(picture.width);
        for (int x = 0; x < picture.width; ++x, rgb += 3) {
            const pigment::LinearRgb fitting =
                pigment::into_gamut({rgb[0], rgb[1], rgb[2]}, picture.space);
            line[x] = qRgba64(encode(fitting[0]), encode(fitting[1]), encode(fitting[2]), 0xFFFF);
        }
    });
    return image;
}

/// Makes parts of the sheet.
class SheetPainter {
  public:
    SheetPainter(const RasterScene& scene, const document::Snapshot& seen, const Sheet& sheet,
                 double scale_top_mm, Quality quality, const shade::CellLayers& layers,
                 core::ThreadPool& pool)
        : seen_(seen),
          sheet_(sheet),
          look_(scene.sight.look),
          scale_top_mm_(scale_top_mm),
          space_(scene.sight.viewing.space),
          pool_(pool),
          renderer_(seen.film, seen.ground, sheet.lattice,
                    {.lighting = scene.sight.lighting,
                     .viewing = scene.sight.viewing,
                     .outlined = has_outlines(scene.sight.look),
                     .most_samples = samples_per_side(quality, scene.view.zoom),
                     .layers = layers.cells.empty() ? nullptr : &layers},
                    pool) {}

    QImage paint(const grid::Rect& pixels) const {
        pigment::LinearImage lit;
        shade::SurfaceSamples surface;
        const bool wants_lit = look_ == Look::Lit || look_ == Look::Wet;
        const bool wants_surface = look_ == Look::Normals || look_ == Look::Flat;
        if (wants_lit || wants_surface)
            renderer_.render(pixels, wants_lit ? &lit : nullptr, wants_surface ? &surface : nullptr);
        const LookPixels shown{seen_, look_, scale_top_mm_, sheet_, pixels};
        const auto weights = pigment::luminance_weights(space_);
        switch (look_) {
            case Look::Lit:
                return as_image(lit, pool_);
            case Look::Flat:
                return as_image(colours(surface), pool_);
            case Look::Wet:
                return made_of(pixels.width(), pixels.height(), [&](int x, int y, std::size_t i) {
                    const float* rgb = lit.rgb.data() + 3 * i;
                    return shown.wet_at(x, y,
                                        weights[0] * rgb[0] + weights[1] * rgb[1] + weights[2] * rgb[2]);
                });
            case Look::Normals:
                return made_of(pixels.width(), pixels.height(),
                               [&](int, int, std::size_t i) { return normal_of(surface.samples[i]); });
            case Look::Height:
                return made_of(pixels.width(), pixels.height(),
                               [&](int x, int y, std::size_t) { return shown.height_at(x, y); });
        }
        return {};
    }

  private:
    pigment::LinearImage colours(const shade::SurfaceSamples& surface) const {
        pigment::LinearImage image{surface.width, surface.height, {}, space_};
        image.rgb.reserve(3 * surface.samples.size());
        for (const shade::SurfaceSample& sample : surface.samples)
            image.rgb.insert(image.rgb.end(), {sample.red, sample.green, sample.blue});
        return image;
    }

    const document::Snapshot& seen_;
    const Sheet& sheet_;
    Look look_;
    double scale_top_mm_;
    pigment::WorkingSpace space_;
    core::ThreadPool& pool_;
    shade::Renderer renderer_;
};

/// The layers of a flat surface with a cell for each pixel, in the colour of one cell below it.
shade::CellLayers flat_layers(const RasterScene& scene, const document::Snapshot& seen,
                              const Sheet& sheet, const grid::Rect& pixels, core::ThreadPool& pool) {
    constexpr float kNoShadow_mm = -1e3F;
    shade::CellLayers flat(shade::grown({0, 0, pixels.width(), pixels.height()}, shade::kLayersAround));
    std::fill(flat.shadow_mm.begin(), flat.shadow_mm.end(), kNoShadow_mm);
    std::fill(flat.sky.begin(), flat.sky.end(), 1.0F);
    const shade::Lattice& lattice = sheet.lattice;
    const grid::Shape& shape = seen.film.shape;
    pool.run(static_cast<std::size_t>(flat.cells.height()), [&](std::size_t row, int) {
        const int y = flat.cells.y0 + static_cast<int>(row);
        const int cell_y =
            std::clamp(static_cast<int>(lattice.top_cells + (pixels.y0 + y + 0.5) / lattice.scale_y), 0,
                       shape.height - 1);
        for (int x = flat.cells.x0; x < flat.cells.x1; ++x) {
            const int cell_x = std::clamp(
                static_cast<int>(lattice.left_cells + (pixels.x0 + x + 0.5) / lattice.scale_x), 0,
                shape.width - 1);
            shade::cell_colours(seen.film, {cell_x, cell_y, cell_x + 1, cell_y + 1}, seen.ground,
                                &flat.colour[static_cast<std::size_t>(flat.index(x, y))], 1,
                                scene.sight.viewing.to_rgb);
        }
    });
    return flat;
}

/// The first draft of a huge canvas from far away: its colours in that light, without any relief, which
/// would be found for thousands of cells a pixel.
QImage flat_picture(const RasterScene& scene, const document::Snapshot& seen, const Sheet& sheet,
                    const grid::Rect& pixels, core::ThreadPool& pool) {
    const shade::CellLayers flat = flat_layers(scene, seen, sheet, pixels, pool);
    const grid::Rect all{0, 0, pixels.width(), pixels.height()};
    const shade::Renderer renderer(seen.film, seen.ground, {0.0, 0.0, 1.0, 1.0, all.x1, all.y1},
                                   {.lighting = scene.sight.lighting,
                                    .viewing = scene.sight.viewing,
                                    .outlined = false,
                                    .most_samples = 1,
                                    .layers = &flat},
                                   pool);
    pigment::LinearImage lit;
    renderer.render(all, &lit, nullptr);
    return as_image(lit, pool);
}

/// The ground with the soft shadow of the canvas's edge, as the canvas's shader draws it; none within
/// the canvas.
std::optional<pigment::EncodedRgb> ground_at(const RasterScene& scene, const glm::dvec2& px) {
    constexpr double kReach_px = 9.0, kDarkest = 0.45;
    const grid::Shape& shape = scene.sight.painting->film.shape;
    const glm::dvec2 cells{shape.width, shape.height};
    const glm::dvec2 cell = scene.view.cell_from_device(px);
    const glm::dvec2 outside_px =
        scene.view.zoom * glm::max(glm::max(-cell, cell - cells), glm::dvec2(0.0));
    if (outside_px == glm::dvec2(0.0)) return std::nullopt;
    const double shadow = kDarkest * std::exp(-glm::length(outside_px) / kReach_px);
    pigment::EncodedRgb colour = scene.ground;
    for (float& value : colour)
        value *= static_cast<float>(1.0 - shadow);
    return colour;
}

/// All cells that a picture of these pixels needs the layers of, and a few more.
grid::Rect cells_needed(const Sheet& sheet, const grid::Rect& pixels) {
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

/// `paint(pixels)` gives the picture of pixels of the sheet.
template <class Paint>
void paint_part(QImage& image, const QRect& part, const Sheet& sheet, bool upright, const Paint& paint) {
    const grid::Rect pixels = sheet.pixels_below(part);
    if (pixels.empty()) return;
    const double cells_a_row = pixels.width() / (sheet.lattice.scale_x * sheet.lattice.scale_y);
    const int rows = std::max(1, static_cast<int>(kCellsAtOnce / cells_a_row));
    for (int y = pixels.y0; y < pixels.y1; y += rows) {
        const grid::Rect strip{pixels.x0, y, pixels.x1, std::min(y + rows, pixels.y1)};
        const QImage picture = paint(strip);
        QPainter onto(&image);
        onto.setClipRect(part);
        onto.setRenderHint(QPainter::SmoothPixmapTransform, !upright);
        onto.setTransform(sheet.to_window);
        onto.drawImage(QPoint(strip.x0, strip.y0), picture);
    }
}

bool same_canvas(const film::FilmState& a, const film::FilmState& b) {
    return a.shape == b.shape && a.cell_mm == b.cell_mm;
}

/// Whether the layers of unchanged cells are those of before.
bool same_light(const Sight& a, const Sight& b) {
    return a.viewing.to_rgb == b.viewing.to_rgb && a.lighting.azimuth_deg == b.lighting.azimuth_deg &&
           a.lighting.elevation_deg == b.lighting.elevation_deg;
}

}  // namespace

bool same_place(const RasterScene& a, RasterScene b) {
    b.sight.painting = a.sight.painting;
    b.colours = a.colours;
    return a == b;
}

void RasterPicture::show(const RasterScene& scene, Quality quality, core::ThreadPool& pool) {
    const auto seen = ground_.below(scene.sight.painting, scene.sight.tracing, pool);
    if (seen_ != nullptr && !same_canvas(seen_->film, seen->film)) seen_.reset();
    if (seen_ == nullptr) light_.reset();
    const double scale_before_mm = scale_top_mm_;
    const std::vector<int> tiles = changed_tiles(seen_.get(), *seen);
    measure_heights(scene, *seen, tiles, pool);
    const QRegion cells = changed_cells(scene, *seen, tiles);
    update_layers(scene, *seen, cells, pool);
    if (scale_top_mm_ != scale_before_mm) scene_.reset();
    const QRegion region = changed_pixels(scene, cells);
    const bool recoloured = scene_ && scene_->colours != scene.colours;
    if (image_.size() != scene.window_px) {
        canvas_ = QImage(scene.window_px, QImage::Format_RGBX64);
        image_ = QImage(scene.window_px, QImage::Format_RGB32);
    }
    light_ = scene.sight;
    scene_ = scene;
    seen_ = seen;
    paint(region, takes_long(region) ? Quality::Plain : quality, pool);
    if (recoloured) finish(image_.rect(), scene, pool);
}

/// What lies below it is made anew each time where the layers of the canvas are not kept.
bool RasterPicture::takes_long(const QRegion& region) const {
    if (!layers_.cells.empty()) return false;
    double pixels = 0.0;
    for (const QRect& part : region)
        pixels += 1.0 * part.width() * part.height();
    return pixels / (scene_->view.zoom * scene_->view.zoom) > kMostWork;
}

void RasterPicture::paint(const QRegion& region, Quality quality, core::ThreadPool& pool) {
    const Sheet sheet(seen_->film.shape, scene_->view);
    const auto paint_with = [&](const shade::CellLayers& layers, const grid::Rect& pixels) {
        return SheetPainter(*scene_, *seen_, sheet, scale_top_mm_, quality, layers, pool).paint(pixels);
    };
    // The renderer would look for the canvas's highest place each time.
    const auto paint_pixels = [&](const grid::Rect& pixels) {
        if (!layers_.cells.empty() || scene_->sight.look == Look::Height)
            return paint_with(layers_, pixels);
        const bool far = scene_->view.zoom < kFarZoom && scene_->sight.look == Look::Lit;
        if (far && quality != Quality::Full) return flat_picture(*scene_, *seen_, sheet, pixels, pool);
        return paint_with(
            shade::cell_layers(seen_->film, seen_->ground, cells_needed(sheet, pixels),
                               scene_->sight.lighting, range_, pool, scene_->sight.viewing.to_rgb),
            pixels);
    };
    for (const QRect& part : region) {
        paint_part(canvas_, part, sheet, scene_->view.upright(), paint_pixels);
        finish(part, *scene_, pool);
    }
    draft_ = quality == Quality::Full ? draft_ - region : draft_ + region;
    draft_ &= QRect(QPoint(0, 0), scene_->window_px);
}

void RasterPicture::refine(core::ThreadPool& pool) {
    if (is_draft()) paint(draft_ & next_strip(), Quality::Full, pool);
}

/// Its work are the samples and, where no layers are kept, the cells below it.
QRect RasterPicture::next_strip() const {
    const double zoom = scene_->view.zoom;
    const double samples = samples_per_pixel(Quality::Full, zoom),
                 cells = layers_.cells.empty() ? 1.0 / (zoom * zoom) : 0.0;
    QRect strip = draft_.boundingRect();
    const double rows = kMostWork / (std::max(samples, cells) * strip.width());
    strip.setHeight(static_cast<int>(std::clamp(rows, 1.0, static_cast<double>(strip.height()))));
    return strip;
}

/// Of the layers; all of them at first, and where the light is another.
QRegion RasterPicture::changed_cells(const RasterScene& scene, const document::Snapshot& seen,
                                     const std::vector<int>& tiles) {
    const shade::HeightRange before = range_;
    ranges_.update(seen.film, tiles);
    range_ = ranges_.all();
    if (!light_ || !same_light(*light_, scene.sight))
        return qt_rect(shade::grown(seen.film.shape.cells(), shade::kLayersAround));
    return relief_region(seen.film, tiles, scene.sight.lighting, united(before, range_),
                         shade::kLayersAround);
}

void RasterPicture::update_layers(const RasterScene& scene, const document::Snapshot& seen,
                                  const QRegion& changed, core::ThreadPool& pool) {
    const grid::Rect all = shade::grown(seen.film.shape.cells(), shade::kLayersAround);
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

QRegion RasterPicture::changed_pixels(const RasterScene& scene, const QRegion& changed_cells) const {
    const QRect window(QPoint(0, 0), scene.window_px);
    if (seen_ == nullptr || !scene_ || !same_place(*scene_, scene)) return window;
    return damaged_pixels(scene.view, changed_cells) & window;
}

/// Brings the canvas into the colours and levels of the screen, as kFinishShader does it.
void RasterPicture::finish(const QRect& part, const RasterScene& scene, core::ThreadPool& pool) {
    uchar* const first = image_.bits();
    pool.run(static_cast<std::size_t>(part.height()), [&](std::size_t row, int) {
        const int y = part.top() + static_cast<int>(row);
        const auto* canvas = reinterpret_cast<const QRgba64*>(canvas_.constScanLine(y));
        auto* line = reinterpret_cast<QRgb*>(first + y * image_.bytesPerLine());
        for (int x = part.left(); x <= part.right(); ++x) {
            const auto ground = ground_at(scene, {x + 0.5, y + 0.5});
            const pigment::EncodedRgb colour = ground.value_or(colour_of(canvas[x]));
            const bool as_it_is = ground || scene.colours == nullptr;
            line[x] =
                dithered_pixel(as_it_is ? colour : pigment::shown_by(*scene.colours, colour), x, y);
        }
    });
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
