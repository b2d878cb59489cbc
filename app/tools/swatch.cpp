#include "tools/swatch.hpp"

#include "pigment/colour.hpp"
#include "pigment/kubelka_munk.hpp"

#include <cmath>

namespace pastoso::tools {
namespace {

constexpr double kWhitePerPaint = 4.0;

Srgb8 opaque_colour(const pigment::Coefficients& paint) {
    pigment::Bands reflectance{};
    for (std::size_t band = 0; band < pigment::kBands; ++band) {
        reflectance[band] = pigment::through_surface(
            pigment::opaque_reflectance(paint[band], paint[band + pigment::kBands]));
    }
    const pigment::LinearRgb linear = pigment::into_gamut(pigment::linear_srgb(reflectance));
    Srgb8 encoded{};
    for (std::size_t i = 0; i < encoded.size(); ++i) {
        encoded[i] = static_cast<std::uint8_t>(std::lround(255.0 * pigment::encode_srgb(linear[i])));
    }
    return encoded;
}

}  // namespace

Swatch swatch(const pigment::Pigment& pigment) {
    const std::array<pigment::Portion, 2> with_white = {
        {{pigment.coefficients, 1.0}, {pigment::find_pigment("PW6").coefficients, kWhitePerPaint}}};
    return {opaque_colour(pigment.coefficients), opaque_colour(pigment::mix(with_white))};
}

}  // namespace pastoso::tools
