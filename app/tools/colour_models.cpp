#include "tools/colour_models.hpp"

#include "core/units.hpp"
#include "tools/marked_words.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::tools {
namespace {

using pigment::LinearRgb;
using pigment::Srgb8;

std::uint8_t byte(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

/// Smith, Color Gamut Transform Pairs, SIGGRAPH 1978.
Channels hsv_from(const Srgb8& colour) {
    const double r = colour[0], g = colour[1], b = colour[2];
    const double most = std::max({r, g, b}), spread = most - std::min({r, g, b});
    if (spread == 0.0) return {0.0, 0.0, most / 2.55};
    double hue = (r - g) / spread + 4.0;
    if (most == r)
        hue = (g - b) / spread;
    else if (most == g)
        hue = (b - r) / spread + 2.0;
    return {turned_deg(60.0 * hue), 100.0 * spread / most, most / 2.55};
}

Srgb8 from_hsv(const Channels& hsv) {
    const double value = 2.55 * hsv[2], share = hsv[1] / 100.0;
    const auto channel = [&](double place) {
        const double sector = turned_deg(hsv[0] + 60.0 * place) / 60.0;
        return byte(value * (1.0 - share * std::clamp(std::min(sector, 4.0 - sector), 0.0, 1.0)));
    };
    return {channel(5.0), channel(3.0), channel(1.0)};
}

/// B. Ottosson, "A perceptual color space for image processing", 2020: the matrices for linear sRGB.
Channels oklab_from(const LinearRgb& rgb) {
    const double r = rgb[0], g = rgb[1], b = rgb[2];
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

LinearRgb from_oklab(const Channels& lab) {
    const auto cubed = [&](double a, double b) {
        const double root = lab[0] + a * lab[1] + b * lab[2];
        return root * root * root;
    };
    const double l = cubed(0.3963377774, 0.2158037573), m = cubed(-0.1055613458, -0.0638541728),
                 s = cubed(-0.0894841775, -1.2914855480);
    return {static_cast<float>(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            static_cast<float>(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            static_cast<float>(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

Channels oklch_from(const Srgb8& colour) {
    constexpr double kGrey = 5e-4;
    const Channels lab = oklab(colour);
    const double chroma = std::hypot(lab[1], lab[2]);
    const bool grey = chroma < kGrey;
    return {100.0 * lab[0], grey ? 0.0 : chroma,
            grey ? 0.0 : turned_deg(core::degrees(std::atan2(lab[2], lab[1])))};
}

LinearRgb linear_from_oklch(const Channels& lch) {
    const double hue = core::radians(lch[2]);
    return from_oklab({lch[0] / 100.0, lch[1] * std::cos(hue), lch[1] * std::sin(hue)});
}

Srgb8 from_oklch(const Channels& lch) {
    return pigment::encoded(linear_from_oklch(lch));
}

constexpr ChannelTexts kRgb = {{{"R", PASTOSO_WORDS("Red"), 255.0, 0},
                                {"G", PASTOSO_WORDS("Green"), 255.0, 0},
                                {"B", PASTOSO_WORDS("Blue"), 255.0, 0}}};
constexpr ChannelTexts kHsv = {{{"H", PASTOSO_WORDS("Hue, degrees"), 360.0, 0},
                                {"S", PASTOSO_WORDS("Saturation, %"), 100.0, 0},
                                {"V", PASTOSO_WORDS("Value, %"), 100.0, 0}}};
constexpr ChannelTexts kOklch = {{{"L", PASTOSO_WORDS("Lightness as it is seen, %"), 100.0, 1},
                                  {"C", PASTOSO_WORDS("Chroma: how far from grey"), 0.4, 3},
                                  {"H", PASTOSO_WORDS("Hue, degrees"), 360.0, 0}}};

}  // namespace

const ChannelTexts& channels_of(ColourModel model) {
    return model == ColourModel::Rgb ? kRgb : model == ColourModel::Hsv ? kHsv : kOklch;
}

Channels channels_from(ColourModel model, const Srgb8& colour) {
    switch (model) {
        case ColourModel::Hsv:
            return hsv_from(colour);
        case ColourModel::Oklch:
            return oklch_from(colour);
        default:
            return {static_cast<double>(colour[0]), static_cast<double>(colour[1]),
                    static_cast<double>(colour[2])};
    }
}

Srgb8 colour_from(ColourModel model, const Channels& channels) {
    switch (model) {
        case ColourModel::Hsv:
            return from_hsv(channels);
        case ColourModel::Oklch:
            return from_oklch(channels);
        default:
            return {byte(channels[0]), byte(channels[1]), byte(channels[2])};
    }
}

Channels oklab(const Srgb8& colour) {
    return oklab_from(pigment::decoded(colour));
}

Srgb8 colour_of_oklab(const Channels& lab) {
    return pigment::encoded(from_oklab(lab));
}

double turned_deg(double angle_deg) {
    return angle_deg - 360.0 * std::floor(angle_deg / 360.0);
}

bool in_srgb(const Channels& oklch) {
    constexpr float kSlack = 1e-6F;  // the corners of sRGB themselves miss 0 and 1 by less, as floats
    const LinearRgb rgb = linear_from_oklch(oklch);
    return std::all_of(rgb.begin(), rgb.end(),
                       [](float value) { return value >= -kSlack && value <= 1.0F + kSlack; });
}

double most_chroma(double lightness, double hue_deg) {
    double inside = 0.0, outside = kOklch[1].most;
    if (lightness <= 0.0 || !in_srgb({lightness, inside, hue_deg})) return 0.0;
    while (outside - inside > 1e-4) {
        const double middle = 0.5 * (inside + outside);
        (in_srgb({lightness, middle, hue_deg}) ? inside : outside) = middle;
    }
    return inside;
}

}  // namespace pastoso::tools
