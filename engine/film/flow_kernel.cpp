// Compiled once per instruction set; see pastoso_add_kernels.
#include "film/face_physics.hpp"
#include "film/lane_groups.hpp"
#include "film/tile_kernels.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

using grid::kTileSize;

/// The two directions of faces, told apart by index strides into the block.
struct Axis {
    int along, across;
    const float* velocity;         ///< old, of this component
    const float* velocity_across;  ///< old, of the other
    float force, force_across;
};

FaceNeighbourhood<Lanes> neighbourhood(const TileScratch& scratch, const StepConstants& step,
                                       const Axis& axis, int i) {
    const HaloBlock& block = scratch.block;
    const int s = axis.along, t = axis.across;
    const float* eta = block.eta.data();
    const float* u = axis.velocity;
    const float* v = axis.velocity_across;
    FaceNeighbourhood<Lanes> face;
    face.h_left = load(&block.thickness[i]);
    face.h_right = load(&block.thickness[i + s]);
    face.support_left = load(&block.support[i]);
    face.support_right = load(&block.support[i + s]);
    face.eta_left2 = load(eta + i - s);
    face.eta_left = load(eta + i);
    face.eta_right = load(eta + i + s);
    face.eta_right2 = load(eta + i + 2 * s);
    face.eta_slope_across =
        Lanes(0.25F * step.inverse_cell) *
        ((load(eta + i + t) - load(eta + i - t)) + (load(eta + i + s + t) - load(eta + i + s - t)));
    face.pressure_left = load(&scratch.pressure[i]);
    face.pressure_right = load(&scratch.pressure[i + s]);
    face.curvature = Lanes(0.5F) * (load(&scratch.curvature[i]) + load(&scratch.curvature[i + s]));
    face.normal_left = load(&scratch.normal_x[i]) + load(&scratch.normal_y[i]);
    face.normal_right = load(&scratch.normal_x[i + s]) + load(&scratch.normal_y[i + s]);
    face.u = load(u + i);
    face.u_back = load(u + i - s);
    face.u_front = load(u + i + s);
    face.u_before = load(u + i - t);
    face.u_after = load(u + i + t);
    face.v = Lanes(0.25F) * ((load(v + i) + load(v + i + s)) + (load(v + i - t) + load(v + i + s - t)));
    return face;
}

/// Thickness quanta carried in a step: |velocity| thickness dt / cell, rounded half away from zero.
template <class Ints>
Ints flux_quanta(const FaceFlow<Lanes>& flow, const StepConstants& step) {
    const Lanes scale(step.dt_s * step.inverse_cell * static_cast<float>(1.0 / kThicknessQuantum_mm));
    const Lanes exact = flow.velocity * flow.thickness * scale;
    return lanes::stdx::static_simd_cast<Ints>(Lanes(exact + lanes::copysign(Lanes(0.5F), exact)));
}

template <bool kYield, bool kAlphaRange>
void flow_row(const TileScratch& scratch, const StepConstants& step, const Axis& axis, int first_x,
              int y, FaceArray<float>& velocity, FaceArray<std::int32_t>& flux, FlowExtremes& extremes) {
    using Ints = lanes::stdx::rebind_simd_t<std::int32_t, Lanes>;
    Lanes mobility(0.0F), thickness(0.0F), speed(0.0F);
    for_each_lane_group(first_x, kTileSize, [&](int x) {
        const FaceNeighbourhood<Lanes> face = neighbourhood(scratch, step, axis, block_index(x, y));
        const FaceFlow<Lanes> flow =
            face_flow<kYield, kAlphaRange>(face, step, axis.force, axis.force_across);
        store(&velocity[face_index(x, y)], flow.velocity);
        flux_quanta<Ints>(flow, step).copy_to(&flux[face_index(x, y)], lanes::stdx::element_aligned);
        mobility = lanes::max(mobility, flow.mobility);
        speed = lanes::max(speed, lanes::abs(flow.velocity));
        thickness = lanes::max(thickness,
                               lanes::select(flow.velocity == Lanes(0.0F), Lanes(0.0F), flow.thickness));
    });
    extremes.mobility = lanes::max(extremes.mobility, lanes::stdx::hmax(mobility));
    extremes.thickness_mm = lanes::max(extremes.thickness_mm, lanes::stdx::hmax(thickness));
    extremes.speed_mm_s = lanes::max(extremes.speed_mm_s, lanes::stdx::hmax(speed));
}

void clear_face_row(int y, FaceArray<float>& velocity, FaceArray<std::int32_t>& flux) {
    for (int x = -1; x < kTileSize; ++x) {
        velocity[face_index(x, y)] = 0.0F;
        flux[face_index(x, y)] = 0;
    }
}

