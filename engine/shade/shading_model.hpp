// The shading equation, for one point of the picture. The window's shader computes the same from the
// same five layers of cell values (cell_layers.hpp), and on both sides of outlines (outline_layers.hpp);
// lengths in mm, directions in the image's frame: x right, y down, z out of the canvas.
//
//   n   = (-h_x, -h_y, 1) / sqrt(1 + h_x^2 + h_y^2)    normal; h from the B-spline (grid/bspline.hpp)
//   V   = 1 - smoothstep(0, softness, shadow - h)       share of the light that arrives
//   E   = (1 - ambient) <n.l> V / sin(elevation) + ambient sky
//   a^2 = (dry_roughness + (wet_roughness - dry_roughness) wetness)^2 + s^2
//   L   = colour E + (1 - ambient) pi / sin(elevation) <n.l> V D G' F
//   rgb = shoulder(L) = L <= 0.85 ? L : 0.85 + (L - 0.85) / (1 + (L - 0.85) / 0.15)
//
// Within two cells the slope varies by s^2 = |2 H|^2 / 12, H the change of the gradient over one. A
// cliff that is no wider is seen as the mean over it: highlights get as much broader as facets of that
// slope would make them (a^2 of Beckmann is twice the variance along each axis; Kaplanyan et al. 2016,
// "Filtering distributions of normals for shading antialiasing"), and of the light falls
//
//   <x> = (x + sqrt(x^2 + 2 s_l^2 / pi)) / 2,    s_l^2 = |2 H l_xy|^2 n_z^2 / 12,
//
// which is max(0, x) where x varies little, and exact in the middle of the terminator.
//
// A flat, matt canvas shows its colours as they are: E = 1. D is the GGX distribution (Walter et al.
// 2007), D = a^2 / (pi ((n.m)^2 (a^2 - 1) + 1)^2), with the half vector m; G' = G / (4 n.l n.v) is
// Smith's height-correlated masking in the form of Heitz (2014); F is Schlick's Fresnel term of a binder
// of index 1.5. The eye and the light are far away, so l, m and F are the same everywhere. The shoulder
// is what film does to highlights: white relief keeps its drawing instead of being cut off at 1.
#pragma once

#include "core/units.hpp"
#include "shade/render.hpp"

#include <cmath>

namespace pastoso::shade {

/// A Lighting as the equation uses it.
struct ShadingConstants {
    float light_x = 0, light_y = 0, light_z = 1;  ///< towards the light, unit length
    float half_x = 0, half_y = 0, half_z = 1;     ///< m, between the light and the eye
    float direct = 0;                             ///< (1 - ambient) / sin(elevation)
    float ambient = 0;
    float gloss = 0;  ///< direct pi F; 0 without highlights
    float dry_roughness = 0, wet_roughness = 0;
    float inverse_softness_per_mm = 0;
};

/// On cells of this size, or 0: where a shadow ends is known to a fifth of one, so that it is never
/// drawn sharper. Throws InputError when a value is outside the range that Lighting states.
ShadingConstants shading_constants(const Lighting& lighting, double cell_mm);

/// What the layers give at one point.
struct SurfacePoint {
    float height_mm, slope_x, slope_y;  ///< h and its gradient
    float bend_xx, bend_xy, bend_yy;    ///< change of the gradient over a cell
    float shadow_mm;                    ///< height below which the light does not reach
    float sky;                          ///< share of the sky's light that arrives, 0 to 1
    float wetness;                      ///< 0 to 1; values beyond are cut
    float red, green, blue;             ///< colour under even light, linear sRGB
};

struct ShadedPoint {
    float red, green, blue;
};

[[gnu::always_inline]] inline float clamp_to_unit(float value) {
    const float not_negative = value > 0.0F ? value : 0.0F;
    return not_negative < 1.0F ? not_negative : 1.0F;
}

/// The share of the light that reaches a point, from how deep it lies in the shadow.
[[gnu::always_inline]] inline float visibility(float depth_mm, const ShadingConstants& light) {
    const float t = clamp_to_unit(depth_mm * light.inverse_softness_per_mm);
    return 1.0F - t * t * (3.0F - 2.0F * t);
}

/// D G' of the equation. The three cosines are with the light, the eye and the half vector.
[[gnu::always_inline]] inline float ggx(float a2, float light, float eye, float half) {
    constexpr float kInversePi = static_cast<float>(1.0 / core::kPi);
    const float spread = half * half * (a2 - 1.0F) + 1.0F;
    const float masking = light * std::sqrt(eye * eye * (1.0F - a2) + a2) +
                          eye * std::sqrt(light * light * (1.0F - a2) + a2);
    return kInversePi * a2 / (spread * spread) * 0.5F / masking;
}

/// What is narrower than this is seen as the mean over it: no relief of half a wave a cell is more than
/// the rounding of paint to cells.
inline constexpr float kSpan_cells = 2.0F;

/// s^2 of the equation.
[[gnu::always_inline]] inline float slope_variance(const SurfacePoint& point) {
    return (point.bend_xx * point.bend_xx + 2.0F * point.bend_xy * point.bend_xy +
            point.bend_yy * point.bend_yy) *
           (kSpan_cells * kSpan_cells / 12.0F);
}

/// <n.l> of the equation; `eye` is n_z.
[[gnu::always_inline]] inline float mean_lit(float to_light, float eye, const SurfacePoint& point,
                                             const ShadingConstants& light) {
    constexpr float kShare = static_cast<float>(2.0 / core::kPi / 12.0) * kSpan_cells * kSpan_cells;
    const float x = (point.bend_xx * light.light_x + point.bend_xy * light.light_y) * eye;
    const float y = (point.bend_xy * light.light_x + point.bend_yy * light.light_y) * eye;
    return 0.5F * (to_light + std::sqrt(to_light * to_light + kShare * (x * x + y * y)));
}

[[gnu::always_inline]] inline float shoulder(float value) {
    constexpr float kKnee = 0.85F;
    const float above = value > kKnee ? value - kKnee : 0.0F;
    return value - above + above / (1.0F + above * (1.0F / (1.0F - kKnee)));
}

[[gnu::always_inline]] inline ShadedPoint shade(const SurfacePoint& point,
                                                const ShadingConstants& light) {
    const float inverse_length =
        1.0F / std::sqrt(1.0F + point.slope_x * point.slope_x + point.slope_y * point.slope_y);
    const float to_light =
        (light.light_z - point.slope_x * light.light_x - point.slope_y * light.light_y) * inverse_length;
    const float to_half =
        (light.half_z - point.slope_x * light.half_x - point.slope_y * light.half_y) * inverse_length;
    const float lit = mean_lit(to_light, inverse_length, point, light);
    const float arriving = lit * visibility(point.shadow_mm - point.height_mm, light);
    const float roughness =
        light.dry_roughness + (light.wet_roughness - light.dry_roughness) * clamp_to_unit(point.wetness);
    const float diffuse = light.direct * arriving + light.ambient * point.sky;
    const float a2 = roughness * roughness + slope_variance(point);
    const float highlight =
        light.gloss * arriving * ggx(a2 < 1.0F ? a2 : 1.0F, lit, inverse_length, to_half);
    return {shoulder(point.red * diffuse + highlight), shoulder(point.green * diffuse + highlight),
            shoulder(point.blue * diffuse + highlight)};
}

}  // namespace pastoso::shade
