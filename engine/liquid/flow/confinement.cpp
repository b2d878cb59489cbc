#include "liquid/flow/confinement.hpp"

#include "liquid/flow/slices.hpp"

#include <cmath>

namespace pastoso::liquid {
namespace {

/// The vorticity in the middle of a cell, in 1/s times a cell's size.
glm::vec3 vorticity(const VelocityField& velocity, std::ptrdiff_t at,
                    const std::array<std::ptrdiff_t, 3>& to) {
    // d(component)/d(axis) from the mean of both faces of the cells before and behind.
    const auto slope = [&](int component, int axis) {
        const float* face = velocity.along(component).values().data() + at;
        const std::ptrdiff_t across = to[static_cast<std::size_t>(component)],
                             along = to[static_cast<std::size_t>(axis)];
        return 0.25F * ((face[along] + face[along + across]) - (face[-along] + face[across - along]));
    };
    return {slope(2, 1) - slope(1, 2), slope(0, 2) - slope(2, 0), slope(1, 0) - slope(0, 1)};
}

}  // namespace

void add_confinement(const Region& region, float strength, float dt_s, VelocityField& velocity,
                     core::ThreadPool& pool) {
    const grid::BoxShape& shape = region.shape();
    const std::array<std::ptrdiff_t, 3> to = {1, shape.stride_y(), shape.stride_z()};
    VelocityField spin(shape), force(shape);
    grid::BoxField size(shape);
    const auto for_cells = [&](const auto& body) {
        for_slices(pool, 0, shape.nz, [&](int k) {
            for (int j = 0; j < shape.ny; ++j) {
                const RowRange range = region.rows(Location::Cell).at(j, k);
                for (int i = range.begin; i < range.end; ++i)
                    if (region.open_cells().at(i, j, k) > 0.0F) body(i, j, k);
            }
        });
    };
    for_cells([&](int i, int j, int k) {
        const glm::vec3 omega = vorticity(velocity, shape.index(i, j, k), to);
        for (const int axis : kAxes)
            spin.along(axis).at(i, j, k) = omega[axis];
        size.at(i, j, k) = std::sqrt(omega.x * omega.x + omega.y * omega.y + omega.z * omega.z);
    });
    // Towards a shut cell nothing changes.
    const auto beside = [&](std::ptrdiff_t at, std::ptrdiff_t step) {
        const std::vector<float>&sizes = size.values(), &open = region.open_cells().values();
        const auto there = static_cast<std::size_t>(at + step);
        return open[there] > 0.0F ? sizes[there] : sizes[static_cast<std::size_t>(at)];
    };
    for_cells([&](int i, int j, int k) {
        const std::ptrdiff_t at = shape.index(i, j, k);
        glm::vec3 slope;
        for (const int axis : kAxes)
            slope[axis] = beside(at, to[static_cast<std::size_t>(axis)]) -
                          beside(at, -to[static_cast<std::size_t>(axis)]);
        const float length = std::sqrt(slope.x * slope.x + slope.y * slope.y + slope.z * slope.z);
        if (!(length > 0.0F)) return;
        const glm::vec3 n = slope / length;
        const glm::vec3 omega(spin.x.at(i, j, k), spin.y.at(i, j, k), spin.z.at(i, j, k));
        // The vorticity is in cells per second already: eps h omega.
        force.x.at(i, j, k) = n.y * omega.z - n.z * omega.y;
        force.y.at(i, j, k) = n.z * omega.x - n.x * omega.z;
        force.z.at(i, j, k) = n.x * omega.y - n.y * omega.x;
    });
    for_slices(pool, 0, shape.nz, [&](int k) {
        for (const int axis : kAxes)
            for (int j = 0; j < shape.ny; ++j) {
                const RowRange range = region.rows(face_across(axis)).at(j, k);
                const float* f = force.along(axis).row(j, k);
                const float* open = region.open().along(axis).row(j, k);
                float* u = velocity.along(axis).row(j, k);
                for (int i = range.begin; i < range.end; ++i)
                    if (open[i] > 0.0F)
                        u[i] +=
                            dt_s * strength * 0.5F * (f[i] + f[i - to[static_cast<std::size_t>(axis)]]);
            }
    });
}

}  // namespace pastoso::liquid
