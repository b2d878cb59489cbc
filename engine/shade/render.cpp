#include "shade/render.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "shade/cell_layers.hpp"
#include "shade/cell_span.hpp"
#include "shade/kernels.hpp"
#include "shade/outline.hpp"
#include "shade/outline_layers.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace pastoso::shade {
namespace {

using grid::Rect;

constexpr double kSmallestScale = 1.0 / 64.0;
constexpr double kLargestScale = 64.0;
constexpr int kMaxSide_px = 32768;
constexpr double kMaxPixels = 1 << 28;

/// Samples are at most half a cell apart: the highlights of the finest ridges, two cells wide, are then
/// averaged and do not sparkle.
constexpr double kSampleSpacing_cells = 0.5;

/// Cells beyond the rectangle that its samples may need.
constexpr int kMargin = 3;

/// A part of the picture that one call of the kernel's rows covers.
constexpr double kBlock_cells = 128.0;
constexpr int kBlock_px = 64;

/// A rectangle of a lattice's pixels, and how it is sampled.
struct Frame {
    const Lattice& lattice;
    Rect pixels;
    int samples = 1;  ///< along a pixel's edge
    int block_width = 1, block_height = 1;

    SampleGrid columns() const { return grid_along(lattice.left_cells, lattice.scale_x); }
    SampleGrid lines() const { return grid_along(lattice.top_cells, lattice.scale_y); }
    int blocks_x() const { return (pixels.width() + block_width - 1) / block_width; }
    int blocks_y() const { return (pixels.height() + block_height - 1) / block_height; }
    Rect block(int index) const {
        const int x0 = pixels.x0 + index % blocks_x() * block_width;
        const int y0 = pixels.y0 + index / blocks_x() * block_height;
        return grid::intersection(pixels, {x0, y0, x0 + block_width, y0 + block_height});
    }

    /// The first pixel of a row of a block, counted from the rectangle's first.
    std::ptrdiff_t index(const Rect& block, int row) const {
        return static_cast<std::ptrdiff_t>(block.y0 - pixels.y0 + row) * pixels.width() + block.x0 -
               pixels.x0;
    }

  private:
    SampleGrid grid_along(double origin, double scale) const {
        return {origin, 1.0 / (scale * samples), colour_sharpness(scale)};
    }
};

int block_side(double scale) {
    return std::clamp(static_cast<int>(kBlock_cells * scale), 1, kBlock_px);
}

Frame frame_of(const Lattice& lattice, const Rect& pixels, int most_samples) {
    const double finest = std::min(lattice.scale_x, lattice.scale_y);
    const int samples =
        std::clamp(static_cast<int>(std::ceil(1.0 / (finest * kSampleSpacing_cells))), 1, most_samples);
    return {lattice, pixels, samples, block_side(lattice.scale_x), block_side(lattice.scale_y)};
}

OutlineSampling outline_sampling(const Frame& frame, float cell_mm, bool outlined) {
    const double scale = std::min(frame.lattice.scale_x, frame.lattice.scale_y);
    return {cell_mm, static_cast<float>(1.0 / (scale * frame.samples)),
            outlined ? outline_strength(scale) : 0.0F};
}

/// The cells below some pixels.
Rect cells_below(const Lattice& lattice, const Rect& pixels) {
    const auto cell = [](double origin, int pixel, double scale) {
        return static_cast<int>(std::floor(origin + pixel / scale));
    };
    return {cell(lattice.left_cells, pixels.x0, lattice.scale_x),
            cell(lattice.top_cells, pixels.y0, lattice.scale_y),
            cell(lattice.left_cells, pixels.x1, lattice.scale_x) + 1,
            cell(lattice.top_cells, pixels.y1, lattice.scale_y) + 1};
}

/// Adds the mean over each pixel's stretch of a row of samples.
void add_samples(const std::vector<float>& row, int samples, int pixels, float* rgb) {
    const float share = 1.0F / static_cast<float>(samples * samples);
    const float* sample = row.data();
    for (int i = 0; i < pixels; ++i, rgb += 3) {
        for (int k = 0; k < samples; ++k, sample += 3) {
            for (int channel = 0; channel < 3; ++channel)
                rgb[channel] += share * sample[channel];
        }
    }
}

void add_samples(const std::vector<SurfaceSample>& row, int samples, int pixels, SurfaceSample* out) {
    const float share = 1.0F / static_cast<float>(samples * samples);
    const SurfaceSample* sample = row.data();
    for (int i = 0; i < pixels; ++i, ++out) {
        for (int k = 0; k < samples; ++k, ++sample) {
            out->red += share * sample->red;
            out->green += share * sample->green;
            out->blue += share * sample->blue;
            out->wetness += share * sample->wetness;
            out->height_mm += share * sample->height_mm;
            out->slope_x += share * sample->slope_x;
            out->slope_y += share * sample->slope_y;
        }
    }
}

/// The layers below a picture; those of the outline are empty where it is not drawn.
struct Canvas {
    CellLayers layers;
    OutlineLayers outline;
};

struct Wanted {
    const ShadingConstants& light;
    OutlineSampling sampling;
    pigment::LinearImage* lit;
    SurfaceSamples* surface;
};

void render_block(const Canvas& canvas, const Frame& frame, const Rect& block, const Wanted& wanted) {
    const int n = frame.samples;
    const CellLayers& layers = canvas.layers;
    const bool outlined = wanted.sampling.strength > 0.0F;
    const SampleColumns columns(
        sample_axis(frame.columns(), block.x0 * n, block.width() * n, layers.cells.x0));
    const SampleAxis lines =
        sample_axis(frame.lines(), block.y0 * n, block.height() * n, layers.cells.y0);
    PASTOSO_CHECK_OP(columns.first_cell.back() + 4 - columns.first_cell.front(), <=, kMaxRowCells);
    const auto& kernel = core::kernels<Kernels>();
    std::vector<float> lit(wanted.lit == nullptr ? 0 : static_cast<std::size_t>(columns.count) * 3);
    std::vector<SurfaceSample> surface(wanted.surface == nullptr ? 0 : columns.count);
    for (int i = 0; i < block.height() * n; ++i) {
        const LayerRows rows = layers.rows_from(lines.first_cell[i]);
        const std::ptrdiff_t pixel = frame.index(block, i / n);
        if (wanted.lit != nullptr) {
            if (outlined)
                kernel.outline_row(rows, canvas.outline.rows_from(lines.first_cell[i]), lines.weights[i],
                                   columns, wanted.sampling, wanted.light, lit.data());
            else
                kernel.shade_row(rows, lines.weights[i], columns, wanted.sampling.cell_mm, wanted.light,
                                 lit.data());
            add_samples(lit, n, block.width(), wanted.lit->rgb.data() + 3 * pixel);
        }
        if (wanted.surface != nullptr) {
            if (outlined)
                kernel.outline_samples(rows, canvas.outline.rows_from(lines.first_cell[i]),
                                       lines.weights[i], columns, wanted.sampling, surface.data());
            else
                kernel.sample_row(rows, lines.weights[i], columns, wanted.sampling.cell_mm,
                                  surface.data());
            add_samples(surface, n, block.width(), wanted.surface->samples.data() + pixel);
        }
    }
}

}  // namespace

