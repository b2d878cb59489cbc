// Compiled once per instruction set; see pastoso_add_kernels.
#include "film/explicit/tile_kernels.hpp"
#include "film/face/lane_groups.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

using grid::kTileSize;

/// Whether the cells and their four neighbours are all wet: then none of them has a contact line.
[[gnu::always_inline]] inline bool inside_film(const float* h, Lanes wet) {
    const Lanes beside = lanes::min(load(h - 1), load(h + 1));
    const Lanes above_below = lanes::min(load(h - kBlockStride), load(h + kBlockStride));
    return lanes::all(lanes::min(load(h), lanes::min(beside, above_below)) > wet);
}

/// |n_x| and |n_y| of the outline's normal by a 3 x 3 Sobel filter of the thickness: the contact angle
/// then acts alike in every direction. Inside the film, where nobody asks for them, they are left out.
void outline_normals(const HaloBlock& block, float wet_mm, int y, TileScratch& scratch) {
    const float* h = block.thickness.data();
    for_each_lane_group(-2, kTileSize + 2, [&](int x) {
        const int i = block_index(x, y);
        if (inside_film(h + i, Lanes(wet_mm))) return;
        const int above = i - kBlockStride, below = i + kBlockStride;
        const Lanes two(2.0F);
        const Lanes gradient_x =
            two * (load(h + i + 1) - load(h + i - 1)) +
            ((load(h + above + 1) - load(h + above - 1)) + (load(h + below + 1) - load(h + below - 1)));
        const Lanes gradient_y =
            two * (load(h + below) - load(h + above)) +
            ((load(h + below + 1) - load(h + above + 1)) + (load(h + below - 1) - load(h + above - 1)));
        const Lanes norm2 = gradient_x * gradient_x + gradient_y * gradient_y;
        const Lanes inverse = Lanes(1.0F) / lanes::sqrt(norm2 + Lanes(1e-20F));
        const auto defined = norm2 > Lanes(1e-14F);
        store(&scratch.normal_x[i],
              lanes::select(defined, lanes::abs(Lanes(gradient_x * inverse)), Lanes(1.0F)));
        store(&scratch.normal_y[i],
              lanes::select(defined, lanes::abs(Lanes(gradient_y * inverse)), Lanes(1.0F)));
    });
}

/// The slope at which a film of thickness h meets dry support: that of the wedge it forms in its cell,
/// within the receding and advancing angles.
Lanes contact_slope(Lanes h, Lanes normal_sum, const StepConstants& step) {
    return lanes::clamp(Lanes(Lanes(2.0F * step.inverse_cell) * h / (normal_sum + Lanes(1e-9F))),
                        Lanes(step.tan_receding), Lanes(step.tan_advancing));
}

/// sin of the slope angle for a slope given as a tangent, or the tangent itself for small slopes.
template <bool kFullCurvature>
Lanes bent(Lanes slope, Lanes slope_across) {
    if constexpr (!kFullCurvature) return slope;
    return slope / lanes::sqrt(Lanes(Lanes(1.0F) + slope * slope + slope_across * slope_across));
}

/// The slope at faces along one axis (`axis` and `across` are index strides), the contact angle's where
/// the film ends.
template <bool kFullCurvature>
void face_slopes(const TileScratch& scratch, const StepConstants& step, int y, int axis, int across,
                 const float* normal_along, float* slopes) {
    const HaloBlock& block = scratch.block;
    const float* h = block.thickness.data();
    const float* eta = block.eta.data();
    const Lanes wet(step.wet_mm), inverse_cell(step.inverse_cell), zero(0.0F);
    for_each_lane_group(-2, kTileSize + 1, [&](int x) {
        const int left = block_index(x, y), right = left + axis;
        const Lanes h_left = load(h + left), h_right = load(h + right);
        const Lanes slope = (load(eta + right) - load(eta + left)) * inverse_cell;
        const Lanes slope_across = Lanes(0.25F) * inverse_cell *
                                   ((load(eta + left + across) - load(eta + left - across)) +
                                    (load(eta + right + across) - load(eta + right - across)));
        Lanes result = bent<kFullCurvature>(slope, slope_across);
        const auto wet_left = h_left > wet, wet_right = h_right > wet;
        if (step.has_contact_angle() && !lanes::all(wet_left && wet_right)) {
            const Lanes sum_left = load(&scratch.normal_x[left]) + load(&scratch.normal_y[left]);
            const Lanes sum_right = load(&scratch.normal_x[right]) + load(&scratch.normal_y[right]);
            const Lanes falls = bent<kFullCurvature>(contact_slope(h_left, sum_left, step), zero) *
                                load(normal_along + left);
            const Lanes rises = bent<kFullCurvature>(contact_slope(h_right, sum_right, step), zero) *
                                load(normal_along + right);
            const Lanes edge =
                lanes::select(wet_left, Lanes(-falls), lanes::select(wet_right, rises, zero));
            result = lanes::select(wet_left && wet_right, result, edge);
        }
        store(slopes + left, result);
    });
}

/// kappa = -div(slope) and Pi = g eta + (sigma/rho) kappa + p_air/rho.
void surface_pressure(const StepConstants& step, int y, TileScratch& scratch) {
    for_each_lane_group(-1, kTileSize + 1, [&](int x) {
        const int i = block_index(x, y);
        const Lanes divergence = (load(&scratch.slope_x[i]) - load(&scratch.slope_x[i - 1])) +
                                 (load(&scratch.slope_y[i]) - load(&scratch.slope_y[i - kBlockStride]));
        const Lanes curvature = -divergence * Lanes(step.inverse_cell);
        store(&scratch.curvature[i], curvature);
        const Lanes air = scratch.block.pressed ? load(&scratch.block.air[i]) : Lanes(0.0F);
        store(&scratch.pressure[i], Lanes(step.gravity_mm_s2) * load(&scratch.block.eta[i]) +
                                        Lanes(step.tension) * curvature + air);
    });
}

/// Slopes, curvature and pressure in all rows that a flow through a wet row can look at.
template <bool kFullCurvature>
void prepare(const StepConstants& step, TileScratch& scratch) {
    const int first = lanes::max(scratch.block.first_wet_row - 1, -1);
    const int last = lanes::min(scratch.block.last_wet_row + 1, kTileSize);
    if (step.has_contact_angle())
        for (int y = first - 1; y <= last + 1; ++y)
            outline_normals(scratch.block, step.wet_mm, y, scratch);
    for (int y = first; y <= last; ++y)
        face_slopes<kFullCurvature>(scratch, step, y, 1, kBlockStride, scratch.normal_x.data(),
                                    scratch.slope_x.data());
    for (int y = first - 1; y <= last; ++y)
        face_slopes<kFullCurvature>(scratch, step, y, kBlockStride, 1, scratch.normal_y.data(),
                                    scratch.slope_y.data());
    for (int y = first; y <= last; ++y)
        surface_pressure(step, y, scratch);
}

}  // namespace

void prepare_pressure(const StepConstants& step, TileScratch& scratch) {
    if (step.full_curvature)
        prepare<true>(step, scratch);
    else
        prepare<false>(step, scratch);
}

}  // namespace pastoso::film::PASTOSO_ISA
