// What the flow law knows of a face: which of its terms count, the cells around it and their paint. Here
// and in what builds on it a formula is written once, as plain arithmetic for F a float or a SIMD
// register of floats.
#pragma once

#include "core/lanes.hpp"
#include "film/cell/film_numbers.hpp"
#include "film/step_constants.hpp"

#include <array>
#include <cstddef>

namespace pastoso::film {

namespace lanes = core::lanes;

/// Which terms the formulas contain; a term that is left out costs nothing.
struct FaceModel {
    bool yield = false;
    bool alpha_range = false;  ///< also right, only slower, where both ends are the same
    bool horizontal_tension = false;
    bool shear_thinning = false;
    bool varied = false;  ///< every cell has its own viscosity and yield stress
    bool media = false;   ///< and all other numbers of its own medium
};

/// Where a face, or a group of them, is: anywhere, or in the middle of the film, with no end of it
/// beside them. What only ends need is left out there, which changes no bit and keeps the way through
/// the middle short.
enum class FacePlace { Anywhere, InFilm };

/// How the film ends in a cell, as far as one of its faces needs to know it; see FilmEnd.
template <class F>
struct CellEnd {
    F contact_slope;  ///< of the surface at the contact line
    F slope;          ///< the same at the face; 0 where the film fills the cell
    F reach_mm;       ///< from the film inside to the contact line
    F depth_mm;       ///< of the film at the face
    F over_mm;        ///< thickness that may leave through it
    F normal_along;   ///< |n| along the axis, n the normal of the film's outline
};
template <class Mask, class F>
PASTOSO_LANE_FUNCTION CellEnd<F> select_end(Mask first, const CellEnd<F>& a, const CellEnd<F>& b) {
    return {lanes::select(first, a.contact_slope, b.contact_slope),
            lanes::select(first, a.slope, b.slope),
            lanes::select(first, a.reach_mm, b.reach_mm),
            lanes::select(first, a.depth_mm, b.depth_mm),
            lanes::select(first, a.over_mm, b.over_mm),
            lanes::select(first, a.normal_along, b.normal_along)};
}

/// What a face needs to know. "left" and "right" are the cells before and behind it along its axis; for
/// a face of the other direction read "above" and "below".
template <class F>
struct FaceNeighbourhood {
    F h_left, h_right;                             ///< wet thickness, mm
    F support_left, support_right;                 ///< c, mm
    F eta_left2, eta_left, eta_right, eta_right2;  ///< surface height, mm, two cells to each side
    F rise_left, rise_right;          ///< of the surface in half the step, by the old velocities, mm
    F eta_slope_across;               ///< slope of eta along the face, centred mean of both cells
    F pressure_left, pressure_right;  ///< Pi, mm2/s2
    F pressure_rise_across;           ///< difference_across() of Pi, mm2/s2; with a yield stress only
    F curvature;                      ///< mean kappa of both cells, 1/mm
    CellEnd<F> end_left, end_right;   ///< of paint with a contact angle
    F u, u_back, u_front, u_before,
        u_after;                        ///< old velocity here, one face along the axis, one face across
    F v;                                ///< old velocity along the face, mean of the four around it
    F viscosity_left, viscosity_right;  ///< mm2/s; of varied paint only
    F yield_left, yield_right;          ///< tau_y/rho, mm2/s2; of varied paint only
    CellNumbers<F> numbers_left, numbers_right;  ///< of several media only
};

/// The steps of a value from cell to cell along a face, in the rows on both sides of it. `value(n)` is
/// of the cell n further than the left one; the right one stands `s` further, the next ones along the
/// face `t`.
template <class F, class Value>
PASTOSO_LANE_FUNCTION std::array<F, 4> steps_across(const Value& value, std::ptrdiff_t s,
                                                    std::ptrdiff_t t) {
    const F left = value(0), right = value(s);
    return {left - value(-t), value(t) - left, right - value(s - t), value(s + t) - right};
}
template <class F>
PASTOSO_LANE_FUNCTION F mean_step(const std::array<F, 4>& steps) {
    return F(0.25F) * ((steps[0] + steps[1]) + (steps[2] + steps[3]));
}

/// How much a value rises from cell to cell along a face: the mean over those of its steps that lie
/// within the film, where the cells are wet(n).
template <class F, class Value, class Wet>
PASTOSO_LANE_FUNCTION F difference_across(const Value& value, const Wet& wet, std::ptrdiff_t s,
                                          std::ptrdiff_t t) {
    const std::array<F, 4> steps = steps_across<F>(value, s, t);
    const auto wet_left = wet(0), wet_right = wet(s);
    const decltype(wet(0)) inside[4] = {wet_left && wet(-t), wet_left && wet(t), wet_right && wet(s - t),
                                        wet_right && wet(s + t)};
    if (lanes::all((inside[0] && inside[1]) && (inside[2] && inside[3]))) return mean_step(steps);
    const auto part = [&](int n) { return lanes::select(inside[n], steps[n], F(0.0F)); };
    const auto count = [&](int n) { return lanes::select(inside[n], F(1.0F), F(0.0F)); };
    const F counted = (count(0) + count(1)) + (count(2) + count(3));
    return ((part(0) + part(1)) + (part(2) + part(3))) / lanes::max(counted, F(1.0F));
}

/// The consistency of the paint at a face. Uniform paint has the step's and stores nothing.
template <class F, bool kVaried>
struct FaceConsistency {
    static F viscosity(const StepConstants& step) { return F(step.viscosity_mm2_s); }
    static F fluidity(const StepConstants& step) { return F(1.0F / step.viscosity_mm2_s); }
    static F against_yield(const StepConstants& step) { return F(step.viscosity_mm2_s / step.yield); }
    static F over_yield_in_step(F impulse, const StepConstants& step) {
        return impulse * F(1.0F / (step.dt_s * step.yield));
    }
};
template <class F>
struct FaceConsistency<F, true> {
    F nu, tau;  ///< mm2/s, mm2/s2

