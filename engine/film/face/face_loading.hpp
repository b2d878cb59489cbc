// Faces of a gathered block, a register at a time, and the model that a step asks for: shared by the
// kernels of one instruction set.
#pragma once

#include "film/explicit/tile_step.hpp"
#include "film/face/face_physics.hpp"
#include "film/face/lane_groups.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

/// The two directions of faces, told apart by index strides into the block.
struct Axis {
    int along, across;
    const float* velocity;         ///< old, of this component
    const float* velocity_across;  ///< old, of the other
    float force, force_across;
};

/// A number of the paint in cell i of a block, of which all of it has `of_all` unless it is of several
/// media.
[[maybe_unused, gnu::always_inline]] inline Lanes cell_number(const BlockArray<float>& of_cells,
                                                              float of_all, int i,
                                                              const StepConstants& step) {
    return step.media ? load(&of_cells[i]) : Lanes(of_all);
}

/// The tension at a face of several media, over the step's: the mean of both cells, or the wet one's.
[[maybe_unused, gnu::always_inline]] inline Lanes relative_tension(const HaloBlock& block,
                                                                   const StepConstants& step, int left,
                                                                   int right) {
    const auto wet_left = load(&block.thickness[left]) > Lanes(step.wet_mm);
    const auto wet_right = load(&block.thickness[right]) > Lanes(step.wet_mm);
    const Lanes of_left = load(&block.numbers.tension[left]);
    const Lanes of_right = load(&block.numbers.tension[right]);
    const Lanes tension = lanes::select(wet_left && wet_right, Lanes(Lanes(0.5F) * (of_left + of_right)),
                                        lanes::select(wet_left, of_left, of_right));
    return Lanes(step.tension > 0.0F ? 1.0F / step.tension : 0.0F) * tension;
}

template <class Load>
[[gnu::always_inline]] inline CellNumbers<Lanes> cell_numbers(const HaloBlock& block,
                                                              const Load& load_at, int i) {
    const CellNumbers<BlockArray<float>>& numbers = block.numbers;
    return {.density_kg_m3 = load_at(&numbers.density_kg_m3[i]),
            .tension = load_at(&numbers.tension[i]),
            .flow_index = load_at(&numbers.flow_index[i]),
            .drag_against = load_at(&numbers.drag_against[i]),
            .drag_along = load_at(&numbers.drag_along[i]),
            .slip_mm = load_at(&numbers.slip_mm[i]),
            .tan_advancing = load_at(&numbers.tan_advancing[i]),
            .tan_receding = load_at(&numbers.tan_receding[i])};
}

template <class Load>
[[gnu::always_inline]] inline CellEnd<Lanes> cell_end(const FilmEnds& ends, const Axis& axis,
                                                      const Load& load_at, int i) {
    const bool along_x = axis.along == 1;
    return {.contact_slope = load_at(&ends.contact_slope[i]),
            .slope = load_at(&ends.slope[i]),
            .reach_mm = load_at(&ends.reach_mm[i]),
            .depth_mm = load_at(along_x ? &ends.depth_x_mm[i] : &ends.depth_y_mm[i]),
            .over_mm = load_at(along_x ? &ends.over_x_mm[i] : &ends.over_y_mm[i]),
            .normal_along = load_at(along_x ? &ends.normal_x[i] : &ends.normal_y[i])};
}

/// Whether the film ends in no cell at a group of faces along a row, from cell i of the block on.
[[maybe_unused, gnu::always_inline]] inline bool are_off_ends(const TileScratch& scratch,
                                                              const StepConstants& step, int along,
                                                              int i) {
    const float* h = scratch.block.thickness.data() + i;
    if (!lanes::all(lanes::min(load(h), load(h + along)) > Lanes(step.wet_mm))) return false;
    if (!step.has_contact_angle()) return true;
    const float* end_slope = scratch.ends.slope.data() + i;
    return lanes::all(lanes::max(load(end_slope), load(end_slope + along)) == Lanes(0.0F));
}

