// How a trembling hand is steadied, as the painter chooses it.
#pragma once

#include "brush/pen_filter.hpp"

#include <algorithm>

namespace pastoso::tools {

enum class SteadyMode {
    Off,    ///< the brush's own smoothing alone
    Time,   ///< the brush lags behind
    String  ///< the brush is pulled on a string
};

inline constexpr double kMostSmoothing_ms = 400.0;
inline constexpr double kLongestString_mm = 20.0;

/// Each mode keeps its strength while another is chosen.
struct Steadying {
    SteadyMode mode = SteadyMode::Off;
    double smoothing_ms = 80.0;  ///< above 0, at most kMostSmoothing_ms
    double string_mm = 5.0;      ///< above 0, at most kLongestString_mm
    friend bool operator==(const Steadying&, const Steadying&) = default;
};

inline brush::Stabiliser stabiliser_of(const Steadying& steadying) {
    return {steadying.mode == SteadyMode::Time ? steadying.smoothing_ms : 0.0,
            steadying.mode == SteadyMode::String ? steadying.string_mm : 0.0};
}

/// What shows a stabiliser that came from elsewhere, as far as these strengths go; a string counts for
/// more than smoothing.
inline Steadying with_stabiliser(Steadying steadying, const brush::Stabiliser& stabiliser) {
    if (stabiliser.smoothing_ms > 0.0)
        steadying.smoothing_ms = std::min(stabiliser.smoothing_ms, kMostSmoothing_ms);
    if (stabiliser.string_mm > 0.0)
        steadying.string_mm = std::min(stabiliser.string_mm, kLongestString_mm);
    steadying.mode = stabiliser.string_mm > 0.0      ? SteadyMode::String
                     : stabiliser.smoothing_ms > 0.0 ? SteadyMode::Time
                                                     : SteadyMode::Off;
    return steadying;
}

}  // namespace pastoso::tools
