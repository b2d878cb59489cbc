// Round films in the middle of a square canvas.
#pragma once

#include "film/validation/bench.hpp"
#include "film/validation/case.hpp"

#include <functional>

namespace pastoso::film::validation {

/// Cell means of a thickness that depends on the distance r from the middle.
void fill_round(Bench& bench, const std::function<double(double r_mm)>& thickness_mm);

/// Where the film, seen from the middle, has thinned to `h_mm` in a direction; between cells it is
/// linear.
double radius_towards(const Bench& bench, double angle_deg, double h_mm);

/// Thickness over the distance from the middle, to the right.
Curve radial_profile(const Bench& bench);

}  // namespace pastoso::film::validation
