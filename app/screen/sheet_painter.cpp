#include "screen/sheet_painter.hpp"

#include "pigment/colour.hpp"
#include "screen/encoded_pixels.hpp"
#include "screen/look_layer.hpp"
#include "shade/cell_span.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::screen {
namespace {

glm::dvec3 vec3(const Rgb& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

/// Over the lit picture or in its place, what a look shows at one pixel.
struct LookPixels {
    const document::Snapshot& seen;
    Look look;
    double scale_top_mm;
    const CanvasSheet& sheet;
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

/// `work(rgb)` for the values of every row.
template <class Work>
void for_rows(pigment::LinearImage& picture, core::ThreadPool& pool, const Work& work) {
    const std::size_t row = 3 * static_cast<std::size_t>(picture.width);
    pool.run(static_cast<std::size_t>(picture.height),
             [&](std::size_t y, int) { work(picture.rgb.data() + row * y, y); });
}

pigment::LinearImage fitting(pigment::LinearImage picture, core::ThreadPool& pool) {
    for_rows(picture, pool, [&](float* rgb, std::size_t) {
        for (int x = 0; x < picture.width; ++x, rgb += 3) {
            const pigment::LinearRgb colour =
                pigment::into_gamut({rgb[0], rgb[1], rgb[2]}, picture.space);
            std::copy(colour.begin(), colour.end(), rgb);
        }
    });
    return picture;
}

QImage as_image(const pigment::LinearImage& picture, core::ThreadPool& pool) {
    QImage image(picture.width, picture.height, QImage::Format_RGBX64);
    uchar* const first = image.bits();
    pool.run(static_cast<std::size_t>(picture.height), [&](std::size_t y, int) {
        auto* line =
            reinterpret_cast<QRgba64*>(first + static_cast<qsizetype>(y) * image.bytesPerLine());
        const float* rgb = picture.rgb.data() + 3 * y * static_cast<std::size_t>(picture.width);
        for (int x = 0; x < picture.width; ++x, rgb += 3)
            line[x] = encoded_light(rgb[0], rgb[1], rgb[2]);
    });
    return image;
}

pigment::LinearImage colours(const shade::SurfaceSamples& surface, pigment::WorkingSpace space) {
    pigment::LinearImage image{surface.width, surface.height, {}, space};
    image.rgb.reserve(3 * surface.samples.size());
    for (const shade::SurfaceSample& sample : surface.samples)
        image.rgb.insert(image.rgb.end(), {sample.red, sample.green, sample.blue});
    return image;
}

/// The layers of a flat surface with a cell for each pixel, in the colour of one cell below it.
shade::CellLayers flat_layers(const RasterScene& scene, const document::Snapshot& seen,
                              const CanvasSheet& sheet, const grid::Rect& pixels,
                              core::ThreadPool& pool) {
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

}  // namespace

SheetPainter::SheetPainter(const RasterScene& scene, const document::Snapshot& seen,
                           const CanvasSheet& sheet, double scale_top_mm, Quality quality,
                           const shade::CellLayers& layers, core::ThreadPool& pool)
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
                 .most_samples = samples_per_side(quality, sheet.lattice.scale_x),
                 .layers = layers.cells.empty() ? nullptr : &layers},
                pool) {}

pigment::LinearImage SheetPainter::light(const grid::Rect& pixels) const {
    if (look_ == Look::Flat) {
        shade::SurfaceSamples surface;
        renderer_.render(pixels, nullptr, &surface);
        return fitting(colours(surface, space_), pool_);
    }
    pigment::LinearImage lit;
    renderer_.render(pixels, &lit, nullptr);
    return fitting(std::move(lit), pool_);
}

QImage SheetPainter::paint(const grid::Rect& pixels) const {
    const LookPixels shown{seen_, look_, scale_top_mm_, sheet_, pixels};
    const int width = pixels.width(), height = pixels.height();
    switch (look_) {
        case Look::Lit:
        case Look::Flat:
            return as_image(light(pixels), pool_);
        case Look::Wet: {
            pigment::LinearImage lit;
            renderer_.render(pixels, &lit, nullptr);
            const auto weights = pigment::luminance_weights(space_);
            return made_of(width, height, [&](int x, int y, std::size_t i) {
                const float* rgb = lit.rgb.data() + 3 * i;
                return shown.wet_at(x, y,
                                    weights[0] * rgb[0] + weights[1] * rgb[1] + weights[2] * rgb[2]);
            });
        }
        case Look::Normals: {
            shade::SurfaceSamples surface;
            renderer_.render(pixels, nullptr, &surface);
            return made_of(width, height,
                           [&](int, int, std::size_t i) { return normal_of(surface.samples[i]); });
        }
        case Look::Height:
            return made_of(width, height,
                           [&](int x, int y, std::size_t) { return shown.height_at(x, y); });
    }
    return {};
}

QImage flat_picture(const RasterScene& scene, const document::Snapshot& seen, const CanvasSheet& sheet,
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
    return as_image(fitting(std::move(lit), pool), pool);
}

}  // namespace pastoso::screen
