// How fast paint dries, and where.
#pragma once

namespace pastoso::film {

/// How fast paint dries. A fan makes it faster, over the whole canvas or within a disc, from whose
/// middle its effect falls off smoothly: 1 + (fan - 1) (1 - (d / radius)^2)^2.
struct DryingAir {
    double speed = 0.0;  ///< seconds of drying in a second of paint time: 0 never, 1 as in a quiet room
    double fan = 1.0;    ///< in the middle, 1 (none) to 1000
    double fan_x_mm = 0.0, fan_y_mm = 0.0;
    double fan_radius_mm = 0.0;  ///< 0: over all
    friend bool operator==(const DryingAir&, const DryingAir&) = default;

    double rate_at(double x_mm, double y_mm) const;
};

}  // namespace pastoso::film
