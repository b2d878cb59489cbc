// A jet of air that pushes wet paint about.
#pragma once

#include "grid/shape.hpp"

namespace pastoso::film {

/// Presses on the paint with
///
///     p(x) = pressure e^(-(d/r)^2) (1 - |lean| - 2 lean . (x - middle) / r),   d = |x - middle|,
///
/// which drives paint outwards while the jet stands upright. One that leans presses at its heel and
/// sucks at its toe, and so carries paint along to where it blows. Beyond three radii nothing is felt.
struct AirJet {
    double x_mm = 0.0, y_mm = 0.0;      ///< of the middle
    double radius_mm = 10.0;            ///< r, > 0
    double pressure_Pa = 0.0;           ///< >= 0
    double lean_x = 0.0, lean_y = 0.0;  ///< to where it blows; 0 upright, 1 along the canvas, at most 1
    friend bool operator==(const AirJet&, const AirJet&) = default;
};

/// How far it is felt, in radii.
inline constexpr double kJetReach_radii = 3.0;
/// Pa over kg/m3, in mm2/s2.
inline constexpr double kPaPerDensity_mm2_s2 = 1e6;

/// The cells that feel the jet.
grid::Rect cells_reached(const AirJet& jet, grid::Shape canvas, double cell_mm);

/// Pa at a place of the canvas.
double air_pressure_Pa(const AirJet& jet, double x_mm, double y_mm);

/// |grad p| / rho there: the acceleration that the jet gives paint, mm/s2.
double air_push_mm_s2(const AirJet& jet, double density_kg_m3, double x_mm, double y_mm);

}  // namespace pastoso::film
