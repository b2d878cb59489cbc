// Points that fill a square evenly, however many there are: the R2 sequence (M. Roberts 2018, "The
// unreasonable effectiveness of quasirandom sequences"). Point n is fraction(x0 + n kR2StepX),
// fraction(y0 + n kR2StepY).
#pragma once

#include <cmath>

namespace pastoso::core {

/// 1 / g and 1 / g^2, g^3 = g + 1.
inline constexpr double kR2StepX = 0.7548776662466927, kR2StepY = 0.5698402909980532;

inline double fraction(double x) {
    return x - std::floor(x);
}

}  // namespace pastoso::core
