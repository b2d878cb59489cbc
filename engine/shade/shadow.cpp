#include "shade/shadow.hpp"

#include "core/units.hpp"
#include "shade/cell_span.hpp"
#include "shade/kernels.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pastoso::shade {
namespace {

using grid::Rect;

/// The steps towards the light: each one cell along one axis, `share` of a cell along the other.
struct LightPath {
    bool steps_along_x = true;
    int x = 1, y = 1;  ///< signs
    double share = 0.0;
    double drop_mm = 0.0;  ///< of a ray of light over a step
    int count = 1;         ///< as far as shadows reach, and one on
};

LightPath light_path(const Lighting& lighting, double cell_mm, const HeightRange& range) {
    const double x = std::cos(core::radians(lighting.azimuth_deg));
    const double y = -std::sin(core::radians(lighting.azimuth_deg));
    const double major = std::max(std::abs(x), std::abs(y));
    const double minor = std::min(std::abs(x), std::abs(y));
    LightPath path;
    path.steps_along_x = std::abs(x) >= std::abs(y);
    path.x = x < 0.0 ? -1 : 1;
    path.y = y < 0.0 ? -1 : 1;
    path.share = minor / major;
    path.drop_mm = cell_mm / major * std::tan(core::radians(lighting.elevation_deg));
    path.count = static_cast<int>((range.highest_mm - range.lowest_mm) / path.drop_mm) + 1;
    return path;
}

/// The rectangle and the cells from which a shadow may fall into it.
Rect with_casters(Rect cells, const LightPath& path) {
    const int aside = static_cast<int>(path.count * path.share) + 1;
    const int reach_x = path.steps_along_x ? path.count : aside;
    const int reach_y = path.steps_along_x ? aside : path.count;
    (path.x > 0 ? cells.x1 : cells.x0) += path.x * reach_x;
    (path.y > 0 ? cells.y1 : cells.y0) += path.y * reach_y;
    return cells;
}

/// The two cells of a step between which the ray passes, relative to where it arrives.
struct Crossing {
    std::ptrdiff_t near, far;
    float far_share;
};

Crossing crossing(const LightPath& path, int step, std::ptrdiff_t stride) {
    const double aside = step * path.share;
    const int cells_aside = static_cast<int>(aside);
    const std::ptrdiff_t along = path.steps_along_x ? path.x : path.y * stride;
    const std::ptrdiff_t across = path.steps_along_x ? path.y * stride : path.x;
    const std::ptrdiff_t near = step * along + cells_aside * across;
    return {near, near + across, static_cast<float>(aside - cells_aside)};
}

void fill_heights(const film::FilmState& film, const Rect& cells, const LightPath& path, float lowest_mm,
                  float* out, int stride) {
    const auto lit_mm = static_cast<float>(lowest_mm - path.drop_mm);
    const Rect area = with_casters(cells, path);
    std::vector<float> heights(static_cast<std::size_t>(area.width()) * area.height());
    surface_means(film, area, heights.data(), area.width());
    const auto& kernel = core::kernels<Kernels>();
    for (int y = cells.y0; y < cells.y1; ++y) {
        float* row = out + static_cast<std::ptrdiff_t>(y - cells.y0) * stride;
        const float* height = heights.data() + static_cast<std::ptrdiff_t>(y - area.y0) * area.width() +
                              (cells.x0 - area.x0);
        std::fill_n(row, cells.width(), lit_mm);
        for (int step = 1; step <= path.count; ++step) {
            const Crossing between = crossing(path, step, area.width());
            kernel.raise_shadow(height + between.near, height + between.far, between.far_share,
                                static_cast<float>(step * path.drop_mm), cells.width(), row);
        }
    }
}

}  // namespace

void shadow_heights(const film::FilmState& film, const Rect& cells, const Lighting& lighting,
                    const HeightRange& range, float* out, int stride) {
    const LightPath path = light_path(lighting, film.cell_mm, range);
    fill_beyond_edges(film.shape, cells, out, stride,
                      [&](const Rect& part, float* target, int target_stride) {
                          fill_heights(film, part, path, range.lowest_mm, target, target_stride);
                      });
}

}  // namespace pastoso::shade
