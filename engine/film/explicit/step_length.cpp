#include "film/explicit/step_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pastoso::film {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::max();
constexpr double kAdvectionCourant = 0.25;

/// What a film's viscosity is, over that at a shear rate of 1/s, where the wall is sheared so fast.
double thinned_viscosity(double flow_index, double shear_per_s) {
    if (flow_index == 1.0) return 1.0;
    const double rate = std::clamp<double>(shear_per_s, kSlowestShear, kFastestShear);
    return (2.0 * flow_index + 1.0) / (3.0 * flow_index) * std::pow(rate, flow_index - 1.0);
}
double thinnest_viscosity(double flow_index) {
    return thinned_viscosity(flow_index, kFastestShear);
}

}  // namespace

double StepLimits::wave_step_s(double thickness_mm, double drag_rate) const {
    const double wave_number2 = 8.0 / (cell_mm * cell_mm);
    const double w2 = thickness_mm * wave_number2 * (gravity_mm_s2 + tension * wave_number2);
    if (w2 <= 0.0) return kUnlimited;
    return (drag_rate + std::sqrt(drag_rate * drag_rate + 4.0 * w2)) / w2;
}

double StepLimits::fastest_speed_mm_s(double thickness_mm, double viscosity, double yield_stress) const {
    const double driving = std::max(force_mm_s2 * thickness_mm - yield_stress, 0.0);
    const double newtonian = driving * thickness_mm / (smallest_drag * viscosity);
    if (flow_index == 1.0) return newtonian;
    return newtonian / thinned_viscosity(flow_index, std::pow(driving / viscosity, 1.0 / flow_index));
}

double StepLimits::fastest_speed_mm_s(double thickness_mm) const {
    return fastest_speed_mm_s(thickness_mm, viscosity_mm2_s, yield);
}

double StepLimits::newtonian_step_s(double thickness_mm) const {
    if (thickness_mm <= 0.0) return kUnlimited;
    const double least_viscosity = viscosity_mm2_s * thinnest_viscosity(flow_index);
    return wave_step_s(thickness_mm, smallest_drag * least_viscosity / (thickness_mm * thickness_mm));
}

double StepLimits::resting_step_s(double thickest_mm, double largest_h3_per_viscosity) const {
    if (largest_h3_per_viscosity <= 0.0) return kUnlimited;
    const double drag = smallest_drag * thinnest_viscosity(flow_index);
    return wave_step_s(thickest_mm, thickest_mm * drag / largest_h3_per_viscosity);
}

double StepLimits::advection_step_s(double speed_mm_s) const {
    return speed_mm_s > 0.0 ? kAdvectionCourant * cell_mm / speed_mm_s : kUnlimited;
}

double StepLimits::flowing_step_s(const FlowExtremes& extremes) const {
    if (extremes.mobility <= 0.0F) return kUnlimited;
    const double drag_rate = extremes.thickness_mm / extremes.mobility;
    const double waves = wave_step_s(extremes.thickness_mm, drag_rate);
    return std::min(waves, advection_step_s(extremes.speed_mm_s));
}

}  // namespace pastoso::film
