#include "brush/gusts.hpp"

#include "core/random.hpp"

#include <cmath>

namespace pastoso::brush {
namespace {

constexpr double kGusts_per_s = 12.0;

double around_zero(std::uint32_t index, std::uint32_t seed) {
    return 2.0 * core::uniform_noise(index, seed) - 1.0;
}

}  // namespace

Gust gust_at(std::uint32_t seed, double time_s) {
    const double passed = kGusts_per_s * time_s;
    const double t = passed - std::floor(passed);
    const double share = t * t * (3.0 - 2.0 * t);
    const auto at = [&](std::uint32_t axis) {
        const std::uint32_t index = 2 * static_cast<std::uint32_t>(passed) + axis;
        return (1.0 - share) * around_zero(index, seed) + share * around_zero(index + 2, seed);
    };
    return {at(0), at(1)};
}

}  // namespace pastoso::brush