Lattice picture_lattice(const grid::Shape& canvas, const Rect& cells, double scale) {
    if (!(scale >= kSmallestScale && scale <= kLargestScale)) {
        throw core::InputError(
            "The picture's scale is %1 pixels per cell, outside the range from 1/64 to 64.",
            std::to_string(scale));
    }
    if (cells.empty() || grid::intersection(cells, canvas.cells()) != cells) {
        throw core::InputError(
            "The part of the canvas to render is empty or reaches beyond the canvas.");
    }
    const long width = std::max(1L, std::lround(cells.width() * scale));
    const long height = std::max(1L, std::lround(cells.height() * scale));
    if (width > kMaxSide_px || height > kMaxSide_px) {
        throw core::InputError(
            "A picture of %1 x %2 pixels is larger than the 32768 a side that can be made.", width,
            height);
    }
    return {static_cast<double>(cells.x0), static_cast<double>(cells.y0), scale, scale,
            static_cast<int>(width),       static_cast<int>(height)};
}

Renderer::Renderer(const film::FilmState& film, const pigment::Bands& ground, const Lattice& lattice,
                   const RenderSettings& settings, core::ThreadPool& pool)
    : film_(film), ground_(ground), lattice_(lattice), settings_(settings), pool_(pool) {
    if (settings.layers == nullptr) range_ = surface_range(film);
}

void Renderer::render(const Rect& pixels, pigment::LinearImage* lit, SurfaceSamples* surface) const {
    PASTOSO_CHECK(!pixels.empty());
    PASTOSO_CHECK(grid::intersection(pixels, {0, 0, lattice_.width, lattice_.height}) == pixels);
    const ShadingConstants light = shading_constants(settings_.lighting, film_.cell_mm);
    const Frame frame = frame_of(lattice_, pixels, settings_.most_samples);
    const OutlineSampling sampling =
        outline_sampling(frame, static_cast<float>(film_.cell_mm), settings_.outlined);
    Canvas canvas;
    const Rect cells = grown(cells_below(lattice_, pixels), kMargin);
    canvas.layers = settings_.layers != nullptr ? part_of(*settings_.layers, cells)
                                                : cell_layers(film_, ground_, cells, settings_.lighting,
                                                              range_, pool_, settings_.viewing.to_rgb);
    if (sampling.strength > 0.0F)
        canvas.outline = outline_layers(film_, ground_, canvas.layers, pool_, settings_.viewing.to_rgb);
    const std::size_t count = static_cast<std::size_t>(pixels.width()) * pixels.height();
    if (lit != nullptr) {
        *lit = {pixels.width(), pixels.height(), std::vector<float>(3 * count), settings_.viewing.space};
    }
    if (surface != nullptr) {
        *surface = {pixels.width(), pixels.height(), std::vector<SurfaceSample>(count)};
    }
    const Wanted wanted{light, sampling, lit, surface};
    pool_.run(static_cast<std::size_t>(frame.blocks_x()) * frame.blocks_y(),
              [&](std::size_t index, int) {
                  render_block(canvas, frame, frame.block(static_cast<int>(index)), wanted);
              });
}

pigment::LinearImage render(const film::FilmState& film, const pigment::Bands& ground, const Rect& cells,
                            const RenderSettings& settings, core::ThreadPool& pool) {
    const Lattice lattice = picture_lattice(film.shape, cells, settings.scale);
    if (static_cast<double>(lattice.width) * lattice.height > kMaxPixels) {
        throw core::InputError(
            "A picture of %1 x %2 pixels is larger than the 268 million that can be rendered.",
            lattice.width, lattice.height);
    }
    pigment::LinearImage image;
    Renderer(film, ground, lattice, settings, pool)
        .render({0, 0, lattice.width, lattice.height}, &image, nullptr);
    return image;
}

}  // namespace pastoso::shade
