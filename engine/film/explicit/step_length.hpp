// How long an explicit step may be.
#pragma once

#include "film/explicit/tile_step.hpp"
#include "film/step_constants.hpp"

namespace pastoso::film {

/// Constants of a step before its length is known.
struct StepLimits {
    double cell_mm = 1.0;
    double gravity_mm_s2 = 0.0;
    double tension = 0.0;  ///< sigma/rho, mm3/s2
    double viscosity_mm2_s = 1.0;
    double smallest_drag = 3.0;  ///< k_d
    double force_mm_s2 = 0.0;    ///< F along the canvas
    double yield = 0.0;          ///< tau_y/rho, mm2/s2
    double flow_index = 1.0;     ///< n of Herschel and Bulkley
    double structure_share = 0.0;  ///< theta (cell/structure.hpp)

    /// (l + sqrt(l^2 + 4 w^2)) / w^2 with w^2 = h K (g + sigma/rho K), K = 8/cell^2, drag rate l in 1/s.
    double wave_step_s(double thickness_mm, double drag_rate) const;
    /// Not exceeded by the depth mean of the steady flow that the body force alone drives in a film:
    ///     s h / (k_d nu),    s = max(F h - tau_y/rho, 0),
    /// what the force beyond the yield stress would make of paint without one; shear-thinning paint has
    /// nu (2n + 1)/(3n) gamma^(n-1) at the wall's shear rate gamma = (s / nu)^(1/n).
    double fastest_speed_mm_s(double thickness_mm) const;
    /// The same for paint whose cells differ, from one's own nu in mm2/s and tau_y/rho in mm2/s2.
    double fastest_speed_mm_s(double thickness_mm, double viscosity, double yield_stress) const;
    /// For Newtonian paint of this thickness at rest; shear-thinning paint is taken at its thinnest.
    double newtonian_step_s(double thickness_mm) const;
    /// For paint at rest whose cells differ: `thickest_mm` anywhere, and the largest h^3/nu.
    double resting_step_s(double thickest_mm, double largest_h3_per_viscosity) const;
    /// A quarter of a cell's way at this speed.
    double advection_step_s(double speed_mm_s) const;
    /// For paint whose measured flow is given: its largest mobility h/l (yield stress included) and
    /// thickness bound the waves, its largest speed the advection (a quarter of a cell).
    double flowing_step_s(const FlowExtremes& extremes) const;
};

}  // namespace pastoso::film
