// CIE Lab and colour differences, for tests of colours.
#pragma once

#include "core/units.hpp"
#include "pigment/colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pastoso::test {

using Xyz = std::array<double, 3>;

struct Lab {
    double lightness = 0, a = 0, b = 0;
    double chroma() const { return std::hypot(a, b); }
    double hue_deg() const { return std::fmod(core::degrees(std::atan2(b, a)) + 360.0, 360.0); }
};

inline double lab_curve(double t) {
    return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
}

inline Lab lab(const Xyz& colour, const Xyz& white) {
    const double x = lab_curve(colour[0] / white[0]);
    const double y = lab_curve(colour[1] / white[1]);
    const double z = lab_curve(colour[2] / white[2]);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// The white of sRGB and the matrix of its primaries (IEC 61966-2-1), not rounded to four digits.
inline Lab lab(const pigment::LinearRgb& rgb) {
    static constexpr double kToXyz[3][3] = {
        {0.4123907992659595, 0.3575843393838780, 0.1804807884018343},
        {0.2126390058715104, 0.7151686787677559, 0.0721923153607337},
        {0.0193308187155918, 0.1191947797946259, 0.9505321522496608}};
    Xyz colour{}, white{};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            colour[i] += kToXyz[i][j] * rgb[j];
            white[i] += kToXyz[i][j];
        }
    }
    return lab(colour, white);
}

inline double hue_difference_deg(double a, double b) {
    return std::abs(std::remainder(a - b, 360.0));
}

/// CIEDE2000 (Sharma, Wu, Dalal 2005), all weights 1.
inline double ciede2000(const Lab& first, const Lab& second) {
    const double mean_c7 = std::pow(0.5 * (first.chroma() + second.chroma()), 7);
    const double g = 0.5 * (1.0 - std::sqrt(mean_c7 / (mean_c7 + 6103515625.0)));
    const Lab p{first.lightness, first.a * (1 + g), first.b};
    const Lab q{second.lightness, second.a * (1 + g), second.b};
    const bool grey = p.chroma() * q.chroma() == 0.0;
    const double dh_deg = grey ? 0.0 : std::remainder(q.hue_deg() - p.hue_deg(), 360.0);
    const double mean_h_deg = grey ? p.hue_deg() + q.hue_deg() : p.hue_deg() + 0.5 * dh_deg;
    const double dl = q.lightness - p.lightness;
    const double dc = q.chroma() - p.chroma();
    const double dh = 2.0 * std::sqrt(p.chroma() * q.chroma()) * std::sin(core::radians(0.5 * dh_deg));
    const double mean_l = 0.5 * (p.lightness + q.lightness);
    const double mean_c = 0.5 * (p.chroma() + q.chroma());
    const auto cosine = [&](double factor, double shift) {
        return std::cos(core::radians(factor * mean_h_deg + shift));
    };
    const double t =
        1 - 0.17 * cosine(1, -30) + 0.24 * cosine(2, 0) + 0.32 * cosine(3, 6) - 0.20 * cosine(4, -63);
    const double from_middle = (mean_l - 50) * (mean_l - 50);
    const double sl = 1 + 0.015 * from_middle / std::sqrt(20 + from_middle);
    const double sc = 1 + 0.045 * mean_c;
    const double sh = 1 + 0.015 * mean_c * t;
    const double c7 = std::pow(mean_c, 7);
    const double blue = std::remainder(mean_h_deg - 275.0, 360.0) / 25.0;
    const double rt = -2.0 * std::sqrt(c7 / (c7 + 6103515625.0)) *
                      std::sin(core::radians(60.0 * std::exp(-blue * blue)));
    const double l = dl / sl, c = dc / sc, h = dh / sh;
    return std::sqrt(l * l + c * c + h * h + rt * c * h);
}

}  // namespace pastoso::test
