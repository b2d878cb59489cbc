#include "pigment/lab.hpp"

#include "core/elementary.hpp"
#include "core/units.hpp"

#include <cmath>

namespace pastoso::pigment {
namespace {

constexpr double kDark = 216.0 / 24389.0;
constexpr double kDarkSlope = 24389.0 / 27.0 / 116.0;

/// sqrt(C^7 / (C^7 + 25^7)): 0 for greys, towards 1 for vivid colours.
double vividness(double chroma) {
    const double c2 = chroma * chroma;
    const double c7 = c2 * c2 * c2 * chroma;
    return std::sqrt(c7 / (c7 + 6103515625.0));
}

/// How the tolerance of hue changes around the hue circle.
double hue_tolerance(double hue_deg) {
    const auto cosine = [&](double factor, double shift_deg) {
        return std::cos(core::radians(factor * hue_deg + shift_deg));
    };
    return 1.0 - 0.17 * cosine(1, -30) + 0.24 * cosine(2, 0) + 0.32 * cosine(3, 6) -
           0.20 * cosine(4, -63);
}

DifferenceWeights weights_at(double lightness, double chroma, double hue_deg) {
    const double from_middle = (lightness - 50.0) * (lightness - 50.0);
    return {1.0 / (1.0 + 0.015 * from_middle / std::sqrt(20.0 + from_middle)),
            1.0 / (1.0 + 0.045 * chroma), 1.0 / (1.0 + 0.015 * chroma * hue_tolerance(hue_deg))};
}

/// Blues turn: how far a difference in chroma counts as one in hue.
double blue_turn(double chroma, double hue_deg) {
    const double blue = std::remainder(hue_deg - 275.0, 360.0) / 25.0;
    return -2.0 * vividness(chroma) * std::sin(core::radians(60.0 * std::exp(-blue * blue)));
}

}  // namespace

const std::array<Xyz, 3> kSrgbToWhiteRelativeXyz = [] {
    std::array<Xyz, 3> rows = {{{0.4123907992659595, 0.3575843393838780, 0.1804807884018343},
                                {0.2126390058715104, 0.7151686787677559, 0.0721923153607337},
                                {0.0193308187155918, 0.1191947797946259, 0.9505321522496608}}};
    for (Xyz& row : rows) {
        const double white = row[0] + row[1] + row[2];
        for (double& value : row)
            value /= white;
    }
    return rows;
}();

double Lab::chroma() const {
    return std::hypot(a, b);
}

double Lab::hue_deg() const {
    return std::fmod(core::degrees(std::atan2(b, a)) + 360.0, 360.0);
}

double lab_curve(double t) {
    return t > kDark ? core::exponential(core::natural_log(t) / 3.0) : kDarkSlope * t + 16.0 / 116.0;
}

double lab_curve_slope(double t) {
    if (t <= kDark) return kDarkSlope;
    return lab_curve(t) / (3.0 * t);
}

Lab lab(const Xyz& colour, const Xyz& white) {
    const double x = lab_curve(colour[0] / white[0]);
    const double y = lab_curve(colour[1] / white[1]);
    const double z = lab_curve(colour[2] / white[2]);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double relative_luminance(const LinearRgb& colour) {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
        sum += kSrgbToWhiteRelativeXyz[1][i] * colour[i];
    return sum;
}

Lab lab(const LinearRgb& colour) {
    Xyz relative{};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            relative[i] += kSrgbToWhiteRelativeXyz[i][j] * colour[j];
    }
    return lab(relative, {1.0, 1.0, 1.0});
}

double ciede2000(const Lab& first, const Lab& second) {
    const double stretch = 1.5 - 0.5 * vividness(0.5 * (first.chroma() + second.chroma()));
    const Lab p{first.lightness, first.a * stretch, first.b};
    const Lab q{second.lightness, second.a * stretch, second.b};
    const double p_chroma = p.chroma(), q_chroma = q.chroma();
    const double p_hue_deg = p.hue_deg(), q_hue_deg = q.hue_deg();
    const bool grey = p_chroma * q_chroma == 0.0;
    const double turn_deg = grey ? 0.0 : std::remainder(q_hue_deg - p_hue_deg, 360.0);
    const double mean_hue_deg = grey ? p_hue_deg + q_hue_deg : p_hue_deg + 0.5 * turn_deg;
    const double mean_chroma = 0.5 * (p_chroma + q_chroma);
    const DifferenceWeights weights =
        weights_at(0.5 * (p.lightness + q.lightness), mean_chroma, mean_hue_deg);
    const double l = weights.lightness * (q.lightness - p.lightness);
    const double c = weights.chroma * (q_chroma - p_chroma);
    const double h =
        weights.hue * 2.0 * std::sqrt(p_chroma * q_chroma) * std::sin(core::radians(0.5 * turn_deg));
    return std::sqrt(l * l + c * c + h * h + blue_turn(mean_chroma, mean_hue_deg) * c * h);
}

DifferenceWeights difference_weights(const Lab& colour) {
    return weights_at(colour.lightness, colour.chroma(), colour.hue_deg());
}

}  // namespace pastoso::pigment