    F viscosity(const StepConstants&) const { return nu; }
    F fluidity(const StepConstants&) const { return F(1.0F) / nu; }
    F against_yield(const StepConstants&) const { return nu / tau; }
    F over_yield_in_step(F impulse, const StepConstants& step) const {
        return impulse / (F(step.dt_s) * tau);
    }
};

/// The other numbers of the paint at a face, likewise.
template <class F, bool kMedia>
struct FaceNumbers {
    static F tension(const StepConstants& step) { return F(step.tension); }
    static F flow_index(const StepConstants& step) { return F(step.flow_index); }
    static F mean_drag(const StepConstants& step) {
        return F(0.5F * (step.drag_along + step.drag_against));
    }
    static F drag_range(const StepConstants& step) {
        return F(0.5F * (step.drag_along - step.drag_against));
    }
    static F drag_along(const StepConstants& step) { return F(step.drag_along); }
    static F slip_mm(const StepConstants& step) { return F(step.slip_mm); }
    static F tan_advancing(const StepConstants& step) { return F(step.tan_advancing); }
    static F tan_receding(const StepConstants& step) { return F(step.tan_receding); }
};
template <class F>
struct FaceNumbers<F, true> {
    CellNumbers<F> numbers;

    F tension(const StepConstants&) const { return numbers.tension; }
    F flow_index(const StepConstants&) const { return numbers.flow_index; }
    F mean_drag(const StepConstants&) const {
        return F(0.5F) * (numbers.drag_along + numbers.drag_against);
    }
    F drag_range(const StepConstants&) const {
        return F(0.5F) * (numbers.drag_along - numbers.drag_against);
    }
    F drag_along(const StepConstants&) const { return numbers.drag_along; }
    F slip_mm(const StepConstants&) const { return numbers.slip_mm; }
    F tan_advancing(const StepConstants&) const { return numbers.tan_advancing; }
    F tan_receding(const StepConstants&) const { return numbers.tan_receding; }
};

template <class F, FaceModel kModel>
struct FacePaint : FaceConsistency<F, kModel.varied>, FaceNumbers<F, kModel.media> {};

/// The mean of ln nu and that of tau_y of both cells, as in any mixture (paint_cell.hpp); where one of
/// them is dry, the wet cell's. A trace of yield stress stands for none.
template <class F>
PASTOSO_LANE_FUNCTION FaceConsistency<F, true> face_consistency(const FaceNeighbourhood<F>& face,
                                                                const StepConstants& step) {
    const auto wet_left = face.h_left > F(step.wet_mm), wet_right = face.h_right > F(step.wet_mm);
    const auto wet_both = wet_left && wet_right;
    const F nu = lanes::sqrt(F(face.viscosity_left * face.viscosity_right));
    const F tau = F(0.5F) * (face.yield_left + face.yield_right);
    const F edge_nu = lanes::select(wet_left, face.viscosity_left, face.viscosity_right);
    const F edge_tau = lanes::select(wet_left, face.yield_left, face.yield_right);
    return {lanes::select(wet_both, nu, edge_nu),
            lanes::max(F(lanes::select(wet_both, tau, edge_tau)), F(1e-9F))};
}

/// The means of both cells; where one of them is dry, the wet cell's. The angles are those of the
/// thinner of the wet ones, in which the film ends if it does.
template <class F>
PASTOSO_LANE_FUNCTION FaceNumbers<F, true> face_numbers(const FaceNeighbourhood<F>& face,
                                                        const StepConstants& step) {
    const auto wet_left = face.h_left > F(step.wet_mm), wet_right = face.h_right > F(step.wet_mm);
    const auto wet_both = wet_left && wet_right;
    const CellNumbers<F>&left = face.numbers_left, &right = face.numbers_right;
    const auto mean = [&](F CellNumbers<F>::*number) {
        return lanes::select(wet_both, F(F(0.5F) * (left.*number + right.*number)),
                             lanes::select(wet_left, left.*number, right.*number));
    };
    const auto ends_left = wet_left && (!wet_right || face.h_left < face.h_right);
    const auto at_end = [&](F CellNumbers<F>::*number) {
        return lanes::select(ends_left, left.*number, right.*number);
    };
    return {{.density_kg_m3 = mean(&CellNumbers<F>::density_kg_m3),
             .tension = mean(&CellNumbers<F>::tension),
             .flow_index = mean(&CellNumbers<F>::flow_index),
             .drag_against = mean(&CellNumbers<F>::drag_against),
             .drag_along = mean(&CellNumbers<F>::drag_along),
             .slip_mm = mean(&CellNumbers<F>::slip_mm),
             .tan_advancing = at_end(&CellNumbers<F>::tan_advancing),
             .tan_receding = at_end(&CellNumbers<F>::tan_receding)}};
}

/// What flows through a face is taken as an equal mixture of both cells.
template <FaceModel kModel, class F>
PASTOSO_LANE_FUNCTION FacePaint<F, kModel> face_paint(const FaceNeighbourhood<F>& face,
                                                      const StepConstants& step) {
    FacePaint<F, kModel> paint;
    if constexpr (kModel.varied)
        static_cast<FaceConsistency<F, true>&>(paint) = face_consistency(face, step);
    if constexpr (kModel.media) static_cast<FaceNumbers<F, true>&>(paint) = face_numbers(face, step);
    return paint;
}

}  // namespace pastoso::film
