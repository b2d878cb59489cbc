#include "liquid/tea/painters_force.hpp"

#include "core/elementary.hpp"
#include "liquid/flow/slices.hpp"

#include <algorithm>
#include <vector>

namespace pastoso::liquid {
namespace {

/// exp(-x) is nothing in single precision beyond.
constexpr double kFarthest = 400.0;

/// One axis of the force at one place.
struct Fading {
    float way_m;  ///< from the axis
    float share;  ///< of the force
};

/// At places half a cell apart: the faces before the cells (even) and the cells' middles (odd).
std::vector<Fading> fading(int cells, float cell_m, double axis_m, double reach_m) {
    std::vector<Fading> places;
    for (int half = 0; half < 2 * cells; ++half) {
        const double way_m = 0.5 * half * static_cast<double>(cell_m) - axis_m;
        const double reaches = way_m / reach_m;
        places.push_back(
            {static_cast<float>(way_m),
             static_cast<float>(core::exponential(-0.5 * std::min(reaches * reaches, kFarthest)))});
    }
    return places;
}

}  // namespace

void add_painters_force(const TeaSettings& settings, float dt_s, VelocityField& velocity,
                        core::ThreadPool& pool) {
    if (settings.swirl_rad_s2 == 0.0 && settings.push_m_s2 == 0.0) return;
    const grid::BoxShape& shape = velocity.shape();
    const float swirl = dt_s * static_cast<float>(settings.swirl_rad_s2),
                push = dt_s * static_cast<float>(settings.push_m_s2);
    const std::vector<Fading> x =
        fading(shape.nx, shape.cell_m, settings.swirl_x_m, settings.force_reach_m);
    const std::vector<Fading> y =
        fading(shape.ny, shape.cell_m, settings.swirl_y_m, settings.force_reach_m);
    for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j) {
            const Fading &face_y = y[2 * static_cast<std::size_t>(j)],
                         &middle_y = y[2 * static_cast<std::size_t>(j) + 1];
            for (int i = 0; i < shape.nx; ++i) {
                const Fading &face_x = x[2 * static_cast<std::size_t>(i)],
                             &middle_x = x[2 * static_cast<std::size_t>(i) + 1];
                velocity.x.at(i, j, k) -= swirl * middle_y.way_m * face_x.share * middle_y.share;
                velocity.y.at(i, j, k) += swirl * middle_x.way_m * middle_x.share * face_y.share;
                velocity.z.at(i, j, k) -= push * middle_x.share * middle_y.share;
            }
        }
    });
}

}  // namespace pastoso::liquid
