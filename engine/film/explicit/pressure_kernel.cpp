// Compiled once per instruction set; see pastoso_add_kernels.
#include "film/explicit/tile_kernels.hpp"
#include "film/face/face_loading.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

using grid::kTileSize;

/// Whether the cells and all around them are wet: then the film ends in none of them.
[[gnu::always_inline]] inline bool inside_film(const float* h, Lanes wet) {
    const auto thinnest = [](const float* row) {
        return lanes::min(lanes::min(load(row - 1), load(row + 1)), load(row));
    };
    return lanes::all(lanes::min(lanes::min(thinnest(h - kBlockStride), thinnest(h + kBlockStride)),
                                 thinnest(h)) > wet);
}

void find_ends(const StepConstants& step, int y, const HaloBlock& block, FilmEnds& ends) {
    const float* thickness = block.thickness.data();
    for_each_lane_group(-2, kTileSize + 2, [&](int x) {
        const int i = block_index(x, y);
        const float* h = thickness + i;
        if (inside_film(h, Lanes(step.wet_mm))) return store(&ends.slope[i], Lanes(0.0F));
        const FilmEnd<Lanes> end =
            film_end<Lanes>([h](int right, int below) { return load(h + below * kBlockStride + right); },
                            cell_number(block.numbers.tan_advancing, step.tan_advancing, i, step), step);
        store(&ends.normal_x[i], end.normal_x);
        store(&ends.normal_y[i], end.normal_y);
        store(&ends.contact_slope[i], end.contact_slope);
        store(&ends.slope[i], end.slope);
        store(&ends.reach_mm[i], end.reach_mm);
        store(&ends.depth_x_mm[i], end.depth_x_mm);
        store(&ends.depth_y_mm[i], end.depth_y_mm);
        store(&ends.over_x_mm[i], end.over_x_mm);
        store(&ends.over_y_mm[i], end.over_y_mm);
    });
}

/// sin of the slope angle for a slope given as a tangent, or the tangent itself for small slopes.
template <bool kFullCurvature>
Lanes bent(Lanes slope, Lanes slope_across) {
    if constexpr (!kFullCurvature) return slope;
    return slope / lanes::sqrt(Lanes(Lanes(1.0F) + slope * slope + slope_across * slope_across));
}

/// The surface's slope where the film ends in cell i: at its dry side, where the contact angles bound
/// it, and at the side of the film.
template <bool kFullCurvature>
struct EndSlope {
    const TileScratch& scratch;
    const StepConstants& step;
    const float* normal_along;

    Lanes at_dry(int i) const {
        const CellNumbers<BlockArray<float>>& numbers = scratch.block.numbers;
        return along(i, lanes::clamp(load(&scratch.ends.contact_slope[i]),
                                     cell_number(numbers.tan_receding, step.tan_receding, i, step),
                                     cell_number(numbers.tan_advancing, step.tan_advancing, i, step)));
    }
    Lanes at_film(int i) const { return along(i, load(&scratch.ends.slope[i])); }

  private:
    Lanes along(int i, Lanes slope) const {
        return bent<kFullCurvature>(slope, Lanes(0.0F)) * load(normal_along + i);
    }
};

/// The slope at faces along one axis (`axis` and `across` are index strides), where the film ends that
/// of its end. Of several media, times the tension there over the step's: tension pulls along the
/// surface.
template <bool kFullCurvature>
void face_slopes(const TileScratch& scratch, const StepConstants& step, int y, int axis, int across,
                 const float* normal_along, float* slopes) {
    const HaloBlock& block = scratch.block;
    const float* h = block.thickness.data();
    const float* eta = block.eta.data();
    const float* end_slope = scratch.ends.slope.data();
    const EndSlope<kFullCurvature> end{scratch, step, normal_along};
    const Lanes wet(step.wet_mm), inverse_cell(step.inverse_cell), zero(0.0F);
    for_each_lane_group(-2, kTileSize + 1, [&](int x) {
        const int left = block_index(x, y), right = left + axis;
        const Lanes h_left = load(h + left), h_right = load(h + right);
        const Lanes slope = (load(eta + right) - load(eta + left)) * inverse_cell;
        const Lanes slope_across = Lanes(0.25F) * inverse_cell *
                                   ((load(eta + left + across) - load(eta + left - across)) +
                                    (load(eta + right + across) - load(eta + right - across)));
        Lanes result = bent<kFullCurvature>(slope, slope_across);
        const auto put = [&](Lanes slope_there) {
            store(slopes + left,
                  step.media ? relative_tension(block, step, left, right) * slope_there : slope_there);
        };
        if (!step.has_contact_angle()) return put(result);
        const auto wet_left = h_left > wet, wet_right = h_right > wet, both = wet_left && wet_right;
        if (!lanes::all(both)) {
            const Lanes edge = lanes::select(wet_left, Lanes(-end.at_dry(left)),
                                             lanes::select(wet_right, end.at_dry(right), zero));
            result = lanes::select(both, result, edge);
        }
        const auto ends_left = both && load(end_slope + left) != zero && h_left < h_right;
        const auto ends_right = both && load(end_slope + right) != zero && h_right < h_left;
        if (lanes::any(ends_left || ends_right)) {
            const Lanes within =
                lanes::select(ends_right, Lanes(-end.at_film(right)), end.at_film(left));
            result = lanes::select(ends_left || ends_right, within, result);
        }
        put(result);
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

/// -(dt/2) div(h u) with the old velocities and the mean thickness at the faces.
void predict_rise(const StepConstants& step, int y, TileScratch& scratch) {
    const HaloBlock& block = scratch.block;
    const float* h = block.thickness.data();
    const Lanes half_courant(0.25F * step.dt_s * step.inverse_cell);
    const auto flow = [h](const BlockArray<float>& velocity, int i, int along) {
        return load(&velocity[i]) * (load(h + i) + load(h + i + along));
    };
    for_each_lane_group(-1, kTileSize + 1, [&](int x) {
        const int i = block_index(x, y);
        const Lanes along_x = flow(block.velocity_x, i, 1) - flow(block.velocity_x, i - 1, 1);
        const Lanes along_y = flow(block.velocity_y, i, kBlockStride) -
                              flow(block.velocity_y, i - kBlockStride, kBlockStride);
        store(&scratch.rise_mm[i], -half_courant * (along_x + along_y));
    });
}

/// Slopes, curvature and pressure in all rows that a flow through a wet row can look at.
template <bool kFullCurvature>
void prepare(const StepConstants& step, TileScratch& scratch) {
    const int first = lanes::max(scratch.block.first_wet_row - 1, -1);
    const int last = lanes::min(scratch.block.last_wet_row + 1, kTileSize);
    if (step.has_contact_angle())
        for (int y = first - 1; y <= last + 1; ++y)
            find_ends(step, y, scratch.block, scratch.ends);
    for (int y = first; y <= last; ++y)
        face_slopes<kFullCurvature>(scratch, step, y, 1, kBlockStride, scratch.ends.normal_x.data(),
                                    scratch.slope_x.data());
    for (int y = first - 1; y <= last; ++y)
        face_slopes<kFullCurvature>(scratch, step, y, kBlockStride, 1, scratch.ends.normal_y.data(),
                                    scratch.slope_y.data());
    for (int y = first; y <= last; ++y) {
        surface_pressure(step, y, scratch);
        predict_rise(step, y, scratch);
    }
}

}  // namespace

void prepare_pressure(const StepConstants& step, TileScratch& scratch) {
    if (step.full_curvature)
        prepare<true>(step, scratch);
    else
        prepare<false>(step, scratch);
}

}  // namespace pastoso::film::PASTOSO_ISA
