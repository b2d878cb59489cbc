// Interpolation of a group of points at once, a lane for each: the formulas of sample_lanes.hpp with the
// same bits. Points whose stencils begin the same way off (neighbours of a row that moved through the
// same cells, points of one cell) share their loads, and a group is done once for each such way.
#pragma once

#include "liquid/flow/advection_view.hpp"
#include "liquid/flow/sample_lanes.hpp"

#include <bit>

namespace pastoso::liquid {
namespace {

using Group = lanes::Lanes<float, kPointsTogether>;
using GroupIndex = lanes::Lanes<std::int32_t, kPointsTogether>;

/// Three numbers for each point.
struct ThreeGroups {
    Group x, y, z;
};

/// The sample before a point, and how far behind it the point lies.
struct GroupPlace {
    GroupIndex index;
    ThreeGroups share;
};

template <bool kPeriodic>
PASTOSO_LANE_FUNCTION Group in_box(Group at, float size) {
    if constexpr (kPeriodic) {
        const Group turns = at / Group(size);
        const Group toward_zero = lanes::convert<float>(lanes::convert<std::int32_t>(turns));
        const Group whole = toward_zero - lanes::select(turns < toward_zero, Group(1.0F), Group(0.0F));
        at -= whole * Group(size);
    }
    return lanes::min(lanes::max(at, Group(0.0F)), Group(size));
}
template <bool kPeriodic>
PASTOSO_LANE_FUNCTION ThreeGroups in_box(const ThreeGroups& at, const float* size) {
    return {in_box<kPeriodic>(at.x, size[0]), in_box<kPeriodic>(at.y, size[1]),
            in_box<kPeriodic>(at.z, size[2])};
}

/// Above 0, where rounding towards zero is rounding down.
PASTOSO_LANE_FUNCTION Group from_ghosts(Group along, bool on_face) {
    return (along - Group(on_face ? 0.0F : 0.5F)) + Group(2.0F);
}
/// Where points lie among the samples of an axis' faces; axis 3: of the middles.
PASTOSO_LANE_FUNCTION GroupPlace place_among(const ThreeGroups& at, int axis, std::ptrdiff_t stride_y,
                                             std::ptrdiff_t stride_z) {
    const ThreeGroups from = {from_ghosts(at.x, axis == 0), from_ghosts(at.y, axis == 1),
                              from_ghosts(at.z, axis == 2)};
    const GroupIndex x = lanes::convert<std::int32_t>(from.x), y = lanes::convert<std::int32_t>(from.y),
                     z = lanes::convert<std::int32_t>(from.z);
    const GroupIndex two(2);
    return {(x - two) + (y - two) * GroupIndex(static_cast<std::int32_t>(stride_y)) +
                (z - two) * GroupIndex(static_cast<std::int32_t>(stride_z)),
            {from.x - lanes::convert<float>(x), from.y - lanes::convert<float>(y),
             from.z - lanes::convert<float>(z)}};
}

PASTOSO_LANE_FUNCTION Group lerp(Group a, Group b, Group share) {
    return a + share * (b - a);
}

/// Trilinear, of samples from the first one on.
template <class Samples>
PASTOSO_LANE_FUNCTION Group linear_of(const Samples& first, const ThreeGroups& share, std::ptrdiff_t y,
                                      std::ptrdiff_t z) {
    const Samples second = first.from(y), third = first.from(z), fourth = second.from(z);
    const Group low =
        lerp(lerp(first[0], first[1], share.x), lerp(second[0], second[1], share.x), share.y);
    const Group high =
        lerp(lerp(third[0], third[1], share.x), lerp(fourth[0], fourth[1], share.x), share.y);
    return lerp(low, high, share.z);
}

/// Catmull-Rom's weights of the samples -1, 0, 1, 2, as cubic_weights() has them.
struct GroupCubic {
    Group weight[4];
    PASTOSO_LANE_MEMBER explicit GroupCubic(Group t) {
        constexpr float kCube[] = {-0.5F, 1.5F, -1.5F, 0.5F}, kSquare[] = {1.0F, -2.5F, 2.0F, -0.5F},
                        kSingle[] = {-0.5F, 0.0F, 0.5F, 0.0F}, kConstant[] = {0.0F, 1.0F, 0.0F, 0.0F};
        for (int n = 0; n < 4; ++n)
            weight[n] = ((Group(kCube[n]) * t + Group(kSquare[n])) * t + Group(kSingle[n])) * t +
                        Group(kConstant[n]);
    }
};
struct GroupCubics {
    GroupCubic x, y, z;
    PASTOSO_LANE_MEMBER explicit GroupCubics(const ThreeGroups& share)
        : x(share.x), y(share.y), z(share.z) {}
};

template <bool kLimited, class Samples>
PASTOSO_LANE_FUNCTION Group cubic_of(const Samples& first, const GroupCubics& cubics, std::ptrdiff_t y,
                                     std::ptrdiff_t z) {
    Group columns[4] = {Group(0.0F), Group(0.0F), Group(0.0F), Group(0.0F)};
    Group low{}, high{};
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
        const Samples r0 = first.from((k - 1) * z - y), r1 = r0.from(y), r2 = r1.from(y),
                      r3 = r2.from(y);
#pragma GCC unroll 4
        for (int i = 0; i < 4; ++i) {
            const Group near = r1[i - 1], far = r2[i - 1];
            const Group rows = (r0[i - 1] * cubics.y.weight[0] + near * cubics.y.weight[1]) +
                               (far * cubics.y.weight[2] + r3[i - 1] * cubics.y.weight[3]);
            columns[i] += rows * cubics.z.weight[k];
            if (kLimited && (i == 1 || i == 2) && (k == 1 || k == 2)) {
                const Group lower = lanes::min(near, far), upper = lanes::max(near, far);
                const bool is_first = i == 1 && k == 1;
                low = is_first ? lower : lanes::min(low, lower);
                high = is_first ? upper : lanes::max(high, upper);
            }
        }
    }
    const Group value = (columns[0] * cubics.x.weight[0] + columns[1] * cubics.x.weight[1]) +
                        (columns[2] * cubics.x.weight[2] + columns[3] * cubics.x.weight[3]);
    if constexpr (kLimited) return lanes::min(lanes::max(value, low), high);
    return value;
}

/// Samples that a group reads: neighbours, one for each point.
struct BesideOneAnother {
    const float* sample;
    PASTOSO_LANE_MEMBER BesideOneAnother from(std::ptrdiff_t n) const { return {sample + n}; }
    PASTOSO_LANE_MEMBER Group operator[](int n) const { return lanes::load<Group>(sample + n); }
};
/// The same where all points have the same samples around them.
struct InOnePlace {
    const float* sample;
    PASTOSO_LANE_MEMBER InOnePlace from(std::ptrdiff_t n) const { return {sample + n}; }
    PASTOSO_LANE_MEMBER Group operator[](int n) const { return Group(sample[n]); }
};

PASTOSO_LANE_FUNCTION void store_first(float* to, Group values, int count) {
    for (int lane = 0; lane < kPointsTogether; ++lane)
        if (lane < count) to[lane] = values[lane];
}

/// Calls body(index, points) for each index that one of the first `count` points has, with the mask of
/// the points that have it.
template <class Body>
PASTOSO_LANE_FUNCTION void for_indices(const GroupIndex& index, int count, const Body& body) {
    std::int32_t of_lane[kPointsTogether];
    lanes::store(of_lane, index);
    std::uint32_t left = (1U << count) - 1;
    while (left != 0) {
        const std::int32_t next = of_lane[std::countr_zero(left)];
        const auto same = index == GroupIndex(next);
        body(next, same);
        left &= ~lanes::mask_bits(same);
    }
}

}  // namespace
}  // namespace pastoso::liquid
