// Compiled once per instruction set; see pastoso_add_kernels.
#include "core/lanes.hpp"
#include "liquid/surface/ball_kernels.hpp"

namespace pastoso::liquid::PASTOSO_ISA {
namespace {

namespace lanes = core::lanes;

constexpr int kGroup = 8;

/// The samples of [least, end) that lie within `reach` of a place.
struct Range {
    int first, end;
};
PASTOSO_LANE_FUNCTION Range within(float place, float reach, int least, int end) {
    const float first = lanes::max(__builtin_ceilf(place - reach), static_cast<float>(least));
    const float last = lanes::min(__builtin_floorf(place + reach), static_cast<float>(end - 1));
    if (!(first <= last)) return {0, 0};
    return {static_cast<int>(first), static_cast<int>(last) + 1};
}

/// Adds value(q) to the samples of a row; whole groups, since it is 0 beyond the ball.
template <class Value>
PASTOSO_LANE_FUNCTION void add_row(float* row, const Range& range, float x, float across,
                                   const Value& value) {
    for (int start = range.first; start < range.end; start += kGroup) {
        const float first = static_cast<float>(start) - x;
        for (int lane = 0; lane < kGroup; ++lane) {
            const float along = first + static_cast<float>(lane);
            row[start + lane] += value(across + along * along);
        }
    }
}

/// Adds value_of(ball)(q) to all samples that a ball reaches, ball by ball.
template <class ValueOf>
PASTOSO_LANE_FUNCTION void add_balls(const BallSlab& slab, const Ball* balls, const std::uint32_t* order,
                                     std::size_t count, const ValueOf& value_of) {
    for (std::size_t n = 0; n < count; ++n) {
        const Ball ball = balls[order[n]];
        const auto value = value_of(ball);
        const float square = ball.reach * ball.reach;
        const Range layers = within(ball.z, ball.reach, slab.first, slab.end);
        const Range rows = within(ball.y, ball.reach, 0, slab.ny);
        for (int k = layers.first; k < layers.end; ++k) {
            const float z = static_cast<float>(k) - ball.z;
            for (int j = rows.first; j < rows.end; ++j) {
                const float y = static_cast<float>(j) - ball.y;
                const float across = z * z + y * y;
                if (!(across < square)) continue;
                const Range range = within(ball.x, __builtin_sqrtf(square - across), 0, slab.nx);
                add_row(slab.values + j * slab.stride_y + k * slab.stride_z, range, ball.x, across,
                        value);
            }
        }
    }
}

}  // namespace

void add_compact(const BallSlab& slab, const Ball* balls, const std::uint32_t* order,
                 std::size_t count) {
    add_balls(slab, balls, order, count, [](const Ball& ball) {
        const float inverse = 1.0F / (ball.reach * ball.reach), strength = ball.strength;
        return [=](float q) {
            const float u = lanes::max(1.0F - q * inverse, 0.0F);
            return strength * (u * u * u);
        };
    });
}

void add_near_inverse_square(const BallSlab& slab, const Ball* balls, const std::uint32_t* order,
                             std::size_t count) {
    add_balls(slab, balls, order, count, [least = slab.least_square](const Ball& ball) {
        const float end = ball.reach * ball.reach, inverse = 1.0F / end, strength = ball.strength;
        return [=](float square) {
            const float q = lanes::max(square, least);
            const float e = q * inverse - 1.0F;
            const float smooth =
                inverse * (1.0F - e * (1.0F - e * (1.0F - e * (1.0F - e * (1.0F - e)))));
            return q < end ? strength * (1.0F / q - smooth) : 0.0F;
        };
    });
}

}  // namespace pastoso::liquid::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::liquid, BallKernels, add_compact, add_near_inverse_square)
