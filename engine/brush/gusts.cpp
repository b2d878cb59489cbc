#include "brush/gusts.hpp"

#include "brush/smooth_noise.hpp"

namespace pastoso::brush {
namespace {

constexpr double kGusts_per_s = 12.0;

}  // namespace

Gust gust_at(std::uint32_t seed, double time_s) {
    const double passed = kGusts_per_s * time_s;
    return {smooth_noise(passed, seed), smooth_noise(passed, core::scramble(seed))};
}

}  // namespace pastoso::brush
