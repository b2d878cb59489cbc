// A tile's local solve: the patch of the tile and its overlap, with the neighbours' pressure around it
// held fixed. Compiled once per instruction set; see pastoso_add_kernels.
#include "film/face/lane_groups.hpp"
#include "film/large/large_kernels.hpp"
#include "film/large/multigrid_rows.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

using grid::kTileSize;

/// Errors of thicker film are relative to this.
constexpr float kThick_cells = 2.0F;

/// sum over the four faces of coefficient (value - neighbour's value) of the tile's cell (x, y)
Lanes difference(const FaceArray<float>& x_faces, const FaceArray<float>& y_faces,
                 const WindowArray& values, int x, int y) {
    const float* v = &values[window_index(x, y)];
    const int f = face_index(x, y);
    const Lanes here = load(v);
    return (load(&x_faces[f]) * (here - load(v + 1)) + load(&x_faces[f - 1]) * (here - load(v - 1))) +
           (load(&y_faces[f]) * (here - load(v + kWindowStride)) +
            load(&y_faces[f - kFaceStride]) * (here - load(v - kWindowStride)));
}

Lanes face_sum(const FaceArray<float>& x_faces, const FaceArray<float>& y_faces, int f) {
    return (load(&x_faces[f]) + load(&x_faces[f - 1])) +
           (load(&y_faces[f]) + load(&y_faces[f - kFaceStride]));
}

Lanes thickness_mm(const std::int32_t* quanta) {
    const auto held = lanes::load<lanes::As<std::int32_t, Lanes>>(quanta);
    return lanes::convert<float>(held) * Lanes(static_cast<float>(kThicknessQuantum_mm));
}

}  // namespace

void compute_change(const LargeScratch& large, LargeTile& tile) {
    for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x < kTileSize; x += kLanes) {
            const int cell = y * kTileSize + x;
            const Lanes outflow = difference(tile.x.mobility, tile.y.mobility, large.pressure, x, y);
            store(&tile.change[cell], load(&tile.source[cell]) - outflow);
        }
}

float compute_residual(const StepConstants& step, int columns, int rows, const std::int32_t* thickness,
                       const LargeScratch& large, LargeTile& tile) {
    const Lanes gravity(step.gravity_mm_s2),
        tension(step.tension * step.inverse_cell * step.inverse_cell);
    // In thick paint the same relative error would be a ripple that shows.
    const Lanes thick(kThick_cells * step.cell_mm), floor(0.05F * step.cell_mm);
    const Lanes huge(1e30F), one(1.0F);
    const auto lane_number = lanes::counting<Lanes>();
    Lanes worst(0.0F);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; x += kLanes) {
            const int f = face_index(x, y), cell = y * kTileSize + x;
            const Lanes change = load(&tile.change[cell]);
            const Lanes bend = difference(tile.x.weight, tile.y.weight, large.change, x, y);
            const Lanes target = load(&tile.rest_pressure[cell]) + gravity * change + tension * bend;
            const Lanes residual = target - load(&tile.pressure[cell]);
            store(&tile.residual[cell], residual);
            const Lanes a = face_sum(tile.x.mobility, tile.y.mobility, f);
            const Lanes s = gravity + tension * face_sum(tile.x.weight, tile.y.weight, f);
            const Lanes h = lanes::min(thickness_mm(thickness + cell), thick);
            const Lanes relative =
                lanes::abs(Lanes(a * residual)) / ((one + a * s) * (h + lanes::abs(change) + floor));
            // What is not a number counts as large, what lies beyond the canvas not at all.
            const Lanes counted = lanes::select(relative < huge, relative, huge);
            const auto on_canvas = lane_number < Lanes(static_cast<float>(columns - x));
            worst = lanes::max(worst, lanes::select(on_canvas, counted, Lanes(0.0F)));
        }
    return lanes::largest(worst);
}

