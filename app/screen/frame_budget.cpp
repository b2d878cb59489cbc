#include "screen/frame_budget.hpp"

#include <algorithm>

namespace pastoso::screen {

void FrameBudget::measured(double samples, double seconds) {
    // A small area measures the call and not the samples.
    constexpr double kFewestSamples = 16384.0;
    if (samples < kFewestSamples) return;
    constexpr double kNewestShare = 0.3;
    constexpr double kLeastCost_s = 1e-12;
    cost_s_ = std::max(kLeastCost_s, cost_s_ + kNewestShare * (seconds / samples - cost_s_));
}

}  // namespace pastoso::screen
