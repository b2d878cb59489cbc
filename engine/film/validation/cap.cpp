#include "film/validation/cap.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film::validation {

Cap Cap::of_slope(double base_mm, double slope) {
    return {base_mm, base_mm * std::tan(0.5 * std::atan(slope))};
}

Cap Cap::of_volume(double base_mm, double volume_mm3) {
    double low = 0.0, high = base_mm;
    for (int i = 0; i < 60; ++i) {
        const double height = 0.5 * (low + high);
        (Cap{base_mm, height}.volume_mm3() < volume_mm3 ? low : high) = height;
    }
    return {base_mm, low};
}

double Cap::sphere_mm() const {
    return (base_mm * base_mm + height_mm * height_mm) / (2.0 * height_mm);
}

double Cap::h(double r_mm) const {
    if (r_mm >= base_mm) return 0.0;
    const double sphere = sphere_mm();
    return std::max(0.0, std::sqrt(sphere * sphere - r_mm * r_mm) - (sphere - height_mm));
}

double Cap::radius_at(double h_mm) const {
    const double sphere = sphere_mm(), above = sphere - height_mm + h_mm;
    return std::sqrt(std::max(0.0, sphere * sphere - above * above));
}

double Cap::volume_mm3() const {
    return core::kPi * height_mm / 6.0 * (3.0 * base_mm * base_mm + height_mm * height_mm);
}

double Cap::section_mm2() const {
    const double half_angle = 2.0 * std::atan(height_mm / base_mm), sphere = sphere_mm();
    return sphere * sphere * (half_angle - std::sin(half_angle) * std::cos(half_angle));
}

}  // namespace pastoso::film::validation
