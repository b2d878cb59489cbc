// What resists the flow through a face: the drag of an alpha-parabolic velocity profile,
//     lambda = k_d nu / (h (h + 3 slip)),   k_d = 6 / (3 alpha - 1),
// and a Bingham yield stress, both at the new time.
#pragma once

#include "film/face/face_model.hpp"

namespace pastoso::film {

/// k_d = 6 / (3 alpha - 1) between its two ends, linear in
///     sign(kappa) grad(eta) . u / (sqrt(1 + |grad(eta)|^2) |u|),
/// the cosine between the flow and the surface tension T = sigma kappa n. n is the surface's normal in
/// space: where the surface is level, the tension has no direction along the canvas
/// (docs/decisions/0011). Where the radius of curvature exceeds 5000 cells or the paint is still, the
/// cosine is only rounding noise: it fades to 0 there.
template <class F, class Paint>
PASTOSO_LANE_FUNCTION F alpha_drag(const FaceNeighbourhood<F>& face, const Paint& paint,
                                   const StepConstants& step) {
    const F slope_x((face.eta_right - face.eta_left) * F(step.inverse_cell));
    const F slope_y = face.eta_slope_across;
    const F uphill = slope_x * face.u + slope_y * face.v;
    const F normal2 = F(step.tension_rise2) + (slope_x * slope_x + slope_y * slope_y);
    const F norm2 = normal2 * (face.u * face.u + face.v * face.v);
    const F flat(2e-4F * step.inverse_cell);
    const F cosine = face.curvature * uphill /
                     ((lanes::abs(face.curvature) + flat) * (lanes::sqrt(norm2) + F(1e-8F)));
    return paint.mean_drag(step) + paint.drag_range(step) * cosine;
}

/// Drag rate lambda = k_d nu / (h (h + 3 slip)), 1/s, and its inverse.
template <class F>
struct DragRate {
    F rate, inverse;
};
template <class F>
PASTOSO_LANE_FUNCTION DragRate<F> drag_rate(F coefficient, F thickness, F slip_mm, F viscosity,
                                            F fluidity) {
    const F area = thickness * (thickness + F(3.0F) * slip_mm) + F(1e-12F);
    const F quotient = F(1.0F) / (coefficient * area);
    return {viscosity * coefficient * (coefficient * quotient), fluidity * area * (area * quotient)};
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

/// The law of paint without a yield stress is Newton's, which leaves 1 / (1 + drag).
template <bool kYield, class F>
PASTOSO_LANE_FUNCTION BinghamDrag<F> drag_law(F drag, F stress) {
    if constexpr (kYield) return bingham_drag(drag, stress);
    const F one(1.0F);
    return {one / (one + drag), one};
}

}  // namespace pastoso::film
