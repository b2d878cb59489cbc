#include "shade/sky.hpp"

#include "shade/cell_span.hpp"
#include "shade/kernels.hpp"
#include "shade/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pastoso::shade {
namespace {

using grid::Rect;

constexpr double kNearest_mm = 0.25;  // each further distance is twice the one before
constexpr std::array<std::array<int, 2>, 8> kDirections = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

int nearest_cells(double cell_mm) {
    return std::max(1, static_cast<int>(std::lround(kNearest_mm / cell_mm)));
}

HorizonLook look(const std::array<int, 2>& direction, double cell_mm, std::ptrdiff_t stride) {
    const double step_mm = cell_mm * std::hypot(direction[0], direction[1]);
    HorizonLook result;
    for (int k = 0; k < kHorizonDistances; ++k) {
        const int cells = nearest_cells(cell_mm) << k;
        result.offset[k] = cells * (direction[0] + direction[1] * stride);
        result.inverse_distance_per_mm[k] = static_cast<float>(1.0 / (cells * step_mm));
    }
    return result;
}

void fill_shares(const film::FilmState& film, const Rect& cells, float* out, int stride) {
    const int reach = sky_reach_cells(film.cell_mm);
    const Rect area = grown(cells, reach);
    std::vector<float> heights(static_cast<std::size_t>(area.width()) * area.height());
    surface_means(film, area, heights.data(), area.width());
    std::array<HorizonLook, kDirections.size()> looks;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        looks[i] = look(kDirections[i], film.cell_mm, area.width());
    }
    const auto& kernel = core::kernels<Kernels>();
    for (int y = 0; y < cells.height(); ++y) {
        float* row = out + static_cast<std::ptrdiff_t>(y) * stride;
        const float* height =
            heights.data() + static_cast<std::ptrdiff_t>(y + reach) * area.width() + reach;
        std::fill_n(row, cells.width(), 0.0F);
        for (const HorizonLook& direction : looks) {
            kernel.add_horizon(direction, height, cells.width(), row);
        }
    }
}

}  // namespace

int sky_reach_cells(double cell_mm) {
    return nearest_cells(cell_mm) << (kHorizonDistances - 1);
}

void sky_shares(const film::FilmState& film, const Rect& cells, float* out, int stride) {
    fill_beyond_edges(film.shape, cells, out, stride,
                      [&film](const Rect& part, float* target, int target_stride) {
                          fill_shares(film, part, target, target_stride);
                      });
}

}  // namespace pastoso::shade
