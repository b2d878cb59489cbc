// Where a film with a contact angle ends within a cell: the line in which its surface meets the support
// there, and the slope with which it does. Lengths are in cells where they do not say mm.
#pragma once

#include "film/face/face_model.hpp"

namespace pastoso::film {

template <class F>
struct OutlineNormal {
    F x, y;
};
/// The unit normal of the film's outline, towards thicker film, by a 3 x 3 Sobel filter: the contact
/// angle then acts alike in every direction. `thickness(i, j)` is that of the cell i to the right and j
/// below, mm.
template <class F, class Thickness>
PASTOSO_LANE_FUNCTION OutlineNormal<F> outline_normal(const Thickness& thickness) {
    const F one(1.0F), two(2.0F);
    const auto rise_x = [&](int y) { return F(thickness(1, y)) - F(thickness(-1, y)); };
    const auto rise_y = [&](int x) { return F(thickness(x, 1)) - F(thickness(x, -1)); };
    const F gradient_x = two * rise_x(0) + (rise_x(-1) + rise_x(1));
    const F gradient_y = two * rise_y(0) + (rise_y(1) + rise_y(-1));
    const F norm2 = gradient_x * gradient_x + gradient_y * gradient_y;
    const F inverse = one / lanes::sqrt(F(norm2 + F(1e-20F)));
    const auto defined = norm2 > F(1e-14F);
    return {lanes::select(defined, F(gradient_x * inverse), one),
            lanes::select(defined, F(gradient_y * inverse), one)};
}

/// The end of the film in a cell that a dry one is beside.
template <class F>
struct FilmEnd {
    F normal_x, normal_y;  ///< |n| of the outline
    F contact_slope;       ///< of the surface against the support at the contact line; 0 in other cells
    F slope;               ///< the same where the film enters the cell; 0 where it fills the cell
    F mean_slope;  ///< of the film in the cell; of a cliff that stands in it, its height in cells
    F covered;             ///< share of the cell; 1 in other cells
    F reach_mm;            ///< from the film inside to the contact line
    F depth_x_mm, depth_y_mm;  ///< mean thickness at the cell's inner x and y face
    F over_x_mm, over_y_mm;    ///< thickness that may leave through its outer ones
};

/// Integrals of the wedge q - n . x over a unit cell, x from its inner corner and n = (a, b), q up to
/// a + b: with (.)+ the positive part,
///     (q^m - (q - a)+^m - (q - b)+^m) / (m! a b)   for m = 2, 3, 4, 5.
template <class F>
struct Wedge {
    F area;         ///< m = 2: of the cell's part that is covered
    F volume;       ///< m = 3: under a slope of 1
    F bend_volume;  ///< m = 4: under half the wedge's square
    F rise_volume;  ///< m = 5: under a sixth of its cube
};
template <class F>
PASTOSO_LANE_FUNCTION Wedge<F> wedge(F q, F a, F b) {
    const F zero(0.0F);
    const F p = lanes::max(F(q - a), zero), r = lanes::max(F(q - b), zero);
    const F q2 = q * q, p2 = p * p, r2 = r * r;
    const F scale = F(0.5F) / (a * b);
    return {scale * (q2 - (p2 + r2)), F(1.0F / 3.0F) * scale * (q2 * q - (p2 * p + r2 * r)),
            F(1.0F / 12.0F) * scale * (q2 * q2 - (p2 * p2 + r2 * r2)),
            F(1.0F / 60.0F) * scale * (q2 * q2 * q - (p2 * p2 * p + r2 * r2 * r))};
}

/// The film inside, seen from a cell along the outline's normal, one and two cells further along the
/// axis that is nearer to it.
template <class F>
struct FilmInside {
    F near, far;            ///< thickness there, mm
    F distance;             ///< of `near` from the cell's centre; `far` is twice as far
    F near_mean, far_mean;  ///< what a bend of 1 takes from the means found there
};
/// `thickness(i, j)` is that of the cell i to the right and j below, mm, |i|, |j| <= 2; the normal
/// points to where the film is thicker.
template <class F, class Thickness>
PASTOSO_LANE_FUNCTION FilmInside<F> film_inside(const Thickness& thickness, F normal_x, F normal_y) {
    const F zero(0.0F), half(0.5F), one(1.0F);
    const F size_x = lanes::abs(normal_x), size_y = lanes::abs(normal_y);
    const auto right = normal_x > zero, below = normal_y > zero, along_x = size_x > size_y;
    const auto corner = [&](int x, int y) {
        return lanes::select(below, lanes::select(right, F(thickness(x, y)), F(thickness(-x, y))),
                             lanes::select(right, F(thickness(x, -y)), F(thickness(-x, -y))));
    };
    const auto at = [&](int along, int aside) {
        return lanes::select(along_x, corner(along, aside), corner(aside, along));
    };
    const F major = lanes::max(size_x, size_y), minor = lanes::min(size_x, size_y);
    const F aside = minor / major, twice = aside + aside;
    const auto straight = twice < one;
    const F far_aside = lanes::select(straight, twice, F(twice - one));
    // The mean over a cell, and between two of them the chord, lie below the arch of the surface.
    const auto below_arch = [&](F part) {
        return F(1.0F / 24.0F) + half * minor * minor * part * (one - part);
    };
    return {.near = at(1, 0) * (one - aside) + at(1, 1) * aside,
            .far = lanes::select(straight, at(2, 0), at(2, 1)) * (one - far_aside) +
                   lanes::select(straight, at(2, 1), at(2, 2)) * far_aside,
            .distance = one / major,
            .near_mean = below_arch(aside),
            .far_mean = below_arch(far_aside)};
}

/// The surface over the support, x the distance from the contact line: that of a film whose weight and
/// tension are in balance, l^2 = sigma/(rho g),
///     h = s l sinh(x/l) - k l^2 (cosh(x/l) - 1),
/// a parabola near the line, by two terms of each.
template <class F>
struct EndProfile {
    F slope, bend;  ///< s and k, mm
};
/// What a slope of 1 makes of the mean thickness that is found at x, and what a bend of 1 takes.
template <class F>
struct EndShape {
    F rise, fall;
};
/// `mean` as of FilmInside; `weight` is 1/l^2.
template <class F>
PASTOSO_LANE_FUNCTION EndShape<F> end_shape(F x, F mean, F weight) {
    const F half(0.5F), one(1.0F), x2 = x * x;
    return {x + weight * x * (F(1.0F / 6.0F) * x2 + mean),
            x2 * (half + weight * x2 * F(1.0F / 24.0F)) + mean * (one + half * weight * x2)};
}
/// Through the film inside, when `near` is x away from the line. Straight where there is too little film
/// to bend; a bend beyond that of drops that are a few cells wide, and of what weighs there, is noise.
template <class F>
PASTOSO_LANE_FUNCTION EndProfile<F> end_profile(const FilmInside<F>& inside, F x, F weight, F wet_mm) {
    const F zero(0.0F);
    const EndShape<F> near = end_shape(x, inside.near_mean, weight);
    const EndShape<F> far = end_shape(F(x + inside.distance), inside.far_mean, weight);
    const F bend = (inside.near * far.rise - inside.far * near.rise) /
                   (near.rise * far.fall - far.rise * near.fall);
    const F most = F(0.4F) * inside.near / (x * x) + weight * inside.far;
    const auto bends = inside.near > wet_mm && inside.far > wet_mm;
    const F k = lanes::select(bends, lanes::clamp(bend, F(-most), most), zero);
    return {(inside.near + k * near.fall) / near.rise, k};
}

/// What the search for the contact line goes by: how far the wedge that the film fills of the cell
/// reaches from the cell's inner corner, `filled` where that is all of it.
template <class F>
struct EndSearch {
    FilmInside<F> inside;
    F a, b, filled, thickness_mm, weight, wet_mm;

