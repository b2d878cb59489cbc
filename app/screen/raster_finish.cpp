#include "screen/raster_finish.hpp"

#include "appearance/dither.hpp"
#include "pigment/colour.hpp"
#include "screen/encoded_pixels.hpp"
#include "screen/squint.hpp"

#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::screen {
namespace {

pigment::EncodedRgb colour_of(const QRgba64& pixel) {
    constexpr auto kMost = static_cast<float>(kMost16);
    return {static_cast<float>(pixel.red()) / kMost, static_cast<float>(pixel.green()) / kMost,
            static_cast<float>(pixel.blue()) / kMost};
}

QRgb dithered_pixel(const pigment::EncodedRgb& colour, int x, int y) {
    const float threshold = appearance::dither_threshold(x, y);
    return qRgb(appearance::dithered(colour[0], threshold), appearance::dithered(colour[1], threshold),
                appearance::dithered(colour[2], threshold));
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

/// Of the ground, no share of which goes through the colours of the screen.
QRgba64 pixel_beyond(const pigment::EncodedRgb& ground) {
    QRgba64 pixel = encoded({ground[0], ground[1], ground[2]});
    pixel.setAlpha(0);
    return pixel;
}

pigment::EncodedRgb shown_in_part(const RasterScene& scene, const QRgba64& pixel) {
    pigment::EncodedRgb colour = colour_of(pixel);
    if (scene.colours == nullptr) return colour;
    const pigment::EncodedRgb shown = pigment::shown_by(*scene.colours, colour);
    for (std::size_t i = 0; i < colour.size(); ++i)
        colour[i] += static_cast<float>(pixel.alpha() / kMost16) * (shown[i] - colour[i]);
    return colour;
}

/// `work(y)` for the rows of a part.
template <class Work>
void for_rows(const QRect& part, core::ThreadPool& pool, const Work& work) {
    pool.run(static_cast<std::size_t>(part.height()),
             [&](std::size_t row, int) { work(part.top() + static_cast<int>(row)); });
}

}  // namespace

void finish_part(const QImage& canvas, const QRect& part, const RasterScene& scene,
                 core::ThreadPool& pool, QImage& image) {
    uchar* const first = image.bits();
    for_rows(part, pool, [&](int y) {
        const auto* from = reinterpret_cast<const QRgba64*>(canvas.constScanLine(y));
        auto* line = reinterpret_cast<QRgb*>(first + y * image.bytesPerLine());
        for (int x = part.left(); x <= part.right(); ++x) {
            const auto ground = ground_at(scene, {x + 0.5, y + 0.5});
            const pigment::EncodedRgb colour = ground.value_or(colour_of(from[x]));
            const bool as_it_is = ground || scene.colours == nullptr;
            line[x] =
                dithered_pixel(as_it_is ? colour : pigment::shown_by(*scene.colours, colour), x, y);
        }
    });
}

void finish_squinted(const QImage& canvas, const RasterScene& scene, core::ThreadPool& pool,
                     QImage& image) {
    QImage whole = canvas.convertToFormat(QImage::Format_RGBA64);
    uchar* const first_whole = whole.bits();
    for_rows(whole.rect(), pool, [&](int y) {
        auto* line = reinterpret_cast<QRgba64*>(first_whole + y * whole.bytesPerLine());
        for (int x = 0; x < whole.width(); ++x)
            if (const auto ground = ground_at(scene, {x + 0.5, y + 0.5}))
                line[x] = pixel_beyond(*ground);
    });
    const QImage seen = squinted(whole, scene.squint_px, pool);
    uchar* const first = image.bits();
    for_rows(image.rect(), pool, [&](int y) {
        const auto* from = reinterpret_cast<const QRgba64*>(seen.constScanLine(y));
        auto* line = reinterpret_cast<QRgb*>(first + y * image.bytesPerLine());
        for (int x = 0; x < image.width(); ++x)
            line[x] = dithered_pixel(shown_in_part(scene, from[x]), x, y);
    });
}

}  // namespace pastoso::screen
