// What nobody holds quite still: values by a hash at whole places, joined smoothly.
#pragma once

#include "core/random.hpp"

#include <cmath>
#include <cstdint>

namespace pastoso::brush {

/// -1 to 1; between whole places by 3 t^2 - 2 t^3. place >= 0. Streams are independent of each other.
inline double smooth_noise(double place, std::uint32_t stream) {
    const double whole = std::floor(place), t = place - whole;
    const double share = t * t * (3.0 - 2.0 * t);
    const auto value = [stream](double at) {
        return 2.0 * core::uniform_noise(static_cast<std::uint32_t>(at), stream) - 1.0;
    };
    return (1.0 - share) * value(whole) + share * value(whole + 1.0);
}

}  // namespace pastoso::brush
