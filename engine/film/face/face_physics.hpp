// The flow through one face of the staggered grid: Baba and Saito's depth-averaged model with the drag
// of an alpha-parabolic velocity profile, Bingham yield stress, capillary pressure and a contact angle.
//
// Depth-averaged momentum at a face, with the mean velocity u, thickness h, surface eta = h + c:
//     du/dt + (u . grad) u = F - d(Pi)/dx + nu lap(u) - lambda u - yield,
//     Pi = g eta + (sigma/rho) kappa,   kappa = -div(n_horizontal),   lambda = k_d nu / (h (h + 3
//     slip)), k_d = 6 / (3 alpha - 1).
// face_drive() puts the law together, for the explicit and for the large scheme. What is left to each is
// how momentum arrives at the face, and which pressure: the old time's, or what the step solves for.
#pragma once

#include "film/face/face_drag.hpp"
#include "film/face/shear_thinning.hpp"

namespace pastoso::film {

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

/// The thickness that leaves through the film's edge.
template <class F>
PASTOSO_LANE_FUNCTION F passing_thickness(const FaceNeighbourhood<F>& face, const ContactFace<F>& edge,
                                          const StepConstants& step) {
    const F zero(0.0F), wet_mm(step.wet_mm);
    return lanes::select(face.h_left > wet_mm || face.h_right > wet_mm,
                         lanes::max(F(edge.h_wet - edge.pinned_mm), zero), zero);
}

/// The drive along the axis: what accelerates the paint through the face, mm/s2, but for its drag.
template <FaceModel kModel, class F>
PASTOSO_LANE_FUNCTION F drive_along(const FaceNeighbourhood<F>& face, const StepConstants& step, F force,
                                    F pressure_gradient) {
    F drive = force - pressure_gradient;
    if constexpr (kModel.horizontal_tension) drive = drive + horizontal_tension(face, step);
    return drive;
}

enum class FaceScheme { Explicit, Large };

/// Where the film's surface leads on through the face. In a large step nothing holds the film's edge
/// where there is no contact angle: it is a face like any other.
template <FaceScheme kScheme, class F>
PASTOSO_LANE_FUNCTION auto inside_film(const FaceNeighbourhood<F>& face, const StepConstants& step) {
    const auto wet_left = face.h_left > F(step.wet_mm), wet_right = face.h_right > F(step.wet_mm);
    if constexpr (kScheme == FaceScheme::Large)
        return step.has_contact_angle() ? wet_left && wet_right : wet_left || wet_right;
    else
        return wet_left && wet_right;
}

/// What a scheme brings along.
template <class F>
struct FaceStart {
    F momentum;           ///< velocity that arrives at the face, mm/s
    F pressure_gradient;  ///< d(Pi)/dx, mm/s2
    F gradient_across;    ///< the same along the face, as far as the scheme knows it; with a yield
                          ///< stress only
    F along;              ///< velocity by which the paint is thinned, mm/s
};

/// What moves the paint through a face and what will resist it.
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

/// k_d and nu of the film that drags.
template <FaceModel kModel, class F>
PASTOSO_LANE_FUNCTION void add_drag(const FaceNeighbourhood<F>& face, const StepConstants& step, F along,
                                    FaceDrive<kModel, F>& drive) {
    drive.drag_coefficient = F(step.drag_along);
    if constexpr (kModel.alpha_range) drive.drag_coefficient = alpha_drag(face, step);
    drive.viscosity = drive.paint.viscosity(step);
    if constexpr (kModel.shear_thinning) {
        const F speed = lanes::sqrt(F(along * along + face.v * face.v));
        const F relative = relative_viscosity<kModel.yield>(speed, drive.drag_thickness,
                                                            drive.paint.against_yield(step), step);
        drive.drag_coefficient = drive.drag_coefficient * relative;
        drive.viscosity = drive.viscosity * relative;
    }
}

/// The law, put together. `force` acts along the axis, `force_across` along the face. A branch that no
/// lane needs is left out, which changes no bit.
template <FaceModel kModel, FaceScheme kScheme, class F>
PASTOSO_LANE_FUNCTION FaceDrive<kModel, F> face_drive(const FaceNeighbourhood<F>& face,
                                                      const StepConstants& step, float force,
                                                      float force_across, const FaceStart<F>& start) {
    const F zero(0.0F), dt(step.dt_s);
    const auto inside = inside_film<kScheme>(face, step);
    const bool all_inside = lanes::all(inside);
    ContactFace<F> edge;
    F acceleration = drive_along<kModel>(face, step, F(force), start.pressure_gradient);
    if (!all_inside) {
        edge = contact_face(face, step, F(force));
        acceleration = lanes::select(inside, acceleration, edge.acceleration);
    }
    FaceDrive<kModel, F> drive;
    drive.paint = face_paint<kModel>(face, step);
    drive.driven = start.momentum + dt * acceleration;
    drive.thickness = upwind_thickness(face, drive.driven);
    if constexpr (kScheme == FaceScheme::Large) {
        // Either cell may be dry.
        const auto donor_wet =
            lanes::select(drive.driven > zero, face.h_left, face.h_right) > F(step.wet_mm);
        drive.thickness = lanes::select(donor_wet && drive.driven != zero, drive.thickness, zero);
    }
    drive.drag_thickness = drive.thickness;
    if (!all_inside) {
        drive.drag_thickness = lanes::select(inside, drive.thickness, edge.h_wet);
        drive.thickness = lanes::select(inside, drive.thickness, passing_thickness(face, edge, step));
    }
    drive.laplacian = face.u_back + face.u_front + (face.u_before + face.u_after) - F(4.0F) * face.u;
    add_drag(face, step, start.along, drive);
    drive.across = zero;
    if constexpr (kModel.yield) drive.across = face.v + dt * (F(force_across) - start.gradient_across);
    return drive;
}

/// lambda of what is put together.
template <FaceModel kModel, class F>
PASTOSO_LANE_FUNCTION DragRate<F> drag_rate(const FaceDrive<kModel, F>& drive,
                                            const StepConstants& step) {
    return drag_rate(drive.drag_coefficient, drive.drag_thickness, drive.paint.viscosity(step),
                     drive.paint.fluidity(step), step);
}

}  // namespace pastoso::film
