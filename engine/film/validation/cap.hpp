// Caps of circles and spheres, as drops without gravity have them.
#pragma once

namespace pastoso::film::validation {

/// A spherical cap, or the arc of a circle in a plane.
struct Cap {
    double base_mm = 1.0;    ///< radius of its base
    double height_mm = 0.1;  ///< up to the radius of the base

    static Cap of_slope(double base_mm, double slope);
    /// The spherical cap on this base that holds the volume.
    static Cap of_volume(double base_mm, double volume_mm3);

    double sphere_mm() const;             ///< radius of the sphere
    double h(double r_mm) const;          ///< its thickness at the distance r from the middle
    double radius_at(double h_mm) const;  ///< the other way round
    double volume_mm3() const;            ///< of the spherical cap
    double section_mm2() const;           ///< of the arc in a plane
};

}  // namespace pastoso::film::validation
