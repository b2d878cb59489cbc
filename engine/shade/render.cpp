#include "shade/render.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "shade/cell_layers.hpp"
#include "shade/cell_span.hpp"
#include "shade/kernels.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace pastoso::shade {
namespace {

using grid::Rect;

constexpr double kSmallestScale = 1.0 / 64.0;
constexpr double kLargestScale = 64.0;
constexpr double kMaxPixels = 1 << 28;

/// Samples are at most half a cell apart: the highlights of the finest ridges, two cells wide, are then
/// averaged and do not sparkle.
constexpr double kSampleSpacing_cells = 0.5;

/// Cells beyond the rectangle that its samples may need.
constexpr int kMargin = 3;

/// A part of the picture that one call of the kernel's rows covers.
constexpr double kBlock_cells = 128.0;
constexpr int kBlock_px = 64;

/// How the picture's pixels lie on the canvas.
struct Frame {
    Rect cells;
    int width = 0, height = 0;
    double scale = 1.0;
    int samples = 1;  ///< along a pixel's edge
    int block_px = 1;

    SampleGrid samples_from(int first_cell) const {
        return {static_cast<double>(first_cell), 1.0 / (scale * samples), colour_sharpness(scale)};
    }
    int blocks_x() const { return (width + block_px - 1) / block_px; }
    int blocks_y() const { return (height + block_px - 1) / block_px; }
    Rect block(int index) const {
        const int x0 = index % blocks_x() * block_px;
        const int y0 = index / blocks_x() * block_px;
        return {x0, y0, std::min(x0 + block_px, width), std::min(y0 + block_px, height)};
    }
};

void check_frame(const film::FilmState& film, const Rect& cells, double scale) {
    if (!(scale >= kSmallestScale && scale <= kLargestScale)) {
        throw core::InputError("The picture's scale is " + std::to_string(scale) +
                               " pixels per cell, outside the range from 1/64 to 64.");
    }
    if (cells.empty() || grid::intersection(cells, film.shape.cells()) != cells) {
        throw core::InputError(
            "The part of the canvas to render is empty or reaches beyond the canvas.");
    }
    if (cells.width() * scale * (cells.height() * scale) > kMaxPixels) {
        throw core::InputError("A picture of " + std::to_string(std::lround(cells.width() * scale)) +
                               " x " + std::to_string(std::lround(cells.height() * scale)) +
                               " pixels is larger than the 268 million that can be rendered.");
    }
}

Frame frame_of(const Rect& cells, double scale) {
    Frame frame;
    frame.cells = cells;
    frame.width = std::max(1, static_cast<int>(std::lround(cells.width() * scale)));
    frame.height = std::max(1, static_cast<int>(std::lround(cells.height() * scale)));
    frame.scale = scale;
    frame.samples = std::max(1, static_cast<int>(std::ceil(1.0 / (scale * kSampleSpacing_cells))));
    frame.block_px = std::clamp(static_cast<int>(kBlock_cells * scale), 1, kBlock_px);
    return frame;
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

void render_block(const CellLayers& layers, const Frame& frame, const Rect& block, float cell_mm,
                  const ShadingConstants& light, LinearImage& image) {
    const int n = frame.samples;
    const SampleColumns columns(sample_axis(frame.samples_from(frame.cells.x0), block.x0 * n,
                                            block.width() * n, layers.cells.x0));
    const SampleAxis lines = sample_axis(frame.samples_from(frame.cells.y0), block.y0 * n,
                                         block.height() * n, layers.cells.y0);
    PASTOSO_CHECK_OP(columns.first_cell.back() + 4 - columns.first_cell.front(), <=, kMaxRowCells);
    const Kernels& kernel = kernels(core::best_isa());
    std::vector<float> row(static_cast<std::size_t>(columns.count) * 3);
    for (int i = 0; i < block.height() * n; ++i) {
        kernel.shade_row(layers.rows_from(lines.first_cell[i]), lines.weights[i], columns, cell_mm,
                         light, row.data());
        const std::ptrdiff_t pixel =
            static_cast<std::ptrdiff_t>(block.y0 + i / n) * frame.width + block.x0;
        add_samples(row, n, block.width(), image.rgb.data() + 3 * pixel);
    }
}

}  // namespace

LinearImage render(const film::FilmState& film, const pigment::Bands& ground, const Rect& cells,
                   const RenderSettings& settings, core::ThreadPool& pool) {
    check_frame(film, cells, settings.scale);
    const ShadingConstants light = shading_constants(settings.lighting);
    const Frame frame = frame_of(cells, settings.scale);
    const CellLayers layers = cell_layers(film, ground, grown(cells, kMargin), settings.lighting, pool,
                                          settings.viewing.to_rgb);
    LinearImage image{frame.width, frame.height, {}, settings.viewing.space};
    image.rgb.resize(static_cast<std::size_t>(frame.width) * frame.height * 3);
    pool.run(static_cast<std::size_t>(frame.blocks_x()) * frame.blocks_y(), [&](std::size_t index, int) {
        render_block(layers, frame, frame.block(static_cast<int>(index)),
                     static_cast<float>(film.cell_mm), light, image);
    });
    return image;
}

}  // namespace pastoso::shade
