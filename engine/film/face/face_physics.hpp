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

#include "core/lanes.hpp"
#include "film/face/shear_thinning.hpp"
#include "film/step_constants.hpp"

namespace pastoso::film {

namespace lanes = core::lanes;

/// Which terms the formulas contain; a term that is left out costs nothing.
struct FaceModel {
    bool yield = false;
    bool alpha_range = false;  ///< also right, only slower, where both ends are the same
    bool horizontal_tension = false;
    bool shear_thinning = false;
    bool varied = false;  ///< every cell has its own viscosity and yield stress
};

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
        u_after;                        ///< old velocity here, one face along the axis, one face across
    F v;                                ///< old velocity along the face, mean of the four around it
    F viscosity_left, viscosity_right;  ///< mm2/s; of varied paint only
    F yield_left, yield_right;          ///< tau_y/rho, mm2/s2; of varied paint only
};

/// The consistency of the paint at a face. Uniform paint has the step's and stores nothing.
template <class F, bool kVaried>
struct FacePaint {
    static F viscosity(const StepConstants& step) { return F(step.viscosity_mm2_s); }
    static F fluidity(const StepConstants& step) { return F(1.0F / step.viscosity_mm2_s); }
    static F against_yield(const StepConstants& step) { return F(step.viscosity_mm2_s / step.yield); }
    static F over_yield_in_step(F impulse, const StepConstants& step) {
        return impulse * F(1.0F / (step.dt_s * step.yield));
    }
};
template <class F>
struct FacePaint<F, true> {
    F nu, tau;  ///< mm2/s, mm2/s2

    F viscosity(const StepConstants&) const { return nu; }
    F fluidity(const StepConstants&) const { return F(1.0F) / nu; }
    F against_yield(const StepConstants&) const { return nu / tau; }
    F over_yield_in_step(F impulse, const StepConstants& step) const {
        return impulse / (F(step.dt_s) * tau);
    }
};

/// What flows through a face is taken as an equal mixture of both cells: the mean of ln nu and that of
/// tau_y, as anywhere else (paint_cell.hpp). At the film's edge it is the wet cell's paint. A
/// negligible yield stress stands for none.
template <FaceModel kModel, class F>
PASTOSO_LANE_FUNCTION FacePaint<F, kModel.varied> face_paint(const FaceNeighbourhood<F>& face,
                                                             const StepConstants& step) {
    if constexpr (!kModel.varied) {
        return {};
    } else {
        const auto wet_left = face.h_left > F(step.wet_mm), wet_right = face.h_right > F(step.wet_mm);
        const auto wet_both = wet_left && wet_right;
        const F nu = lanes::sqrt(F(face.viscosity_left * face.viscosity_right));
        const F tau = F(0.5F) * (face.yield_left + face.yield_right);
        const F edge_nu = lanes::select(wet_left, face.viscosity_left, face.viscosity_right);
        const F edge_tau = lanes::select(wet_left, face.yield_left, face.yield_right);
        return {lanes::select(wet_both, nu, edge_nu),
                lanes::max(F(lanes::select(wet_both, tau, edge_tau)), F(1e-9F))};
    }
}

template <class F>
struct FaceFlow {
    F velocity;   ///< new depth-mean velocity through the face, mm/s
    F thickness;  ///< of the film that passes, mm
    F mobility;   ///< h d(velocity)/d(acceleration) of the drag law, mm s; 0 where nothing flows
};

