#include "shade/spot.hpp"

#include "core/check.hpp"
#include "film/state.hpp"
#include "shade/kernels.hpp"

#include <cmath>

namespace pastoso::shade {
namespace {

CellColour colour_under_even_light(const film::PaintCoefficients& paint, const Spot& spot) {
    film::PaintCell cell{};
    for (int channel = 0; channel < film::kPigmentChannels; ++channel)
        cell[channel] =
            static_cast<std::int32_t>(std::lround(paint[channel] * spot.film_mm / film::kPaintQuantum));
    const auto thickness =
        static_cast<std::int32_t>(std::lround(spot.film_mm / film::kThicknessQuantum_mm));
    CellColour colour;
    core::kernels<Kernels>().colour_cells({&cell, nullptr, &thickness, nullptr, nullptr}, 1, spot.ground,
                                          spot.viewing.to_rgb, &colour);
    return colour;
}

}  // namespace

pigment::Srgb8 spot_colour(const film::PaintCoefficients& paint, const Spot& spot) {
    PASTOSO_CHECK(spot.film_mm >= 0.0 && spot.film_mm <= film::kMaxThickness_mm);
    return lit_colour(colour_under_even_light(paint, spot), spot);
}

pigment::Srgb8 lit_colour(const CellColour& colour, const Spot& spot) {
    SurfacePoint point{};
    point.sky = 1.0F;
    point.wetness = colour.wetness;
    point.red = colour.red;
    point.green = colour.green;
    point.blue = colour.blue;
    const ShadedPoint shaded = shade(point, shading_constants(spot.lighting, 0.0));
    const pigment::Image8 pixel =
        pigment::encode_srgb8({1, 1, {shaded.red, shaded.green, shaded.blue}, spot.viewing.space});
    return {pixel.rgb[0], pixel.rgb[1], pixel.rgb[2]};
}

}  // namespace pastoso::shade
