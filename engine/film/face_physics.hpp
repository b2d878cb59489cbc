// The flow through one face of the staggered grid: Baba and Saito's depth-averaged model with the drag
// of an alpha-parabolic velocity profile, Bingham yield stress, capillary pressure and a contact angle.
//
// Depth-averaged momentum at a face, with the mean velocity u, thickness h, surface eta = h + c:
//     du/dt + (u . grad) u = F - d(Pi)/dx + nu lap(u) - lambda u - yield,
//     Pi = g eta + (sigma/rho) kappa,   kappa = -div(n_horizontal),   lambda = k_d nu / (h (h + 3
//     slip)), k_d = 6 / (3 alpha - 1).
// Everything but the drag is taken at the old time, the drag (with the yield stress) at the new one: the
// forward-backward step. A formula is written once, for F a float or a SIMD register of floats.
#pragma once

#include "film/lanes.hpp"
#include "film/step_constants.hpp"

namespace pastoso::film {

#define PASTOSO_FACE_FUNCTION [[gnu::always_inline]] static inline

/// What a face needs to know. "left" and "right" are the cells before and behind it along its axis; for
/// a face of the other direction read "above" and "below".
template <class F>
struct FaceNeighbourhood {
    F h_left, h_right;                             ///< wet thickness, mm
    F support_left, support_right;                 ///< c, mm
    F eta_left2, eta_left, eta_right, eta_right2;  ///< surface height, mm, two cells to each side
    F eta_slope_across;               ///< slope of eta along the face, centred mean of both cells
    F pressure_left, pressure_right;  ///< Pi, mm2/s2
    F curvature;                      ///< mean kappa of both cells, 1/mm
    F normal_left, normal_right;      ///< |n_x| + |n_y| of the film's outline, 1..sqrt(2)
    F u, u_back, u_front, u_before,
        u_after;  ///< old velocity here, one face along the axis, one face across
    F v;          ///< old velocity along the face, mean of the four around it
};

template <class F>
struct FaceFlow {
    F velocity;   ///< new depth-mean velocity through the face, mm/s
    F thickness;  ///< of the film that passes, mm
    F mobility;   ///< h d(velocity)/d(acceleration) of the drag law, mm s; 0 where nothing flows
};

/// Upwind difference (u . grad) u, per second of velocity: u du/dx + v du/dy.
template <class F>
PASTOSO_FACE_FUNCTION F momentum_advection(const FaceNeighbourhood<F>& face, F inverse_cell) {
    const F zero(0.0F);
    const F u_plus = lanes::max(face.u, zero), u_minus = lanes::min(face.u, zero);
    const F v_plus = lanes::max(face.v, zero), v_minus = lanes::min(face.v, zero);
    const F along = u_plus * (face.u - face.u_back) + u_minus * (face.u_front - face.u);
    const F across = v_plus * (face.u - face.u_before) + v_minus * (face.u_after - face.u);
    return inverse_cell * (along + across);
}

/// Thickness carried by the flow: the surface of the upwind cell extrapolated to the face with the
/// monotonised-central limiter, less the support, within [0, the thicker of both cells].
template <class F>
PASTOSO_FACE_FUNCTION F upwind_thickness(const FaceNeighbourhood<F>& face, F drive) {
    const F zero(0.0F), half(0.5F), two(2.0F);
    const auto from_left = drive > zero;
    const F rise = face.eta_right - face.eta_left;
    const F rise_upwind =
        lanes::select(from_left, face.eta_left - face.eta_left2, face.eta_right2 - face.eta_right);
    const F limited = lanes::min(two * lanes::min(lanes::abs(rise), lanes::abs(rise_upwind)),
                                 half * lanes::abs(rise + rise_upwind));
    const F slope = lanes::select(rise * rise_upwind > zero, lanes::copysign(limited, rise), zero);
    const F eta_face =
        lanes::select(from_left, face.eta_left + half * slope, face.eta_right - half * slope);
    return lanes::clamp(F(eta_face - half * (face.support_left + face.support_right)), zero,
                        lanes::max(face.h_left, face.h_right));
}

/// k_d = 6 / (3 alpha - 1) between its two ends, linear in the cosine between the flow and the surface
/// tension T = sigma kappa n. Where the surface is as good as flat (radius of curvature beyond 5000
/// cells) or still, that cosine is only rounding noise, whose sign would print streaks: it fades to 0
/// there.
template <class F>
PASTOSO_FACE_FUNCTION F alpha_drag(const FaceNeighbourhood<F>& face, const StepConstants& step) {
    const F slope_x((face.eta_right - face.eta_left) * F(step.inverse_cell));
    const F slope_y = face.eta_slope_across;
    const F uphill = slope_x * face.u + slope_y * face.v;
    const F norm2 = (slope_x * slope_x + slope_y * slope_y) * (face.u * face.u + face.v * face.v);
    const F flat(2e-4F * step.inverse_cell);
    const F bend = face.curvature / (lanes::abs(face.curvature) + flat);
    const F cosine = bend * uphill / (lanes::sqrt(norm2) + F(1e-8F));
    return F(step.drag_against) +
           (F(step.drag_along) - F(step.drag_against)) * (F(0.5F) * (F(1.0F) + cosine));
}

/// Implicit Bingham drag. With lambda dt = `drag` and the yield velocity y = dt tau_y / (rho h), the
/// wall shear x = tau_wall / tau_y of the exact film law solves
///     (1 + drag) x - 3/2 + 1/(2 x^2) = drag |w| / y,
/// and the velocity is w times the factor returned here, y (x - 1)^2 (x + 1/2) / (drag |w| x^2). Zero
/// below yield, exactly. Three Newton steps from a start above the root leave 1e-6.
template <class F>
struct BinghamDrag {
    F factor;         ///< new velocity / w
    F tangent_share;  ///< 1 - 1/x^3: mobility of the yielded film against the Newtonian one
};
template <class F>
PASTOSO_FACE_FUNCTION BinghamDrag<F> bingham_drag(F drag, F speed, F yield_speed) {
    const F one(1.0F), zero(0.0F);
    const F target = speed * drag / yield_speed;
    const F excess = lanes::max(F(target - drag), zero);
    F x = one + (lanes::sqrt(F(drag * drag + F(6.0F) * excess)) - drag) * F(1.0F / 3.0F);
    for (int iteration = 0; iteration < 3; ++iteration) {
        const F inverse = one / x;
        const F residual = (one + drag) * x - F(1.5F) + F(0.5F) * inverse * inverse - target;
        const F derivative = one + drag - inverse * inverse * inverse;
        x = lanes::max(F(x - residual / (derivative + F(1e-12F))), one);
    }
    const F above = x - one;
    const F inverse = one / x;
    return {yield_speed * above * above * (x + F(0.5F)) * inverse * inverse / (drag * speed),
            one - inverse * inverse * inverse};
}

/// A face between wet and dry: the film's edge. It moves out only when the film is thicker than the
/// contact angle pins, stands above the dry cell (and the trace of film in it), and is driven outwards.
template <class F>
struct ContactFace {
    F acceleration;  ///< drive, mm/s2, signed along the axis
    F h_wet;         ///< thickness of the wet cell
    F pinned_mm;     ///< what the contact angle holds back
    F sign;          ///< +1 when the wet cell is on the left
};
template <class F>
PASTOSO_FACE_FUNCTION ContactFace<F> contact_face(const FaceNeighbourhood<F>& face,
                                                  const StepConstants& step, F force) {
    const F zero(0.0F), one(1.0F);
    const auto wet_left = face.h_left > F(step.wet_mm);
    ContactFace<F> edge;
    edge.sign = lanes::select(wet_left, one, F(-1.0F));
    edge.h_wet = lanes::select(wet_left, face.h_left, face.h_right);
    const F normal = lanes::select(wet_left, face.normal_left, face.normal_right);
    const F eta_wet = lanes::select(wet_left, face.eta_left, face.eta_right);
    const F eta_dry = lanes::select(wet_left, face.eta_right, face.eta_left);
    edge.pinned_mm = F(0.5F * step.cell_mm * step.tan_advancing) * normal;
    const F drop = eta_wet - eta_dry;
    const F slope = F(2.0F * step.inverse_cell) * edge.h_wet / lanes::max(normal, one);
    const F spill = lanes::max(F(slope * slope - F(step.tan_advancing * step.tan_advancing)), zero);
    const F push = F(step.gravity_mm_s2 * step.inverse_cell) * drop +
                   F(0.5F * step.tension * step.inverse_cell) * spill / (edge.h_wet + F(1e-30F));
    edge.acceleration = force + edge.sign * push;
    const auto open =
        (drop > zero) && (edge.h_wet > edge.pinned_mm) && (edge.sign * edge.acceleration > zero);
    edge.pinned_mm = lanes::select(open, edge.pinned_mm, edge.h_wet);
    return edge;
}

/// New velocity and passing thickness at a face. `force` acts along the axis, `force_across` along the
/// face.
template <bool kYield, bool kAlphaRange, class F>
PASTOSO_FACE_FUNCTION FaceFlow<F> face_flow(const FaceNeighbourhood<F>& face, const StepConstants& step,
                                            float force, float force_across) {
    const F zero(0.0F), one(1.0F);
    const F dt(step.dt_s), inverse_cell(step.inverse_cell);
    const F wet_mm(step.wet_mm);
    const auto wet_both = (face.h_left > wet_mm) && (face.h_right > wet_mm);
    const auto wet_one = (face.h_left > wet_mm) != (face.h_right > wet_mm);

    const ContactFace<F> edge = contact_face(face, step, F(force));
    const F inner_acceleration = F(force) - (face.pressure_right - face.pressure_left) * inverse_cell;
    const F acceleration = lanes::select(wet_both, inner_acceleration, edge.acceleration);
    const F kept = face.u - F(step.inertia) * dt * momentum_advection(face, inverse_cell);
    const F driven = kept + dt * acceleration;

    const F inner_thickness = upwind_thickness(face, driven);
    const F drag_thickness = lanes::select(wet_both, inner_thickness, edge.h_wet);
    const F edge_thickness =
        lanes::select(wet_one, lanes::max(F(edge.h_wet - edge.pinned_mm), zero), zero);
    const F thickness = lanes::select(wet_both, inner_thickness, edge_thickness);

    F drag_coefficient(step.drag_along);
    if constexpr (kAlphaRange) drag_coefficient = alpha_drag(face, step);
    const F drag_rate = drag_coefficient * F(step.viscosity_mm2_s) /
                        (drag_thickness * (drag_thickness + F(3.0F * step.slip_mm)) + F(1e-12F));

    // Explicit lateral viscosity, capped where it would outrun its own stability limit.
    const F lateral_viscosity =
        lanes::min(F(step.viscosity_mm2_s),
                   F(step.cell_mm * step.cell_mm / 32.0F) * (F(1.0F / step.dt_s) + drag_rate));
    const F laplacian = face.u_back + face.u_front + (face.u_before + face.u_after) - F(4.0F) * face.u;
    const F unresisted =
        driven + F(step.lateral) * dt * inverse_cell * inverse_cell * lateral_viscosity * laplacian;

    const F drag = drag_rate * dt;
    F factor = one / (one + drag);
    F tangent_share = one;
    if constexpr (kYield) {
        const F across = face.v + dt * (F(force_across) - F(step.gravity_mm_s2) * face.eta_slope_across);
        const F speed = lanes::sqrt(F(unresisted * unresisted + across * across)) + F(1e-30F);
        const F yield_speed = dt * F(step.yield) / (drag_thickness + F(1e-12F));
        const BinghamDrag<F> bingham = bingham_drag(drag, speed, yield_speed);
        factor = bingham.factor;
        tangent_share = bingham.tangent_share;
    }

    const F speed_limit(0.5F * step.cell_mm / step.dt_s);
    const auto flows = thickness > zero;
    FaceFlow<F> flow;
    flow.velocity =
        lanes::select(flows, lanes::clamp(F(factor * unresisted), F(-speed_limit), speed_limit), zero);
    flow.thickness = thickness;
    flow.mobility = lanes::select(flows, tangent_share * thickness / drag_rate, zero);
    return flow;
}

#undef PASTOSO_FACE_FUNCTION

}  // namespace pastoso::film
