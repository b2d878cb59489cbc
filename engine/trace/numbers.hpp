// Exponential, logarithm, sine and cosine in single precision out of additions and multiplications
// alone, so that every machine and every maths library gives the same bits; and a few helpers for
// vectors.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pastoso::trace {

inline constexpr float kPi = 3.14159265358979F;
inline constexpr float kFar = 1e30F;

/// e^x, relative error below 3e-7; 0 below -87, and x is at most 88.
inline float fast_exp(float x) {
    if (x < -87.0F) return 0.0F;
    const float shifted = x * 1.44269504F + (x < 0.0F ? -0.5F : 0.5F);
    const int whole = static_cast<int>(shifted);
    const auto w = static_cast<float>(whole);
    const float r = (x - w * 0.693359375F) + w * 2.12194440e-4F;  // ln 2 in two parts
    float series = 1.0F / 720.0F;
    for (const float share : {1.0F / 120.0F, 1.0F / 24.0F, 1.0F / 6.0F, 0.5F, 1.0F, 1.0F})
        series = series * r + share;
    return series * std::bit_cast<float>((whole + 127) << 23);
}

/// ln x for normal x > 0, absolute error below 2e-7 (1 + |ln x|).
inline float fast_log(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    int exponent = static_cast<int>(bits >> 23) - 127;
    float mantissa = std::bit_cast<float>((bits & 0x007FFFFFU) | 0x3F800000U);
    if (mantissa > 1.41421356F) {
        mantissa *= 0.5F;
        ++exponent;
    }
    const float y = (mantissa - 1.0F) / (mantissa + 1.0F), y2 = y * y;
    float series = 1.0F / 9.0F;
    for (const float share : {1.0F / 7.0F, 1.0F / 5.0F, 1.0F / 3.0F, 1.0F})
        series = series * y2 + share;
    return static_cast<float>(exponent) * 0.69314718F + 2.0F * y * series;
}

/// Cosine and sine of `turns` full turns, 0 <= turns <= 1, absolute error below 3e-7.
inline glm::vec2 cos_sin_of_turns(float turns) {
    const int quarter = static_cast<int>(turns * 4.0F + 0.5F);
    const float a = (turns - static_cast<float>(quarter) * 0.25F) * (2.0F * kPi), a2 = a * a;
    const float sine =
        a * (1.0F - a2 * (1.0F / 6 - a2 * (1.0F / 120 - a2 * (1.0F / 5040 - a2 / 362880))));
    const float cosine = 1.0F - a2 * (0.5F - a2 * (1.0F / 24 - a2 * (1.0F / 720 - a2 / 40320)));
    switch (quarter & 3) {
        case 0:
            return {cosine, sine};
        case 1:
            return {-sine, cosine};
        case 2:
            return {-cosine, -sine};
        default:
            return {sine, -cosine};
    }
}

inline glm::vec3 fast_exp(const glm::vec3& x) {
    return {fast_exp(x.x), fast_exp(x.y), fast_exp(x.z)};
}

inline float largest(const glm::vec3& v) {
    return std::max({v.x, v.y, v.z});
}

/// Two unit vectors that with the unit vector n make a right-handed frame (Duff et al. 2017).
struct Frame {
    explicit Frame(const glm::vec3& n) {
        const float sign = std::copysign(1.0F, n.z);
        const float a = -1.0F / (sign + n.z), b = n.x * n.y * a;
        u = {1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x};
        v = {b, sign + n.y * n.y * a, -n.y};
    }
    glm::vec3 u, v;
};

}  // namespace pastoso::trace
