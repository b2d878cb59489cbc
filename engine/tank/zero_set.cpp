#include "tank/zero_set.hpp"

#include "liquid/flow/sample_lanes.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pastoso::tank {
namespace {

namespace lanes = core::lanes;
using liquid::Four;

/// How far beyond the box places may lie.
constexpr float kBeyond_cells = 8.0F;

/// The harmonic mean of two second differences of one sign, 0 of others.
Four limited(Four a, Four b) {
    const Four product = a * b, none = Four(0.0F);
    const Four sum = lanes::select(product > none, a + b, Four(1.0F));
    return lanes::select(product > none, (product + product) / sum, none);
}

/// The four edges along one axis of the cube whose lowest corner is given; lane b + 2 c is the edge that
/// lies b and c steps off along the other two.
struct FourEdges {
    Four low, high, bend;
};
FourEdges edges_along(const float* corner, std::ptrdiff_t along, std::ptrdiff_t b, std::ptrdiff_t c) {
    const auto samples = [&](std::ptrdiff_t step) {
        const float* at = corner + step * along;
        return Four{at[0], at[b], at[c], at[b + c]};
    };
    const Four low = samples(0), high = samples(1);
    return {low, high, limited((samples(-1) + high) - (low + low), (low + samples(2)) - (high + high))};
}

float dot(Four a, Four b) {
    const Four product = a * b;
    return (product[0] + product[1]) + (product[2] + product[3]);
}

/// Bilinear weights of an axis' edges and their slopes along the other two axes.
struct EdgeWeights {
    Four value, slope_b, slope_c;
};
EdgeWeights edge_weights(float b, float c) {
    const float rest_b = 1.0F - b, rest_c = 1.0F - c;
    return {Four{rest_b * rest_c, b * rest_c, rest_b * c, b * c}, Four{-rest_c, rest_c, -c, c},
            Four{-rest_b, -b, rest_b, b}};
}

/// Takes an axis' bends off.
void bend(Interpolated& result, const Four& bends, const EdgeWeights& weights, float t, int axis, int b,
          int c) {
    const float share = 0.5F * t * (1.0F - t), bent = dot(bends, weights.value);
    result.value -= share * bent;
    result.slope[axis] -= (0.5F - t) * bent;
    result.slope[b] -= share * dot(bends, weights.slope_b);
    result.slope[c] -= share * dot(bends, weights.slope_c);
}

/// How much more or less of the way beside the slope the next move should go, from what of it the last
/// one left: the secant's answer. From a place outside a ball by more than its radius whole ways never
/// end.
float next_part(const glm::vec3& before, const glm::vec3& after) {
    const float size2 = glm::dot(before, before);
    if (!(size2 > 1e-8F)) return 1.0F;
    return 1.0F / std::clamp(1.0F - glm::dot(before, after) / size2, 0.5F, 4.0F);
}

}  // namespace

Interpolated interpolate(const grid::BoxField& phi, const glm::vec3& place_cells) {
    const grid::BoxShape& shape = phi.shape();
    const int count[3] = {shape.nx, shape.ny, shape.nz};
    int lower[3];
    float t[3];
    for (int axis = 0; axis < 3; ++axis) {
        const float last = static_cast<float>(count[axis]) + kBeyond_cells;
        // Written so that what is no number goes to the corner.
        const float at = std::min(std::max(-kBeyond_cells, place_cells[axis] - 0.5F), last);
        lower[axis] = std::clamp(static_cast<int>(at + kBeyond_cells) - static_cast<int>(kBeyond_cells),
                                 -1, count[axis] - 1);
        t[axis] = at - static_cast<float>(lower[axis]);
    }
    const std::ptrdiff_t y = shape.stride_y(), z = shape.stride_z();
    const float* corner = phi.row(lower[1], lower[2]) + lower[0];
    const FourEdges along_x = edges_along(corner, 1, y, z);
    const EdgeWeights yz = edge_weights(t[1], t[2]), xz = edge_weights(t[0], t[2]),
                      xy = edge_weights(t[0], t[1]);
    const Four rise = along_x.high - along_x.low, mixed = along_x.low + Four(t[0]) * rise;
    Interpolated result{dot(mixed, yz.value),
                        {dot(rise, yz.value), dot(mixed, yz.slope_b), dot(mixed, yz.slope_c)}};
    bend(result, along_x.bend, yz, t[0], 0, 1, 2);
    bend(result, edges_along(corner, y, 1, z).bend, xz, t[1], 1, 0, 2);
    bend(result, edges_along(corner, z, 1, y).bend, xy, t[2], 2, 0, 1);
    const float per_cell = 1.0F / shape.cell_m;
    return {result.value * per_cell, result.slope * per_cell};
}

Foot find_foot(const grid::BoxField& phi, const glm::vec3& place_cells, const glm::vec3& start_cells) {
    // A last move of 0.02 cells leaves an error of the distance of some 1e-4.
    constexpr int kMostMoves = 6;
    constexpr float kClose_cells = 0.02F, kLeastSlope2 = 0.04F, kLongestMove_cells = 1.0F,
                    kOnSurface_cells = 0.02F;
    glm::vec3 foot = start_cells, beside_before(0.0F);
    float part = 1.0F;
    for (int n = 0; n < kMostMoves; ++n) {
        const Interpolated here = interpolate(phi, foot);
        const float slope2 = glm::dot(here.slope, here.slope);
        if (!(slope2 > kLeastSlope2)) return {start_cells, false};
        const glm::vec3 off = place_cells - foot;
        const glm::vec3 beside = off - (glm::dot(off, here.slope) / slope2) * here.slope;
        if (n > 0) part *= next_part(beside_before, beside);
        beside_before = beside;
        glm::vec3 move = part * beside - (here.value / slope2) * here.slope;
        const float length = glm::length(move);
        if (length > kLongestMove_cells) move *= kLongestMove_cells / length;
        foot += move;
        if (length < kClose_cells) return {foot, true};
    }
    const Interpolated last = interpolate(phi, foot);
    const float slope2 = std::max(glm::dot(last.slope, last.slope), kLeastSlope2);
    foot -= (last.value / slope2) * last.slope;
    return {foot, std::abs(last.value) < kOnSurface_cells};
}

}  // namespace pastoso::tank