/// Whether they are in the middle of the film, for all that the model looks at.
template <FaceModel kModel>
[[gnu::always_inline]] inline bool are_in_film(const TileScratch& scratch, const StepConstants& step,
                                               const Axis& axis, int i) {
    if (!are_off_ends(scratch, step, axis.along, i)) return false;
    if constexpr (!kModel.yield) return true;
    const float* h = scratch.block.thickness.data() + i;
    const int s = axis.along, t = axis.across;
    const Lanes thinnest =
        lanes::min(lanes::min(load(h - t), load(h + t)), lanes::min(load(h + s - t), load(h + s + t)));
    return lanes::all(thinnest > Lanes(step.wet_mm));
}

template <FaceModel kModel, FacePlace kPlace, class Load>
[[gnu::always_inline]] inline FaceNeighbourhood<Lanes> neighbourhood(const TileScratch& scratch,
                                                                     const StepConstants& step,
                                                                     const Axis& axis,
                                                                     const Load& load_at, int i) {
    const HaloBlock& block = scratch.block;
    const int s = axis.along, t = axis.across;
    const float* eta = block.eta.data();
    const float* u = axis.velocity;
    const float* v = axis.velocity_across;
    FaceNeighbourhood<Lanes> face;
    face.h_left = load_at(&block.thickness[i]);
    face.h_right = load_at(&block.thickness[i + s]);
    face.support_left = load_at(&block.support[i]);
    face.support_right = load_at(&block.support[i + s]);
    face.eta_left2 = load_at(eta + i - s);
    face.eta_left = load_at(eta + i);
    face.eta_right = load_at(eta + i + s);
    face.eta_right2 = load_at(eta + i + 2 * s);
    face.rise_left = load_at(&scratch.rise_mm[i]);
    face.rise_right = load_at(&scratch.rise_mm[i + s]);
    face.eta_slope_across =
        Lanes(0.25F * step.inverse_cell) * ((load_at(eta + i + t) - load_at(eta + i - t)) +
                                            (load_at(eta + i + s + t) - load_at(eta + i + s - t)));
    face.pressure_left = load_at(&scratch.pressure[i]);
    face.pressure_right = load_at(&scratch.pressure[i + s]);
    if constexpr (kModel.yield) {
        const auto pressure = [&](std::ptrdiff_t n) { return load_at(&scratch.pressure[i + n]); };
        const auto is_wet = [&](std::ptrdiff_t n) {
            return load_at(&block.thickness[i + n]) > Lanes(step.wet_mm);
        };
        face.pressure_rise_across = kPlace == FacePlace::InFilm
                                        ? mean_step(steps_across<Lanes>(pressure, s, t))
                                        : difference_across<Lanes>(pressure, is_wet, s, t);
    }
    face.curvature = Lanes(0.5F) * (load_at(&scratch.curvature[i]) + load_at(&scratch.curvature[i + s]));
    if constexpr (kPlace == FacePlace::Anywhere) {
        face.end_left = cell_end(scratch.ends, axis, load_at, i);
        face.end_right = cell_end(scratch.ends, axis, load_at, i + s);
    }
    face.u = load_at(u + i);
    face.u_back = load_at(u + i - s);
    face.u_front = load_at(u + i + s);
    face.u_before = load_at(u + i - t);
    face.u_after = load_at(u + i + t);
    face.v = Lanes(0.25F) *
             ((load_at(v + i) + load_at(v + i + s)) + (load_at(v + i - t) + load_at(v + i + s - t)));
    if constexpr (kModel.varied) {
        face.viscosity_left = load_at(&block.viscosity[i]);
        face.viscosity_right = load_at(&block.viscosity[i + s]);
        face.yield_left = load_at(&block.yield[i]);
        face.yield_right = load_at(&block.yield[i + s]);
    }
    if constexpr (kModel.media) {
        face.numbers_left = cell_numbers(block, load_at, i);
        face.numbers_right = cell_numbers(block, load_at, i + s);
    }
    return face;
}

/// Calls shut_x(face) and shut_y(face) for all faces between two cells of the tile.
template <class ShutX, class ShutY>
void for_each_inner_face(int columns, int rows, const ShutX& shut_x, const ShutY& shut_y) {
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            if (x + 1 < columns) shut_x(face_index(x, y));
            if (y + 1 < rows) shut_y(face_index(x, y));
        }
}