/// Upwind difference (u . grad) u, per second of velocity: u du/dx + v du/dy.
template <class F>
PASTOSO_LANE_FUNCTION F momentum_advection(const FaceNeighbourhood<F>& face, F inverse_cell) {
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
PASTOSO_LANE_FUNCTION F upwind_thickness(const FaceNeighbourhood<F>& face, F drive) {
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

/// k_d = 6 / (3 alpha - 1) between its two ends, linear in
///     sign(kappa) grad(eta) . u / (sqrt(1 + |grad(eta)|^2) |u|),
/// the cosine between the flow and the surface tension T = sigma kappa n. n is the surface's normal in
/// space: where the surface is level, the tension has no direction along the canvas
/// (docs/decisions/0011). Where the radius of curvature exceeds 5000 cells or the paint is still, the
/// cosine is only rounding noise: it fades to 0 there.
template <class F>
PASTOSO_LANE_FUNCTION F alpha_drag(const FaceNeighbourhood<F>& face, const StepConstants& step) {
    const F slope_x((face.eta_right - face.eta_left) * F(step.inverse_cell));
    const F slope_y = face.eta_slope_across;
    const F uphill = slope_x * face.u + slope_y * face.v;
    const F normal2 = F(step.tension_rise2) + (slope_x * slope_x + slope_y * slope_y);
    const F norm2 = normal2 * (face.u * face.u + face.v * face.v);
    const F flat(2e-4F * step.inverse_cell);
    const F cosine = face.curvature * uphill /
                     ((lanes::abs(face.curvature) + flat) * (lanes::sqrt(norm2) + F(1e-8F)));
    const F mean(0.5F * (step.drag_along + step.drag_against));
    return mean + F(0.5F * (step.drag_along - step.drag_against)) * cosine;
}

/// Implicit Bingham drag. With lambda dt = `drag` and the stress at which the film would yield at once,
/// W = drag |w| / y in units of tau_y (y = dt tau_y / (rho h)), the wall shear x = tau_wall / tau_y of
/// the exact film law solves
///     (1 + drag) x - 3/2 + 1/(2 x^2) = W,
/// or, in the share e = 1 - 1/x of the film that is sheared,
///     e (W + 3/2 e - 1/2 e^2) = W - drag,
/// which is as good near yield as far above it. The new velocity is w times (x - 1)^2 (x + 1/2) / (W
/// x^2), exactly zero below yield. Two Newton steps from the root of the quadratic part leave 1e-6.
template <class F>
struct BinghamDrag {
    F factor;         ///< new velocity / w
    F tangent_share;  ///< 1 - 1/x^3: mobility of the yielded film against the Newtonian one
};
template <class F>
PASTOSO_LANE_FUNCTION BinghamDrag<F> bingham_drag(F drag, F stress) {
    const F zero(0.0F), half(0.5F), one(1.0F), three_halves(1.5F), three(3.0F);
    const F load = lanes::min(stress, F(1e18F));  // keeps the squares below finite
    const F excess = lanes::max(F(load - drag), zero);
    F sheared = F(2.0F) * excess / (load + lanes::sqrt(F(load * load + F(6.0F) * excess)) + F(1e-20F));
    for (int iteration = 0; iteration < 2; ++iteration) {
        const F residual = (load + (three_halves - half * sheared) * sheared) * sheared - excess;
        const F derivative = load + (three - three_halves * sheared) * sheared;
        sheared = sheared - residual / (derivative + F(1e-20F));
    }
    const F plug = one - lanes::min(sheared, one);
    const F plug3 = plug * plug * plug;
    // 1/x from the equation once more, where e has lost it to rounding.
    const F shear = sheared * sheared * (three_halves - half * sheared) * (load + three_halves);
    return {shear / (load * (one + drag + half * plug3) + F(1e-20F)), one - plug3};
}

/// The same from |w| and the yield velocity y.
template <class F>
PASTOSO_LANE_FUNCTION BinghamDrag<F> bingham_drag(F drag, F speed, F yield_speed) {
    return bingham_drag(drag, F(drag * speed / yield_speed));
}

/// A face between wet and dry: the film's edge. It moves out only when the film is thicker than the
/// contact angle pins, stands above the dry cell (and the negligible film in it), and is driven
/// outwards.
template <class F>
struct ContactFace {
    F acceleration;  ///< drive, mm/s2, signed along the axis
    F h_wet;         ///< thickness of the wet cell
    F pinned_mm;     ///< what the contact angle holds back
    F sign;          ///< +1 when the wet cell is on the left
};
template <class F>
PASTOSO_LANE_FUNCTION ContactFace<F> contact_face(const FaceNeighbourhood<F>& face,
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

/// Drag rate lambda = k_d nu / (h (h + 3 slip)), 1/s, and its inverse.
template <class F>
struct DragRate {
    F rate, inverse;
};
template <class F>
PASTOSO_LANE_FUNCTION DragRate<F> drag_rate(F coefficient, F thickness, F viscosity, F fluidity,
                                            const StepConstants& step) {
    const F area = thickness * (thickness + F(3.0F * step.slip_mm)) + F(1e-12F);
    const F quotient = F(1.0F) / (coefficient * area);
    return {viscosity * coefficient * (coefficient * quotient), fluidity * area * (area * quotient)};
}

/// Explicit viscosity between neighbouring columns of paint, mm2/s: capped where it would outrun its own
/// stability limit.
template <class F>
PASTOSO_LANE_FUNCTION F lateral_viscosity(F viscosity, F drag_rate, const StepConstants& step) {
    return lanes::min(viscosity,
                      F(step.cell_mm * step.cell_mm / 32.0F) * (F(1.0F / step.dt_s) + drag_rate));
}

/// The wall stress, in yield stresses, that would stop a film of velocity (u, v) within the step:
/// drag |w| / y.
template <class F, class Paint>
PASTOSO_LANE_FUNCTION F stopping_stress(F drag, F thickness, F u, F v, const Paint& paint,
                                        const StepConstants& step) {
    const F speed = lanes::sqrt(F(u * u + v * v)) + F(1e-30F);
    return paint.over_yield_in_step(F(speed * drag * thickness), step);
}

/// What moves the paint through a face and what will resist it, all at the old time.
template <FaceModel kModel, class F>
struct FaceDrive {
    F driven;            ///< velocity under inertia and force, without drag, mm/s
    F across;            ///< the same along the face; 0 without a yield stress
    F laplacian;         ///< sum of the neighbouring velocities' differences, mm/s
    F thickness;         ///< of the film that passes, mm; 0 where nothing can
    F drag_thickness;    ///< of the film that drags, mm
    F drag_coefficient;  ///< k_d, times the relative viscosity
    F viscosity;         ///< nu at the face, mm2/s
    [[no_unique_address]] FacePaint<F, kModel.varied> paint;
};

/// The paper's horizontal surface tension, chi (sigma/rho) kappa d(eta)/dx / h: a weight chi of 0 is
/// physical, since grad(Pi) already contains this traction. h is the mean of both cells, at least what
/// the contact angle pins.
template <class F>
PASTOSO_LANE_FUNCTION F horizontal_tension(const FaceNeighbourhood<F>& face, const StepConstants& step) {
    const F pinned(0.5F * step.cell_mm * step.tan_advancing + step.wet_mm);
    const F thickness = lanes::max(F(F(0.5F) * (face.h_left + face.h_right)), pinned);
    const F slope = (face.eta_right - face.eta_left) * F(step.inverse_cell);
    return F(step.horizontal_tension) * face.curvature * slope / thickness;
}

/// `force` acts along the axis, `force_across` along the face. A branch that no lane needs is left out,
/// which changes no bit.
template <FaceModel kModel, class F>
PASTOSO_LANE_FUNCTION FaceDrive<kModel, F> face_drive(const FaceNeighbourhood<F>& face,
                                                      const StepConstants& step, float force,
                                                      float force_across) {
    const F zero(0.0F), dt(step.dt_s), inverse_cell(step.inverse_cell);
    const auto wet_left = face.h_left > F(step.wet_mm), wet_right = face.h_right > F(step.wet_mm);
    const auto wet_both = wet_left && wet_right;
    const bool inside = lanes::all(wet_both);
    ContactFace<F> edge;
    F acceleration = F(force) - (face.pressure_right - face.pressure_left) * inverse_cell;
    if constexpr (kModel.horizontal_tension)
        acceleration = acceleration + horizontal_tension(face, step);
    if (!inside) {
        edge = contact_face(face, step, F(force));
        acceleration = lanes::select(wet_both, acceleration, edge.acceleration);
    }
    FaceDrive<kModel, F> drive;
    drive.paint = face_paint<kModel>(face, step);
    drive.driven =
        face.u - F(step.inertia) * dt * momentum_advection(face, inverse_cell) + dt * acceleration;
    drive.thickness = drive.drag_thickness = upwind_thickness(face, drive.driven);
    if (!inside) {
        const F passing =
            lanes::select(wet_left || wet_right, lanes::max(F(edge.h_wet - edge.pinned_mm), zero), zero);
        drive.drag_thickness = lanes::select(wet_both, drive.thickness, edge.h_wet);
        drive.thickness = lanes::select(wet_both, drive.thickness, passing);
    }
    drive.laplacian = face.u_back + face.u_front + (face.u_before + face.u_after) - F(4.0F) * face.u;
    drive.drag_coefficient = F(step.drag_along);
    if constexpr (kModel.alpha_range) drive.drag_coefficient = alpha_drag(face, step);
    drive.viscosity = drive.paint.viscosity(step);
    if constexpr (kModel.shear_thinning) {
        const F speed = lanes::sqrt(F(face.u * face.u + face.v * face.v));
        const F relative = relative_viscosity<kModel.yield>(speed, drive.drag_thickness,
                                                            drive.paint.against_yield(step), step);
        drive.drag_coefficient = drive.drag_coefficient * relative;
        drive.viscosity = drive.viscosity * relative;
    }
    drive.across = zero;
    if constexpr (kModel.yield)
        drive.across = face.v + dt * (F(force_across) - F(step.gravity_mm_s2) * face.eta_slope_across);
    return drive;
}

/// What the drag at the new time has to stop.
template <class F>
struct FaceDrag {
    F unresisted;  ///< velocity w without drag, mm/s
    F drag;        ///< lambda dt
    F relaxation;  ///< 1 / lambda, s; of power laws their tangent, 1 / (n lambda)
    F stress;      ///< W; 0 without a yield stress
};
template <FaceModel kModel, class F>
PASTOSO_LANE_FUNCTION FaceDrag<F> face_drag(const FaceDrive<kModel, F>& drive,
                                            const StepConstants& step) {
    const DragRate<F> lambda = drag_rate(drive.drag_coefficient, drive.drag_thickness,
                                         drive.paint.viscosity(step), drive.paint.fluidity(step), step);
    FaceDrag<F> result;
    result.unresisted =
        drive.driven + F(step.lateral * step.dt_s * step.inverse_cell * step.inverse_cell) *
                           lateral_viscosity(drive.viscosity, lambda.rate, step) * drive.laplacian;
    result.drag = lambda.rate * F(step.dt_s);
    result.relaxation = lambda.inverse;
    if constexpr (kModel.shear_thinning) result.relaxation = lambda.inverse * F(1.0F / step.flow_index);
    result.stress = F(0.0F);
    if constexpr (kModel.yield)
        result.stress = stopping_stress(result.drag, drive.drag_thickness, result.unresisted,
                                        drive.across, drive.paint, step);
    return result;
}

/// Bingham's drag law, or Newton's, which is 1 / (1 + drag).
template <FaceModel kModel, class F>
PASTOSO_LANE_FUNCTION BinghamDrag<F> drag_law(const FaceDrag<F>& face) {
    if constexpr (kModel.yield) return bingham_drag(face.drag, face.stress);
    const F one(1.0F);
    return {one / (one + face.drag), one};
}

/// New velocity and passing thickness at a face.
template <class F>
PASTOSO_LANE_FUNCTION FaceFlow<F> face_flow(F thickness, const FaceDrag<F>& drag,
                                            const BinghamDrag<F>& law, const StepConstants& step) {
    const F zero(0.0F), limit(0.5F * step.cell_mm / step.dt_s);
    const auto flows = thickness > zero;
    const F velocity = lanes::clamp(F(law.factor * drag.unresisted), F(-limit), limit);
    return {.velocity = lanes::select(flows, velocity, zero),
            .thickness = thickness,
            .mobility = lanes::select(flows, law.tangent_share * thickness * drag.relaxation, zero)};
}

/// All of it at once.
template <FaceModel kModel, class F>
PASTOSO_LANE_FUNCTION FaceFlow<F> face_flow(const FaceNeighbourhood<F>& face, const StepConstants& step,
                                            float force, float force_across) {
    const FaceDrive<kModel, F> drive = face_drive<kModel>(face, step, force, force_across);
    const FaceDrag<F> drag = face_drag<kModel>(drive, step);
    return face_flow(drive.thickness, drag, drag_law<kModel>(drag), step);
}

}  // namespace pastoso::film
