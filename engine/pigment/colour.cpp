#include "pigment/colour.hpp"

#include "core/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::pigment {
namespace {

float luminance(const LinearRgb& colour, WorkingSpace space) {
    const std::array<float, 3> weights = luminance_weights(space);
    float sum = 0.0F;
    for (int i = 0; i < 3; ++i)
        sum += weights[i] * colour[i];
    return sum;
}

/// The largest share of `colour` in a mixture with `grey` (0 to 1) that keeps every channel within [0,
/// 1].
float fitting_share(const LinearRgb& colour, float grey) {
    float share = 1.0F;
    for (const float channel : colour) {
        if (channel > 1.0F) share = std::min(share, (1.0F - grey) / (channel - grey));
        if (channel < 0.0F) share = std::min(share, grey / (grey - channel));
    }
    return share;
}

}  // namespace

LinearRgb seen_colour(const Bands& reflectance, const BandsToRgb& to_rgb) {
    LinearRgb colour{};
    for (int i = 0; i < 3; ++i) {
        for (int band = 0; band < kBands; ++band)
            colour[i] += to_rgb[i][band] * reflectance[band];
    }
    return colour;
}

LinearRgb linear_srgb(const Bands& reflectance) {
    return seen_colour(reflectance, kBandsToLinearSrgb);
}

LinearRgb into_gamut(const LinearRgb& colour, WorkingSpace space) {
    const float grey = std::clamp(luminance(colour, space), 0.0F, 1.0F);
    const float share = fitting_share(colour, grey);
    LinearRgb mapped{};
    for (int i = 0; i < 3; ++i) {
        const float clipped = std::clamp(colour[i], 0.0F, 1.0F);
        const float desaturated = grey + share * (colour[i] - grey);
        // A channel that is outside by less than rounding tells needs no share of grey.
        mapped[i] = share == 1.0F ? clipped : std::clamp(0.5F * (clipped + desaturated), 0.0F, 1.0F);
    }
    return mapped;
}

double encode_srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double decode_srgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92
                              : core::exponential(2.4 * core::natural_log((encoded + 0.055) / 1.055));
}

}  // namespace pastoso::pigment
