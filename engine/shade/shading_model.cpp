#include "shade/shading_model.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <string>

namespace pastoso::shade {
namespace {

constexpr double kNormalReflection = 0.04;  // ((1.5 - 1) / (1.5 + 1))^2
/// How sharply a shadow may end: 0.05 mm at four cells a millimetre.
constexpr double kLeastSoftness_cells = 0.2;

void check_range(const core::Message& what, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw core::InputError("The light's %1 is %2, outside the range from %3 to %4.", what,
                           std::to_string(value), std::to_string(low), std::to_string(high));
}

void check(const Lighting& lighting) {
    check_range(core::message("azimuth in degrees"), lighting.azimuth_deg, -360.0, 360.0);
    check_range(core::message("elevation in degrees"), lighting.elevation_deg, 5.0, 90.0);
    check_range(core::message("ambient share"), lighting.ambient, 0.0, 1.0);
    check_range(core::message("roughness on wet paint"), lighting.wet_roughness, 0.05, 1.0);
    check_range(core::message("roughness on the dry support"), lighting.dry_roughness, 0.05, 1.0);
    check_range(core::message("shadow softness in mm"), lighting.shadow_softness_mm, 1e-4, 10.0);
}

}  // namespace

ShadingConstants shading_constants(const Lighting& lighting, double cell_mm) {
    check(lighting);
    const double azimuth = core::radians(lighting.azimuth_deg);
    const double elevation = core::radians(lighting.elevation_deg);
    const double x = std::cos(elevation) * std::cos(azimuth);
    const double y = -std::cos(elevation) * std::sin(azimuth);
    const double z = std::sin(elevation);
    const double half_length = std::sqrt(x * x + y * y + (z + 1.0) * (z + 1.0));
    const double to_half = (z + 1.0) / half_length;
    const double fresnel = kNormalReflection + (1.0 - kNormalReflection) * std::pow(1.0 - to_half, 5);
    const double direct = (1.0 - lighting.ambient) / z;
    ShadingConstants constants;
    constants.light_x = static_cast<float>(x);
    constants.light_y = static_cast<float>(y);
    constants.light_z = static_cast<float>(z);
    constants.half_x = static_cast<float>(x / half_length);
    constants.half_y = static_cast<float>(y / half_length);
    constants.half_z = static_cast<float>(to_half);
    constants.direct = static_cast<float>(direct);
    constants.ambient = static_cast<float>(lighting.ambient);
    constants.gloss = lighting.specular ? static_cast<float>(direct * core::kPi * fresnel) : 0.0F;
    constants.dry_roughness = static_cast<float>(lighting.dry_roughness);
    constants.wet_roughness = static_cast<float>(lighting.wet_roughness);
    const double softness_mm = std::max(lighting.shadow_softness_mm, kLeastSoftness_cells * cell_mm);
    constants.inverse_softness_per_mm = static_cast<float>(1.0 / softness_mm);
    return constants;
}

}  // namespace pastoso::shade
