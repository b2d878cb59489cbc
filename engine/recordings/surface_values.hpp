// What files for other programs tell of a surface.
#pragma once

#include "shade/render.hpp"

#include <array>
#include <cmath>

namespace pastoso::recordings {

/// The unit normal: x right, y up, z out of the canvas.
inline std::array<float, 3> surface_normal(const shade::SurfaceSample& sample) {
    const float scale =
        1.0F / std::sqrt(1.0F + sample.slope_x * sample.slope_x + sample.slope_y * sample.slope_y);
    return {-sample.slope_x * scale, sample.slope_y * scale, scale};
}

/// Roughness as 3D programs have it, the square root of GGX's alpha, which lies between those of the dry
/// and the wet surface by the wetness.
inline float surface_roughness(const shade::SurfaceSample& sample, const shade::Lighting& lighting) {
    const auto dry = static_cast<float>(lighting.dry_roughness);
    const auto wet = static_cast<float>(lighting.wet_roughness);
    return std::sqrt(dry + (wet - dry) * sample.wetness);
}

/// The picture of a surface without light and shade.
inline pigment::LinearImage surface_colours(const shade::SurfaceSamples& surface,
                                            pigment::WorkingSpace space) {
    pigment::LinearImage image{surface.width, surface.height, {}, space};
    image.rgb.reserve(3 * surface.samples.size());
    for (const shade::SurfaceSample& sample : surface.samples)
        image.rgb.insert(image.rgb.end(), {sample.red, sample.green, sample.blue});
    return image;
}

}  // namespace pastoso::recordings
