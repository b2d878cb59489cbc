// What makes a jet of air waver.
#pragma once

#include <cstdint>

namespace pastoso::brush {

/// How far a jet is off its place, each from -1 to 1.
struct Gust {
    double x = 0.0, y = 0.0;
};

/// The gust at a time of a stroke: smooth noise, twelve values a second. Breath is as turbulent as that,
/// and paint that it drives runs in bends.
Gust gust_at(std::uint32_t seed, double time_s);

}  // namespace pastoso::brush
