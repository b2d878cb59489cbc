// The numbers of one time step, in millimetres and seconds, ready for the kernels.
#pragma once

namespace pastoso::film {

/// Shear rates at the wall, 1/s, that the viscosity follows; beyond them it stays what it is there.
/// Paint at rest thus has a viscosity, and none loses it all.
inline constexpr float kSlowestShear = 1e-3F;
inline constexpr float kFastestShear = 1e4F;

struct StepConstants {
    float cell_mm = 1.0F;
    float inverse_cell = 1.0F;
    float dt_s = 0.01F;

    float gravity_mm_s2 = 0.0F;  ///< g, normal to the canvas
    float force_x_mm_s2 = 0.0F;  ///< F, along the canvas
    float force_y_mm_s2 = 0.0F;
    float tension = 0.0F;          ///< sigma/rho, mm3/s2
    float viscosity_mm2_s = 1.0F;  ///< nu; with shear thinning K/rho, at a shear rate of 1/s
    float flow_index = 1.0F;       ///< n of Herschel and Bulkley
    float yield = 0.0F;            ///< tau_y/rho, mm2/s2
    float yield_per_Pa = 1.0F;     ///< 1/rho in these units
    bool mixed = false;            ///< paint of several consistencies: each cell carries its own instead
    bool varied = false;           ///< the cells differ: paint is mixed, or worked in places
    bool media = false;            ///< paint of several media: each cell has its own numbers besides

    float structure_share = 0.0F;   ///< theta: what of both is lost in paint that is worked
    float breakdown_strain = 1.0F;  ///< gamma_b

    float drag_against = 3.0F;  ///< k_d = 6/(3 alpha - 1) where tension opposes the flow (alpha_min)
    float drag_along = 3.0F;    ///< k_d where tension drives it (alpha_max)
    float slip_mm = 0.0F;
    float horizontal_tension = 0.0F;  ///< chi sigma/rho, mm3/s2
    float tension_rise2 =
        1.0F;  ///< of the surface's normal out of the plane, squared: 1, or left out: 0

    float tan_advancing = 0.0F;  ///< slopes of the contact angles; 0: perfectly wetting, edges are free
    float tan_receding = 0.0F;
    float wet_mm = 1e-4F;  ///< thinner films do not move

    float inertia = 1.0F;  ///< 1 with advection of momentum, 0 without
    float lateral = 1.0F;  ///< 1 with viscosity between neighbouring columns, 0 without
    bool full_curvature = true;
    bool unhurried = false;  ///< a large step that is long because the paint hardly moves

    bool has_contact_angle() const { return tan_advancing > 0.0F; }
    bool has_yield() const { return yield > 0.0F; }
    bool has_alpha_range() const { return drag_against != drag_along; }
    bool has_horizontal_tension() const { return horizontal_tension != 0.0F; }
    bool is_shear_thinning() const { return flow_index != 1.0F; }
};

}  // namespace pastoso::film