/// A quarter of the cell it leaves is the most that a flux may take.
void limit_fluxes(const BlockArray<std::int32_t>& quanta, int axis, int first_x, int y,
                  FaceArray<std::int32_t>& flux) {
    const std::int32_t* cell = &quanta[block_index(first_x, y)];
    std::int32_t* f = &flux[face_index(first_x, y)];
    const int count = kTileSize - first_x;
    for (int k = 0; k < count; ++k) {
        const std::int32_t forward = cell[k] >> 2, backward = -(cell[k + axis] >> 2);
        const std::int32_t capped = f[k] < forward ? f[k] : forward;
        f[k] = capped > backward ? capped : backward;
    }
}

void shut(int x, int y, FaceArray<float>& velocity, FaceArray<std::int32_t>& flux) {
    velocity[face_index(x, y)] = 0.0F;
    flux[face_index(x, y)] = 0;
}

/// Shuts closed edges and everything beyond the canvas.
void shut_edges(int columns, int rows, const ClosedEdges& closed, TileScratch& scratch) {
    for (int y = 0; y < kTileSize; ++y) {
        if (closed.left) shut(-1, y, scratch.velocity_x, scratch.flux_x);
        const int first_shut = y >= rows ? -1 : columns - (closed.right ? 1 : 0);
        for (int x = first_shut; x < kTileSize; ++x)
            shut(x, y, scratch.velocity_x, scratch.flux_x);
    }
    for (int y = -1; y < kTileSize; ++y) {
        const bool shut_row = (y == -1 && closed.top) || (y == rows - 1 && closed.bottom) || y >= rows;
        for (int x = shut_row ? 0 : columns; x < kTileSize; ++x)
            shut(x, y, scratch.velocity_y, scratch.flux_y);
    }
}

int count_clamped(const StepConstants& step, const FaceArray<float>& velocity, int first_x,
                  int first_y) {
    const float limit = 0.5F * step.cell_mm / step.dt_s;
    int count = 0;
    for (int y = first_y; y < kTileSize; ++y)
        for (int x = first_x; x < kTileSize; ++x)
            count += lanes::abs(velocity[face_index(x, y)]) >= limit ? 1 : 0;
    return count;
}

template <bool kYield, bool kAlphaRange>
FlowExtremes flow_all_faces(const StepConstants& step, TileScratch& scratch) {
    const HaloBlock& block = scratch.block;
    const Axis x_axis{1,
                      kBlockStride,
                      block.velocity_x.data(),
                      block.velocity_y.data(),
                      step.force_x_mm_s2,
                      step.force_y_mm_s2};
    const Axis y_axis{
        kBlockStride,      1, block.velocity_y.data(), block.velocity_x.data(), step.force_y_mm_s2,
        step.force_x_mm_s2};
    const int first = block.first_wet_row, last = block.last_wet_row;
    FlowExtremes extremes;
    for (int y = -1; y < kTileSize; ++y) {
        if (y >= first - 1 && y <= last) {
            flow_row<kYield, kAlphaRange>(scratch, step, y_axis, 0, y, scratch.velocity_y,
                                          scratch.flux_y, extremes);
            limit_fluxes(block.quanta, kBlockStride, 0, y, scratch.flux_y);
        } else {
            clear_face_row(y, scratch.velocity_y, scratch.flux_y);
        }
        if (y >= first && y <= last && y >= 0) {
            flow_row<kYield, kAlphaRange>(scratch, step, x_axis, -1, y, scratch.velocity_x,
                                          scratch.flux_x, extremes);
            limit_fluxes(block.quanta, 1, -1, y, scratch.flux_x);
        } else {
            clear_face_row(y, scratch.velocity_x, scratch.flux_x);
        }
    }
    return extremes;
}

FlowExtremes flow_faces(const StepConstants& step, TileScratch& scratch) {
    if (step.has_yield())
        return step.has_alpha_range() ? flow_all_faces<true, true>(step, scratch)
                                      : flow_all_faces<true, false>(step, scratch);
    return step.has_alpha_range() ? flow_all_faces<false, true>(step, scratch)
                                  : flow_all_faces<false, false>(step, scratch);
}

// The twelve channels of a cell as three registers of four: this width exists on every instruction set.

}  // namespace

FlowExtremes tile_flow(const StepConstants& step, int columns, int rows, const ClosedEdges& closed,
                       TileScratch& scratch) {
    if (scratch.block.last_wet_row >= scratch.block.first_wet_row) prepare_pressure(step, scratch);
    FlowExtremes extremes = flow_faces(step, scratch);
    shut_edges(columns, rows, closed, scratch);
    if (extremes.speed_mm_s >= 0.5F * step.cell_mm / step.dt_s)
        extremes.clamped_faces = count_clamped(step, scratch.velocity_x, -1, 0) +
                                 count_clamped(step, scratch.velocity_y, 0, -1);
    return extremes;
}

}  // namespace pastoso::film::PASTOSO_ISA
