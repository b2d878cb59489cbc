// Compiled once per instruction set; see pastoso_add_kernels.
#include "film/explicit/tile_kernels.hpp"
#include "film/face/face_loading.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

using grid::kTileSize;

/// The columns in which the film may end, and where ends are looked at.
constexpr int kFirstEnd = -2, kLastEnd = kTileSize + 2;

/// Whether a row is wet as far as ends are looked at and one cell beyond.
bool is_wet_row(const StepConstants& step, int y, const HaloBlock& block) {
    Lanes thinnest = load(&block.thickness[block_index(kFirstEnd - 1, y)]);
    for_each_lane_group(kFirstEnd - 1, kLastEnd + 1, [&](int x) {
        thinnest = lanes::min(thinnest, load(&block.thickness[block_index(x, y)]));
    });
    return lanes::all(thinnest > Lanes(step.wet_mm));
}

void clear_ends(int y, FilmEnds& ends) {
    for_each_lane_group(kFirstEnd, kLastEnd,
                        [&](int x) { store(&ends.slope[block_index(x, y)], Lanes(0.0F)); });
}

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
    for_each_lane_group(kFirstEnd, kLastEnd, [&](int x) {
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

/// Finds the ends in all rows from `first` to `last`. Between rows that are wet all along there are
/// none.
void find_ends_of_rows(const StepConstants& step, int first, int last, const HaloBlock& block,
                       FilmEnds& ends) {
    bool above = is_wet_row(step, first - 1, block), here = is_wet_row(step, first, block);
    for (int y = first; y <= last; ++y) {
        const bool below = is_wet_row(step, y + 1, block);
        if (above && here && below)
            clear_ends(y, ends);
        else
            find_ends(step, y, block, ends);
        above = here;
        here = below;
    }
}

/// sin of the slope angle for a slope given as a tangent, or the tangent itself for small slopes.
template <bool kFullCurvature>
Lanes bent(Lanes slope, Lanes slope_across) {
    if constexpr (!kFullCurvature) return slope;
    return slope / lanes::sqrt(Lanes(Lanes(1.0F) + slope * slope + slope_across * slope_across));
}

/// The surface's slope at faces along one axis (`along` is its index stride) where the film ends in one
/// of their cells.
template <bool kFullCurvature>
struct EndSlope {
    const TileScratch& scratch;
    const StepConstants& step;
    const float* normal_along;
    int along;

    /// Puts that slope in place of the film's. Not inlined: what it keeps in registers would slow down
    /// the faces far from it.
    [[gnu::noinline]] void bound(int left, Lanes& slope) const {
        const int right = left + along;
        const Lanes wet(step.wet_mm), zero(0.0F);
        const Lanes h_left = load(&scratch.block.thickness[left]);
        const Lanes h_right = load(&scratch.block.thickness[right]);
        const auto wet_left = h_left > wet, wet_right = h_right > wet, both = wet_left && wet_right;
        const Lanes edge =
            lanes::select(wet_left, Lanes(-at_dry(left)), lanes::select(wet_right, at_dry(right), zero));
        const auto ends_left = load(&scratch.ends.slope[left]) != zero && h_left < h_right;
        const auto ends_right = load(&scratch.ends.slope[right]) != zero && h_right < h_left;
        const Lanes within = lanes::select(ends_right, Lanes(-at_film(right)), at_film(left));
        slope = lanes::select(both, lanes::select(ends_left || ends_right, within, slope), edge);
    }

  private:
    /// At the end's dry side, where the contact angles bound it.
    Lanes at_dry(int i) const {
        const CellNumbers<BlockArray<float>>& numbers = scratch.block.numbers;
        return of_end(i, lanes::clamp(load(&scratch.ends.contact_slope[i]),
                                      cell_number(numbers.tan_receding, step.tan_receding, i, step),
                                      cell_number(numbers.tan_advancing, step.tan_advancing, i, step)));
    }
    /// At the side of the film.
    Lanes at_film(int i) const { return of_end(i, load(&scratch.ends.slope[i])); }
    Lanes of_end(int i, Lanes slope) const {
        return bent<kFullCurvature>(slope, Lanes(0.0F)) * load(normal_along + i);
    }
};

/// The slope at faces along one axis (`axis` and `across` are index strides), where the film ends that
/// of its end. Of several media, times the tension there over the step's: tension pulls along the
/// surface.
template <bool kFullCurvature>
void face_slopes(const TileScratch& scratch, const StepConstants& step, int y, int axis, int across,
                 const float* normal_along, float* slopes) {
    const float* eta = scratch.block.eta.data();
    const EndSlope<kFullCurvature> end{scratch, step, normal_along, axis};
    const Lanes inverse_cell(step.inverse_cell);
    for_each_lane_group(-2, kTileSize + 1, [&](int x) {
        const int left = block_index(x, y), right = left + axis;
        const Lanes slope = (load(eta + right) - load(eta + left)) * inverse_cell;
        const Lanes slope_across = Lanes(0.25F) * inverse_cell *
                                   ((load(eta + left + across) - load(eta + left - across)) +
                                    (load(eta + right + across) - load(eta + right - across)));
        Lanes result = bent<kFullCurvature>(slope, slope_across);
        if (step.has_contact_angle() && !are_off_ends(scratch, step, axis, left))
            end.bound(left, result);
        if (step.media) result = relative_tension(scratch.block, step, left, right) * result;
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
        find_ends_of_rows(step, first - 1, last + 1, scratch.block, scratch.ends);
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
