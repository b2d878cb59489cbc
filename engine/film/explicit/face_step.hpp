// The forward-backward step of one face: everything but the drag is taken at the old time, the drag
// (with the yield stress) at the new one.
#pragma once

#include "film/face/face_physics.hpp"

namespace pastoso::film {

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

/// What drives a face at the old time.
template <FaceModel kModel, FacePlace kPlace, class F>
PASTOSO_LANE_FUNCTION void explicit_drive(const FaceNeighbourhood<F>& face, const StepConstants& step,
                                          float force, float force_across, FaceDrive<kModel, F>& drive) {
    const F dt(step.dt_s), inverse_cell(step.inverse_cell);
    const FaceStart<F> start{
        .momentum = face.u - F(step.inertia) * dt * momentum_advection(face, inverse_cell),
        .pressure_gradient = (face.pressure_right - face.pressure_left) * inverse_cell,
        .gradient_across = kModel.yield ? face.pressure_rise_across * inverse_cell : F(0.0F),
        .along = face.u};
    constexpr FaceKind kKind{FaceScheme::Explicit, kPlace};
    face_drive<kModel, kKind>(face, step, force, force_across, start, drive);
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
    const DragRate<F> lambda = drag_rate(drive, step);
    FaceDrag<F> result;
    result.unresisted =
        drive.driven + F(step.lateral * step.dt_s * step.inverse_cell * step.inverse_cell) *
                           lateral_viscosity(drive.viscosity, lambda.rate, step) * drive.laplacian;
    result.drag = lambda.rate * F(step.dt_s);
    result.relaxation = lambda.inverse;
    if constexpr (kModel.shear_thinning)
        result.relaxation = lambda.inverse * (F(1.0F) / drive.paint.flow_index(step));
    result.stress = F(0.0F);
    if constexpr (kModel.yield)
        result.stress = stopping_stress(result.drag, drive.drag_thickness, result.unresisted,
                                        drive.across, drive.paint, step);
    return result;
}

template <class F>
struct FaceFlow {
    F velocity;   ///< new depth-mean velocity through the face, mm/s
    F thickness;  ///< of the film that passes, mm
    F mobility;   ///< h d(velocity)/d(acceleration) of the drag law, mm s; 0 where nothing flows
};

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
    FaceDrive<kModel, F> drive;
    explicit_drive<kModel, FacePlace::Anywhere>(face, step, force, force_across, drive);
    const FaceDrag<F> drag = face_drag<kModel>(drive, step);
    return face_flow(drive.thickness, drag, drag_law<kModel.yield>(drag.drag, drag.stress), step);
}

}  // namespace pastoso::film
