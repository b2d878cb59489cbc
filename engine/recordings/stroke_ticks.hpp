// When the samples of a stroke are applied, if its recording does not say.
#pragma once

#include "document/events.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pastoso::recordings {

/// The tick that has begun at `time_s`, but no earlier than `least`.
inline std::int64_t tick_of_time(double time_s, std::int64_t least) {
    return std::max(least, static_cast<std::int64_t>(std::floor(time_s / document::kTick_s)));
}

}  // namespace pastoso::recordings