namespace {

/// Puts a window's patch into the finest level's checkerboard order, and back.
void split_patch(const WindowArray& window, const MultigridLevel& finest, LevelValues& out) {
    for (int y = 0; y < kPatchSize; ++y)
        split_row(finest, y, &window[window_index(-kOverlap, y - kOverlap)], out);
}
void merge_patch(const MultigridLevel& finest, const LevelValues& values, WindowArray& window) {
    for (int y = 0; y < kPatchSize; ++y)
        merge_row(finest, y, values, &window[window_index(-kOverlap, y - kOverlap)]);
}

/// The correction that a V-cycle finds for the residual.
void compute_direction(const StepConstants& step, LargeScratch& scratch) {
    MultigridLevel& finest = scratch.levels[0];
    split_patch(scratch.residual, finest, finest.pressure_source);
    multigrid_cycle(step, scratch);
    merge_patch(finest, finest.pressure, scratch.direction);
}

template <class Visit>
void for_each_patch_group(const Visit& visit) {
    const int first = -kOverlap, last = kTileSize + kOverlap;
    static_assert(kPatchSize % 4 == 0);
    for (int y = first; y < last; ++y)
        for (int x = first; x < last; x += 4)
            visit(window_index(x, y));
}

using Quad = lanes::Lanes<float, 4>;
Quad load_quad(const float* values) {
    return lanes::load<Quad>(values);
}

Quad quad_difference(const WindowArray& x_faces, const WindowArray& y_faces, const WindowArray& values,
                     int i) {
    const float* v = values.data() + i;
    const Quad here = load_quad(v);
    return (load_quad(&x_faces[i]) * (here - load_quad(v + 1)) +
            load_quad(&x_faces[i - 1]) * (here - load_quad(v - 1))) +
           (load_quad(&y_faces[i]) * (here - load_quad(v + kWindowStride)) +
            load_quad(&y_faces[i - kWindowStride]) * (here - load_quad(v - kWindowStride)));
}

/// T = A c and W = c + S T of the direction c.
void respond(const StepConstants& step, LargeScratch& scratch) {
    const Quad gravity(step.gravity_mm_s2),
        tension(step.tension * step.inverse_cell * step.inverse_cell);
    for_each_patch_group([&](int i) {
        lanes::store(&scratch.flow[i],
                     quad_difference(scratch.mobility_x, scratch.mobility_y, scratch.direction, i));
    });
    for_each_cell_beyond(scratch.levels[0], [&](int x, int y) {
        scratch.flow[window_index(x - kOverlap, y - kOverlap)] = 0.0F;
    });
    for_each_patch_group([&](int i) {
        const Quad bend = quad_difference(scratch.weight_x, scratch.weight_y, scratch.flow, i);
        const Quad response =
            load_quad(&scratch.direction[i]) + gravity * load_quad(&scratch.flow[i]) + tension * bend;
        lanes::store(&scratch.response[i], response);
    });
}

/// A sum over the patch whose order does not depend on the instruction set.
double dot(const WindowArray& a, const WindowArray& b) {
    lanes::Lanes<double, 4> sum(0.0);
    for_each_patch_group([&](int i) {
        sum += lanes::convert<double>(load_quad(&a[i])) * lanes::convert<double>(load_quad(&b[i]));
    });
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

void add_scaled(float factor, const WindowArray& values, WindowArray& out) {
    for_each_patch_group([&](int i) {
        const Quad sum = load_quad(&out[i]) + Quad(factor) * load_quad(&values[i]);
        lanes::store(&out[i], sum);
    });
}

/// Preconditioned conjugate directions with exact line search on
///     J(c) = <c, A c>/2 + <A c, S A c>/2 - <A c, R>:
/// J falls with every cycle, however rough the mobility.
void descend(const StepConstants& step, int cycles, LargeScratch& scratch, WindowArray& correction) {
    constexpr double kSolved = 1e-3;
    double last_curvature = 0.0, first_decrease = 0.0;
    for (int cycle = 0; cycle < cycles; ++cycle) {
        compute_direction(step, scratch);
        respond(step, scratch);
        if (last_curvature > 0.0) {
            const auto overlap =
                static_cast<float>(-dot(scratch.flow, scratch.last_response) / last_curvature);
            add_scaled(overlap, scratch.last_direction, scratch.direction);
            add_scaled(overlap, scratch.last_flow, scratch.flow);
            add_scaled(overlap, scratch.last_response, scratch.response);
        }
        const double curvature = dot(scratch.flow, scratch.response);
        const double slope = dot(scratch.flow, scratch.residual);
        if (!(curvature > 0.0) || !(slope > 0.0)) return;
        const auto length = static_cast<float>(slope / curvature);
        add_scaled(length, scratch.direction, correction);
        add_scaled(-length, scratch.response, scratch.residual);
        const double decrease = slope * slope / curvature;
        first_decrease = std::max(first_decrease, decrease);
        if (decrease < kSolved * first_decrease) return;
        last_curvature = curvature;
        scratch.last_direction = scratch.direction;
        scratch.last_flow = scratch.flow;
        scratch.last_response = scratch.response;
    }
}

}  // namespace

void correct_patch(const StepConstants& step, int cycles, const grid::Rect& within,
                   LargeScratch& scratch, PatchArray& correction) {
    prepare_multigrid(step, within, scratch);
    const WindowArray* found = &scratch.direction;
    if (cycles == 1) {
        compute_direction(step, scratch);
    } else {
        scratch.correction.fill(0.0F);
        descend(step, cycles, scratch, scratch.correction);
        found = &scratch.correction;
    }
    for (int y = 0; y < kPatchSize; ++y)
        std::copy_n(&(*found)[window_index(-kOverlap, y - kOverlap)], kPatchSize,
                    &correction[y * kPatchSize]);
}

namespace {

/// 3 t^2 - 2 t^3 over the 2 kOverlap cells at each end of a patch, 1 between.
std::array<float, kPatchSize> patch_weights() {
    std::array<float, kPatchSize> weights;
    for (int k = 0; k < kPatchSize; ++k) {
        const int to_edge = k < kPatchSize - 1 - k ? k : kPatchSize - 1 - k;
        const float t = to_edge < 2 * kOverlap ? (to_edge + 0.5F) / (2.0F * kOverlap) : 1.0F;
        weights[k] = t * t * (3.0F - 2.0F * t);
    }
    return weights;
}

}  // namespace

void blend_corrections(const PatchCover* covers, int count, CellArray& pressure) {
    static const std::array<float, kPatchSize> weights = patch_weights();
    CellArray sum{}, total{};
    for (const PatchCover* cover = covers; cover != covers + count; ++cover)
        for (int y = 0; y < cover->height; ++y) {
            const float weight_y = weights[cover->patch_y + y];
            const float* weight_x = &weights[cover->patch_x];
            const float* found =
                &(*cover->correction)[(cover->patch_y + y) * kPatchSize + cover->patch_x];
            float* to = &sum[(cover->y + y) * kTileSize + cover->x];
            float* weight = &total[(cover->y + y) * kTileSize + cover->x];
            for (int x = 0; x < cover->width; ++x) {
                to[x] += weight_y * weight_x[x] * found[x];
                weight[x] += weight_y * weight_x[x];
            }
        }
    for (int cell = 0; cell < grid::kTileCells; ++cell)
        pressure[cell] += sum[cell] / (total[cell] + 1e-30F);
}

}  // namespace pastoso::film::PASTOSO_ISA
