#include "film/cell/paint_cell.hpp"

#include "film/medium.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film {

PaintCoefficients paint_coefficients(const pigment::Coefficients& pigment, const Medium& medium) {
    PaintCoefficients paint{};
    std::transform(pigment.begin(), pigment.end(), paint.begin(), [&](float full_strength) {
        return full_strength * static_cast<float>(medium.pigment_share);
    });
    const double viscosity_m2_s = std::max(medium.viscosity_m2_s, kThinnest_m2_s);
    paint[kViscosityChannel] = static_cast<float>(std::log(viscosity_m2_s / kThinnest_m2_s));
    paint[kYieldChannel] = static_cast<float>(medium.yield_stress_Pa);
    paint[kSolidsChannel] = static_cast<float>(medium.solid_fraction);
    paint[kDryingChannel] =
        static_cast<float>(medium.touch_dry_s / 3600.0 / medium.typical_thickness_mm);
    return paint;
}

}  // namespace pastoso::film
