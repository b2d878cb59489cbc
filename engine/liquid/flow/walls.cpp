#include "liquid/flow/walls.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace pastoso::liquid {
namespace {

constexpr float kLeastOpenShare = 0.02F;

float open_share(const SignedDistance& distance, const glm::vec3& point_cells, float cell_m) {
    const float distance_m = distance(point_cells * cell_m);
    if (std::isnan(distance_m))
        throw core::InputError("The wall's distance at (%1, %2, %3) m is not a number.",
                               std::to_string(point_cells.x * cell_m),
                               std::to_string(point_cells.y * cell_m),
                               std::to_string(point_cells.z * cell_m));
    const float share = std::clamp(0.5F - distance_m / cell_m, 0.0F, 1.0F);
    return share < kLeastOpenShare ? 0.0F : share;
}

VelocityField open_faces(const grid::BoxShape& shape, const SignedDistance& distance) {
    check_box_shape(shape);
    VelocityField open(shape);
    for (const int axis : kAxes) {
        const glm::vec3 offset = offset_cells(face_across(axis));
        const glm::ivec3 first(axis == 0, axis == 1, axis == 2);
        for (int k = first.z; k < shape.nz; ++k)
            for (int j = first.y; j < shape.ny; ++j)
                for (int i = first.x; i < shape.nx; ++i)
                    open.along(axis).at(i, j, k) =
                        open_share(distance, glm::vec3(i, j, k) + offset, shape.cell_m);
    }
    return open;
}

}  // namespace

void check_box_shape(const grid::BoxShape& shape) {
    const auto side_fits = [](int cells) { return cells >= 2 && cells <= kMaxBoxSide_cells; };
    if (!side_fits(shape.nx) || !side_fits(shape.ny) || !side_fits(shape.nz))
        throw core::InputError("The box of liquid has %1 x %2 x %3 cells; each side may have 2 to %4.",
                               shape.nx, shape.ny, shape.nz, kMaxBoxSide_cells);
    if (!(shape.cell_m > 0.0F) || !std::isfinite(shape.cell_m))
        throw core::InputError("The cells of the box of liquid are %1 m wide, which is no size.",
                               std::to_string(shape.cell_m));
}

Walls::Walls(const grid::BoxShape& shape, const SignedDistance& distance)
    : Region(open_faces(shape, distance)) {
    for (const int axis : kAxes)
        rings_[static_cast<std::size_t>(axis)] = Extrapolation(open().along(axis), kWallRings);
    rings_[static_cast<std::size_t>(Location::Cell)] = Extrapolation(open_cells(), kWallRings);
}

}  // namespace pastoso::liquid
