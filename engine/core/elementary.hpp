// Exponential and logarithm out of the four operations alone, so that every machine and every maths
// library gives the same bits. Roots are in lane_power.hpp.
#pragma once

#include <cmath>
#include <initializer_list>

namespace pastoso::core {

inline constexpr double kLn2 = 0.69314718055994530942;

/// ln(x) for finite x > 0, relative error of x below 1e-12: x = 2^k m with m in [1/sqrt2, sqrt2), and the
/// series of 2 artanh((m - 1) / (m + 1)).
inline double natural_log(double x) {
    int exponent = 0;
    double mantissa = std::frexp(x, &exponent);
    if (mantissa < 0.70710678118654752) {
        mantissa *= 2.0;
        --exponent;
    }
    const double y = (mantissa - 1.0) / (mantissa + 1.0), y2 = y * y;
    double series = 1.0 / 15.0;
    for (const double share : {1.0 / 13.0, 1.0 / 11.0, 1.0 / 9.0, 1.0 / 7.0, 1.0 / 5.0, 1.0 / 3.0, 1.0})
        series = series * y2 + share;
    return exponent * kLn2 + 2.0 * y * series;
}

/// e^x for |x| < 700, relative error below 1e-12: x = k ln2 + r with |r| <= ln2 / 2, and Taylor's series.
inline double exponential(double x) {
    const double whole = std::floor(x / kLn2 + 0.5);
    const double r = x - whole * kLn2;
    double series = 1.0;
    for (const double share : {1.0 / 12, 1.0 / 11, 1.0 / 10, 1.0 / 9, 1.0 / 8, 1.0 / 7, 1.0 / 6, 1.0 / 5,
                               1.0 / 4, 1.0 / 3, 1.0 / 2, 1.0})
        series = 1.0 + series * (r * share);
    return std::ldexp(series, static_cast<int>(whole));
}

}  // namespace pastoso::core
