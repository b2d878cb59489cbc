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
#include "film/face/film_end.hpp"
#include "film/face/shear_thinning.hpp"

namespace pastoso::film {

/// Thickness carried by the flow: the surface of the upwind cell extrapolated to the face with the
/// monotonised-central limiter and to the middle of the step by its rise (Hancock's predictor), between
/// those of both cells; less the support, within [0, the thicker of both cells].
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
    const F midway = lanes::select(from_left, face.eta_left + half * slope + face.rise_left,
                                   face.eta_right - half * slope + face.rise_right);
    const F eta_face = lanes::clamp(midway, lanes::min(face.eta_left, face.eta_right),
                                    lanes::max(face.eta_left, face.eta_right));
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

/// Whether the film ends in the face's left (right) cell, as seen from the other one.
template <class F>
PASTOSO_LANE_FUNCTION auto ends_left(const FaceNeighbourhood<F>& face) {
    return face.end_left.slope != F(0.0F) && face.h_left < face.h_right;
}
template <class F>
PASTOSO_LANE_FUNCTION auto ends_right(const FaceNeighbourhood<F>& face) {
    return face.end_right.slope != F(0.0F) && face.h_right < face.h_left;
}

/// What moves the film's edge through a face.
template <class F>
struct ContactFace {
    F acceleration;  ///< drive, mm/s2, signed along the axis
    F dragging_mm;   ///< thickness of the film that drags
    F passing_mm;    ///< thickness that passes; 0 where the face is shut
    F most_mm;       ///< of paint that a step may carry through it, lest the line goes too far
};

/// Of the film that moves with the contact line: a wedge in half a cell.
template <class F>
PASTOSO_LANE_FUNCTION F line_thickness(F slope, const StepConstants& step) {
    return lanes::max(F(0.5F * step.cell_mm) * slope, F(step.wet_mm));
}

/// The drive outwards of an edge whose surface meets the support at `slope` instead of `angle`, mm/s2:
/// what tension does not balance at the contact line, sigma (slope^2 - angle^2) / 2 a length, moves a
/// cell of film of that thickness; and the paint's weight.
template <class F>
PASTOSO_LANE_FUNCTION F contact_push(F slope, F angle, F normal_along, F thickness, F drop, F tension,
                                     const StepConstants& step) {
    const F unbalanced = (slope * slope - angle * angle) * normal_along;
    return F(step.gravity_mm_s2 * step.inverse_cell) * drop +
           F(0.5F) * tension * F(step.inverse_cell) * unbalanced / (thickness + F(1e-30F));
}

/// A face between wet and dry. It lets through what the wet cell holds over a wedge of the advancing
/// angle that fills it, if that stands above the dry cell (and the negligible film in it) and is driven
/// outwards; without a contact angle, all.
template <class F, class Paint>
PASTOSO_LANE_FUNCTION ContactFace<F> edge_of_dry(const FaceNeighbourhood<F>& face, const Paint& paint,
                                                 const StepConstants& step, F force) {
    const F zero(0.0F), one(1.0F), wet_mm(step.wet_mm), angle = paint.tan_advancing(step);
    const auto wet_left = face.h_left > wet_mm, wet_right = face.h_right > wet_mm;
    const F sign = lanes::select(wet_left, one, F(-1.0F));
    const F h_wet = lanes::select(wet_left, face.h_left, face.h_right);
    const F drop = sign * (face.eta_left - face.eta_right);
    CellEnd<F> end = select_end(wet_left, face.end_left, face.end_right);
    if (!step.has_contact_angle()) {
        end.contact_slope = F(2.0F * step.inverse_cell) * h_wet;
        end.normal_along = one;
        end.over_mm = h_wet;
    }
    const F dragging_mm = step.has_contact_angle() ? line_thickness(end.contact_slope, step) : h_wet;
    const F push = contact_push(lanes::max(end.contact_slope, angle), angle, end.normal_along,
                                dragging_mm, drop, paint.tension(step), step);
    const F acceleration = force + sign * push;
    const auto open = (wet_left || wet_right) && drop > zero && sign * acceleration > zero;
    const F passing_mm = lanes::select(open, lanes::min(end.over_mm, h_wet), zero);
    return {acceleration, dragging_mm, passing_mm, F(1.0F / kStepsOver) * passing_mm};
}

/// A face between the film and the cell that it ends in. The contact line moves out where the surface is
/// steeper than the advancing angle and back where it is flatter than the receding one, until it is
/// no more; between them it stands.
template <class F, class Paint>
PASTOSO_LANE_FUNCTION ContactFace<F> edge_within(const FaceNeighbourhood<F>& face, const Paint& paint,
                                                 const StepConstants& step, F force) {
    const F zero(0.0F), one(1.0F), advancing = paint.tan_advancing(step),
                                   receding = paint.tan_receding(step);
    const auto right = ends_right(face);
    const F sign = lanes::select(right, one, F(-1.0F));
    const CellEnd<F> end = select_end(right, face.end_right, face.end_left);
    const F drop =
        end.slope * end.normal_along * F(step.cell_mm) + sign * (face.support_left - face.support_right);
    const auto steep = end.contact_slope > advancing, flat = end.contact_slope < receding;
    const F angle = lanes::select(steep, advancing, receding);
    // A surface that bends up from the line has no wedge there, but one half as steep as where it enters
    // the cell.
    const F dragging_mm = line_thickness(lanes::max(end.contact_slope, F(F(0.5F) * end.slope)), step);
    const F push = contact_push(lanes::max(end.contact_slope, zero), angle, end.normal_along,
                                dragging_mm, drop, paint.tension(step), step);
    const F acceleration = force + sign * push;
    const F outwards = sign * acceleration;
    const auto open = (steep && outwards > zero) || (flat && outwards < zero);
    const F missing_mm = lanes::abs(F(end.contact_slope - angle)) * end.reach_mm;
    const F passing_mm = lanes::min(end.depth_mm, F(F(kStepsOver) * missing_mm));
    // An end that draws back may be gone in a step, through both of its faces.
    const F held_mm = lanes::select(right, face.h_right, face.h_left);
    const F leaving_mm = F(0.98F) * held_mm * end.normal_along * end.normal_along;
    const F most_mm = lanes::select(steep, F(F(1.0F / kStepsOver) * passing_mm),
                                    lanes::min(F(F(0.5F) * missing_mm), leaving_mm));
    return {acceleration, dragging_mm, lanes::select(open, passing_mm, zero), most_mm};
}

template <class F, class Paint>
PASTOSO_LANE_FUNCTION ContactFace<F> contact_face(const FaceNeighbourhood<F>& face, const Paint& paint,
                                                  const StepConstants& step, F force) {
    const ContactFace<F> dry = edge_of_dry(face, paint, step, force);
    if (!step.has_contact_angle()) return dry;
    const ContactFace<F> within = edge_within(face, paint, step, force);
    const auto wet = face.h_left > F(step.wet_mm) && face.h_right > F(step.wet_mm);
    return {lanes::select(wet, within.acceleration, dry.acceleration),
            lanes::select(wet, within.dragging_mm, dry.dragging_mm),
            lanes::select(wet, within.passing_mm, dry.passing_mm),
            lanes::select(wet, within.most_mm, dry.most_mm)};
}

/// The pull of surface tension towards where it is stronger (Marangoni), mm/s2: a stress tau at the
/// surface moves a film at a mean of tau (h/2 + slip) / (rho nu), which is that of a force
///     k_d (tau/rho) (h/2 + slip) / (h (h + 3 slip))    per mass.
template <class F, class Paint>
PASTOSO_LANE_FUNCTION F tension_pull(const FaceNeighbourhood<F>& face, const Paint& paint,
                                     const StepConstants& step) {
    const CellNumbers<F>&left = face.numbers_left, &right = face.numbers_right;
    const F rise = (right.tension * right.density_kg_m3 - left.tension * left.density_kg_m3) /
                   paint.numbers.density_kg_m3;
    const F h = F(0.5F) * (face.h_left + face.h_right) + F(step.wet_mm), slip = paint.numbers.slip_mm;
    const auto within = face.h_left > F(step.wet_mm) && face.h_right > F(step.wet_mm);
    const F pull = paint.mean_drag(step) * F(step.inverse_cell) * rise * (F(0.5F) * h + slip) /
                   (h * (h + F(3.0F) * slip));
    return lanes::select(within, pull, F(0.0F));
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

/// How a group of faces is put together: by which scheme, and where it is.
struct FaceKind {
    FaceScheme scheme = FaceScheme::Explicit;
    FacePlace place = FacePlace::Anywhere;
};

/// Where the film's surface leads on through the face. In a large step nothing holds the film's edge
/// where there is no contact angle: it is a face like any other.
template <FaceKind kKind, class F>
PASTOSO_LANE_FUNCTION auto inside_film(const FaceNeighbourhood<F>& face, const StepConstants& step) {
    const auto wet_left = face.h_left > F(step.wet_mm), wet_right = face.h_right > F(step.wet_mm);
    if (kKind.place == FacePlace::InFilm) return wet_left && wet_right;
    if (!step.has_contact_angle())
        return kKind.scheme == FaceScheme::Large ? wet_left || wet_right : wet_left && wet_right;
    return (wet_left && wet_right) && !(ends_left(face) || ends_right(face));
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
    F most_mm;           ///< of paint that a step may carry where the film ends; 0 in the middle of it
    F drag_coefficient;  ///< k_d, times the relative viscosity
    F viscosity;         ///< nu at the face, mm2/s
    [[no_unique_address]] FacePaint<F, kModel> paint;
};

/// k_d and nu of the film that drags.
template <FaceModel kModel, class F>
PASTOSO_LANE_FUNCTION void add_drag(const FaceNeighbourhood<F>& face, const StepConstants& step, F along,
                                    FaceDrive<kModel, F>& drive) {
    drive.drag_coefficient = drive.paint.drag_along(step);
    if constexpr (kModel.alpha_range) drive.drag_coefficient = alpha_drag(face, drive.paint, step);
    drive.viscosity = drive.paint.viscosity(step);
    if constexpr (kModel.shear_thinning) {
        const F speed = lanes::sqrt(F(along * along + face.v * face.v));
        const F relative = relative_viscosity<kModel.yield>(
            speed, drive.drag_thickness, drive.paint.against_yield(step), drive.paint.flow_index(step));
        drive.drag_coefficient = drive.drag_coefficient * relative;
        drive.viscosity = drive.viscosity * relative;
    }
}

/// The law, put together in place. `force` acts along the axis, `force_across` along the face.
template <FaceModel kModel, FaceKind kKind, class F>
PASTOSO_LANE_FUNCTION void face_drive(const FaceNeighbourhood<F>& face, const StepConstants& step,
                                      float force, float force_across, const FaceStart<F>& start,
                                      FaceDrive<kModel, F>& drive) {
    const F zero(0.0F), dt(step.dt_s);
    const FacePaint<F, kModel> paint = face_paint<kModel>(face, step);
    F acceleration = drive_along<kModel>(face, step, F(force), start.pressure_gradient);
    if constexpr (kModel.media) acceleration = acceleration + tension_pull(face, paint, step);
    const auto inside = inside_film<kKind>(face, step);
    ContactFace<F> edge;
    if constexpr (kKind.place == FacePlace::Anywhere) {
        edge = contact_face(face, paint, step, F(force));
        acceleration = lanes::select(inside, acceleration, edge.acceleration);
    }
    drive.paint = paint;
    drive.driven = start.momentum + dt * acceleration;
    drive.thickness = upwind_thickness(face, drive.driven);
    if constexpr (kKind.scheme == FaceScheme::Large) {
        // Either cell may be dry.
        const auto donor_wet =
            lanes::select(drive.driven > zero, face.h_left, face.h_right) > F(step.wet_mm);
        drive.thickness = lanes::select(donor_wet && drive.driven != zero, drive.thickness, zero);
    }
    drive.drag_thickness = drive.thickness;
    drive.most_mm = zero;
    if constexpr (kKind.place == FacePlace::Anywhere) {
        drive.drag_thickness = lanes::select(inside, drive.thickness, edge.dragging_mm);
        drive.thickness = lanes::select(inside, drive.thickness, edge.passing_mm);
        drive.most_mm = edge.most_mm;
    }
    drive.laplacian = face.u_back + face.u_front + (face.u_before + face.u_after) - F(4.0F) * face.u;
    add_drag(face, step, start.along, drive);
    drive.across = zero;
    if constexpr (kModel.yield) drive.across = face.v + dt * (F(force_across) - start.gradient_across);
}

/// lambda of what is put together.
template <FaceModel kModel, class F>
PASTOSO_LANE_FUNCTION DragRate<F> drag_rate(const FaceDrive<kModel, F>& drive,
                                            const StepConstants& step) {
    return drag_rate(drive.drag_coefficient, drive.drag_thickness, drive.paint.slip_mm(step),
                     drive.paint.viscosity(step), drive.paint.fluidity(step));
}

}  // namespace pastoso::film
