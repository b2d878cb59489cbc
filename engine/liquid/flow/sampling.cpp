#include "liquid/flow/sampling.hpp"

#include "liquid/flow/sample_lanes.hpp"

namespace pastoso::liquid {

float sample(const grid::BoxField& field, Location location, const glm::vec3& point_m,
             Interpolation interpolation) {
    const grid::BoxShape& shape = field.shape();
    const std::ptrdiff_t y = shape.stride_y(), z = shape.stride_z();
    const glm::vec3 cells = point_m / shape.cell_m;
    const Four size = {static_cast<float>(shape.nx), static_cast<float>(shape.ny),
                       static_cast<float>(shape.nz), 1.0F};
    const Four at = in_box<false>(Four{cells.x, cells.y, cells.z, 0.0F}, size);
    const Place place = place_of(at - location_of(static_cast<int>(location)), y, z);
    const float* values = field.row(0, 0);
    if (interpolation == Interpolation::Linear) return linear(values, place, y, z);
    const CubicWeights weights = cubic_weights_at(place.share);
    if (interpolation == Interpolation::Cubic) return cubic<false>(values, place, weights, y, z);
    return cubic<true>(values, place, weights, y, z);
}

glm::vec3 velocity_at(const VelocityField& velocity, const glm::vec3& point_m,
                      Interpolation interpolation) {
    return {sample(velocity.x, Location::FaceX, point_m, interpolation),
            sample(velocity.y, Location::FaceY, point_m, interpolation),
            sample(velocity.z, Location::FaceZ, point_m, interpolation)};
}

}  // namespace pastoso::liquid