/// Calls shut_x(face) and shut_y(face) for all faces of covered cells.
template <class ShutX, class ShutY>
void for_each_covered_face(int columns, int rows, const HaloBlock& block, const ShutX& shut_x,
                           const ShutY& shut_y) {
    const auto covered = [&](int x, int y) { return block.covered[block_index(x, y)] != 0; };
    for (int y = -1; y < rows; ++y)
        for (int x = -1; x < columns; ++x) {
            if (y >= 0 && (covered(x, y) || covered(x + 1, y))) shut_x(face_index(x, y));
            if (x >= 0 && (covered(x, y) || covered(x, y + 1))) shut_y(face_index(x, y));
        }
}

/// Calls shut_x(face) and shut_y(face) for the faces of a tile through which nothing may flow: those
/// that are closed, those of covered cells and all beyond the canvas.
template <class ShutX, class ShutY>
void for_each_shut_face(int columns, int rows, const ClosedFaces& closed, const HaloBlock& block,
                        const ShutX& shut_x, const ShutY& shut_y) {
    using grid::kTileSize;
    if (block.any_covered) for_each_covered_face(columns, rows, block, shut_x, shut_y);
    if (closed.inside) for_each_inner_face(columns, rows, shut_x, shut_y);
    for (int y = 0; y < kTileSize; ++y) {
        if (closed.left) shut_x(face_index(-1, y));
        const int first_shut = y >= rows ? -1 : columns - (closed.right ? 1 : 0);
        for (int x = first_shut; x < kTileSize; ++x)
            shut_x(face_index(x, y));
    }
    for (int y = -1; y < kTileSize; ++y) {
        const bool shut_row = (y == -1 && closed.top) || (y == rows - 1 && closed.bottom) || y >= rows;
        for (int x = shut_row ? 0 : columns; x < kTileSize; ++x)
            shut_y(face_index(x, y));
    }
}

/// The rare terms, horizontal tension and shear thinning, are compiled with the alpha range only.
template <bool kYield, class Visit>
auto with_uniform_model(const StepConstants& step, const Visit& visit) {
    constexpr FaceModel kPlain{.yield = kYield};
    constexpr FaceModel kAlpha{.yield = kYield, .alpha_range = true};
    constexpr FaceModel kTension{.yield = kYield, .alpha_range = true, .horizontal_tension = true};
    constexpr FaceModel kThinning{
        .yield = kYield, .alpha_range = true, .horizontal_tension = true, .shear_thinning = true};
    if (step.is_shear_thinning()) return visit.template operator()<kThinning>();
    if (step.has_horizontal_tension()) return visit.template operator()<kTension>();
    return step.has_alpha_range() ? visit.template operator()<kAlpha>()
                                  : visit.template operator()<kPlain>();
}

/// Each cell may have a yield stress, and many do.
template <class Visit>
auto with_varied_model(const StepConstants& step, const Visit& visit) {
    constexpr FaceModel kVaried{.yield = true, .alpha_range = true, .varied = true};
    constexpr FaceModel kAll{.yield = true,
                             .alpha_range = true,
                             .horizontal_tension = true,
                             .shear_thinning = true,
                             .varied = true};
    constexpr FaceModel kMedia{.yield = true,
                               .alpha_range = true,
                               .horizontal_tension = true,
                               .shear_thinning = true,
                               .varied = true,
                               .media = true};
    if (step.media) return visit.template operator()<kMedia>();
    const bool rare = step.is_shear_thinning() || step.has_horizontal_tension();
    return rare ? visit.template operator()<kAll>() : visit.template operator()<kVaried>();
}

/// Calls visit<kModel>() for the smallest face model that holds all terms of the step.
template <class Visit>
auto with_face_model(const StepConstants& step, const Visit& visit) {
    if (step.varied) return with_varied_model(step, visit);
    return step.has_yield() ? with_uniform_model<true>(step, visit)
                            : with_uniform_model<false>(step, visit);
}

}  // namespace
}  // namespace pastoso::film::PASTOSO_ISA
