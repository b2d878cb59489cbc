#include "film/thinning.hpp"

#include "core/check.hpp"

#include <cmath>

namespace pastoso::film {
namespace {

double geometric_mean(double a, double b, double share_of_a) {
    return std::exp(share_of_a * std::log(a) + (1.0 - share_of_a) * std::log(b));
}

double drying_s_mm(const Medium& medium) {
    return medium.touch_dry_s / medium.typical_thickness_mm;
}

}  // namespace

Medium thinned(const Medium& medium, double paint_share) {
    PASTOSO_CHECK(paint_share >= kLeastPaintShare && paint_share <= 1.0);
    if (medium.thinned_with.empty() || paint_share == 1.0) return medium;
    const Medium& thinner = find_medium(medium.thinned_with);
    Medium thin = medium;
    for (const MediumNumber& number : medium_numbers()) {
        const double paint = medium.*number.member, clear = thinner.*number.member;
        thin.*number.member = paint_share * paint + (1.0 - paint_share) * clear;
    }
    thin.viscosity_m2_s = geometric_mean(medium.viscosity_m2_s, thinner.viscosity_m2_s, paint_share);
    thin.yield_stress_Pa = medium.yield_stress_Pa * std::pow(paint_share, 3.0);
    thin.pigment_share = medium.pigment_share * paint_share;
    thin.typical_thickness_mm =
        geometric_mean(medium.typical_thickness_mm, thinner.typical_thickness_mm, paint_share);
    thin.touch_dry_s = thin.typical_thickness_mm * (paint_share * drying_s_mm(medium) +
                                                    (1.0 - paint_share) * drying_s_mm(thinner));
    return thin;
}

}  // namespace pastoso::film
