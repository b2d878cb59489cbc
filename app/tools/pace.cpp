#include "tools/pace.hpp"

#include <algorithm>
#include <iterator>

namespace pastoso::tools {
namespace {

constexpr double kLasting_s = 1.0;
constexpr double kMargin = 1.1;

/// The least share that is still told as a half, a third and so on, the first as all: between two, the
/// root of their product; the last between a tenth and a twentieth.
constexpr double kLeast[] = {0.77, 0.408, 0.289, 0.224, 0.141, 0.071};

Pace nearest(double share) {
    const auto* found = std::find_if(std::begin(kLeast), std::end(kLeast),
                                     [share](double least) { return share >= least; });
    return static_cast<Pace>(found - std::begin(kLeast));
}

}  // namespace

Pace PaceWatch::look(double share, double now_s) {
    const Pace seen = std::clamp(told_, nearest(share * kMargin), nearest(share / kMargin));
    if (now_s - right_s_ >= kLasting_s) told_ = seen;
    if (seen == told_) right_s_ = now_s;
    return told_;
}

}  // namespace pastoso::tools