    F way(F q) const { return inside.distance + (q - F(0.5F) * filled); }
    EndProfile<F> profile(F q) const { return end_profile(inside, way(q), weight, wet_mm); }
    /// What a film of slope 1 holds there.
    F under_slope(const Wedge<F>& covered) const {
        return covered.volume + weight * covered.rise_volume;
    }
    /// What the cell holds more than the film that reaches so far would.
    F over(F q) const {
        const EndProfile<F> surface = profile(q);
        const Wedge<F> covered = wedge(q, a, b);
        return thickness_mm -
               (surface.slope * under_slope(covered) - surface.bend * covered.bend_volume);
    }
    /// Newton's method with the slope that the film has now, from outside: the wedge's volume is convex.
    F reach() const {
        constexpr int kIterations = 8;
        F q = filled;
        for (int iteration = 0; iteration < kIterations; ++iteration) {
            const Wedge<F> covered = wedge(q, a, b);
            const F rate = lanes::max(F(covered.area - covered.volume / way(q)), F(1e-6F));
            q = lanes::clamp(F(q + over(q) / (profile(q).slope * rate)), F(1e-3F), filled);
        }
        return q;
    }
};

/// 1/l^2 in cells, l the capillary length; of one that is shorter than a cell nothing is seen.
inline float end_weight(const StepConstants& step) {
    const float balance = step.tension * step.inverse_cell * step.inverse_cell;
    if (balance <= 0.0F) return 0.0F;
    return lanes::min(1.0F, step.gravity_mm_s2 / balance);
}

/// Of what lies too far out a step shall take at most all, and a large one lets a quarter of a cell
/// through.
inline constexpr float kStepsOver = 4.0F;

/// Finds the contact line: where the surface that holds the paint of the cell and of the film inside
/// meets the support. Where the film fills the cell, the line is at its outer corner. `thickness(i, j)`
/// as for outline_normal(), |i|, |j| <= 2; `tan_advancing` is the paint's.
template <class F, class Thickness>
PASTOSO_LANE_FUNCTION FilmEnd<F> film_end(const Thickness& thickness, F tan_advancing,
                                          const StepConstants& step) {
    const F zero(0.0F), half(0.5F), one(1.0F), least(0.01F), cell(step.cell_mm),
        per_cell(step.inverse_cell);
    const auto thinner = [&](int x, int y) {
        return lanes::min(F(thickness(x, y)), F(thickness(-x, -y)));
    };
    const F beside =
        lanes::min(lanes::min(thinner(1, 0), thinner(0, 1)), lanes::min(thinner(1, 1), thinner(1, -1)));
    const F h = thickness(0, 0), wet(step.wet_mm);
    const auto ends = h > wet && beside <= wet;
    if (!lanes::any(ends)) return {one, one, zero, zero, zero, one, zero, zero, zero, zero, zero};
    const OutlineNormal<F> normal = outline_normal<F>(thickness);
    const F a = lanes::max(lanes::abs(normal.x), least), b = lanes::max(lanes::abs(normal.y), least);
    const EndSearch<F> search{
        film_inside(thickness, normal.x, normal.y), a, b, a + b, h, F(end_weight(step)), wet};
    const F filled = search.filled;
    const auto partly = ends && search.inside.near > h && search.over(filled) < zero;
    const F q = lanes::select(partly, search.reach(), filled);
    const EndProfile<F> surface = search.profile(q);
    const Wedge<F> covered = wedge(q, a, b);
    const F contact_slope =
        lanes::select(partly, surface.slope,
                      F((h + surface.bend * covered.bend_volume) / search.under_slope(covered)));
    const F inner = search.way(q) - half * search.inside.distance;
    const F entering = surface.slope * (one + half * search.weight * inner * inner) -
                       surface.bend * inner * (one + F(1.0F / 6.0F) * search.weight * inner * inner);
    const F mean = search.inside.near / search.way(q);
    const F descent = surface.slope * (one + search.weight * covered.bend_volume / covered.area) -
                      surface.bend * covered.volume / covered.area;
    const F far_a = lanes::max(F(q - a), zero), far_b = lanes::max(F(q - b), zero);
    const F excess = lanes::max(F(contact_slope - tan_advancing * cell), zero);
    const F movable = F(kStepsOver) * excess * search.way(q);
    const auto leaving = [&](F far, F side) {
        return lanes::select(partly, lanes::min(movable, F(half * mean * far * far / side)),
                             F(excess * covered.volume));
    };
    return {.normal_x = lanes::abs(normal.x),
            .normal_y = lanes::abs(normal.y),
            .contact_slope = lanes::select(ends, contact_slope, zero) * per_cell,
            .slope = lanes::select(partly, entering, zero) * per_cell,
            .mean_slope = lanes::select(search.inside.near > h, descent, h) * per_cell,
            .covered = lanes::select(partly, covered.area, one),
            .reach_mm = search.way(q) * cell,
            .depth_x_mm = half * mean * (q * q - far_b * far_b) / b,
            .depth_y_mm = half * mean * (q * q - far_a * far_a) / a,
            .over_x_mm = leaving(far_a, b),
            .over_y_mm = leaving(far_b, a)};
}

}  // namespace pastoso::film
