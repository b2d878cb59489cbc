// Compiled once per instruction set; see pastoso_add_kernels.
#include "film/face_physics.hpp"
#include "film/tile_step.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

using grid::kTileSize;
using Lanes = lanes::stdx::native_simd<float>;
constexpr int kLanes = static_cast<int>(Lanes::size());

Lanes load(const float* values) {
    return Lanes(values, lanes::stdx::element_aligned);
}
void store(float* values, Lanes lanes) {
    lanes.copy_to(values, lanes::stdx::element_aligned);
}

/// Calls body(x) for groups of kLanes neighbouring cells that cover [first, last); the final group is
/// moved back to end at `last`, so that nothing beyond is touched.
template <class Body>
[[gnu::always_inline]] inline void for_each_lane_group(int first, int last, const Body& body) {
    int x = first;
    for (; x + kLanes <= last; x += kLanes)
        body(x);
    if (x < last) body(last - kLanes);
}

/// |n_x| and |n_y| of the outline's normal by a 3 x 3 Sobel filter of the thickness: the contact angle
/// then acts alike in every direction.
void outline_normals(const HaloBlock& block, int y, TileScratch& scratch) {
    const float* h = block.thickness.data();
    for_each_lane_group(-2, kTileSize + 2, [&](int x) {
        const int i = block_index(x, y);
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
        if (step.has_contact_angle()) {
            const auto wet_left = h_left > wet, wet_right = h_right > wet;
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

/// kappa = -div(slope) and Pi = g eta + (sigma/rho) kappa.
void surface_pressure(const StepConstants& step, int y, TileScratch& scratch) {
    for_each_lane_group(-1, kTileSize + 1, [&](int x) {
        const int i = block_index(x, y);
        const Lanes divergence = (load(&scratch.slope_x[i]) - load(&scratch.slope_x[i - 1])) +
                                 (load(&scratch.slope_y[i]) - load(&scratch.slope_y[i - kBlockStride]));
        const Lanes curvature = -divergence * Lanes(step.inverse_cell);
        store(&scratch.curvature[i], curvature);
        store(&scratch.pressure[i],
              Lanes(step.gravity_mm_s2) * load(&scratch.block.eta[i]) + Lanes(step.tension) * curvature);
    });
}

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

constexpr int larger(int a, int b) {
    return a > b ? a : b;
}
constexpr int smaller(int a, int b) {
    return a < b ? a : b;
}

/// Slopes, curvature and pressure in all rows that a flow through a wet row can look at.
template <bool kFullCurvature>
void prepare_pressure(const StepConstants& step, TileScratch& scratch) {
    const int first = larger(scratch.block.first_wet_row - 1, -1);
    const int last = smaller(scratch.block.last_wet_row + 1, kTileSize);
    if (step.has_contact_angle())
        for (int y = first - 1; y <= last + 1; ++y)
            outline_normals(scratch.block, y, scratch);
    for (int y = first; y <= last; ++y)
        face_slopes<kFullCurvature>(scratch, step, y, 1, kBlockStride, scratch.normal_x.data(),
                                    scratch.slope_x.data());
    for (int y = first - 1; y <= last; ++y)
        face_slopes<kFullCurvature>(scratch, step, y, kBlockStride, 1, scratch.normal_y.data(),
                                    scratch.slope_y.data());
    for (int y = first; y <= last; ++y)
        surface_pressure(step, y, scratch);
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
using Quad = lanes::stdx::resize_simd_t<4, Lanes>;
using IntQuad = lanes::stdx::rebind_simd_t<std::int32_t, Quad>;
constexpr int kQuads = pigment::kChannels / 4;
static_assert(kQuads * 4 == pigment::kChannels);

struct ChannelInts {
    std::array<IntQuad, kQuads> quads;

    [[gnu::always_inline]] static ChannelInts load(const PigmentCell& cell) {
        ChannelInts result;
        for (int q = 0; q < kQuads; ++q)
            result.quads[q] = IntQuad(cell.data() + 4 * q, lanes::stdx::element_aligned);
        return result;
    }
    [[gnu::always_inline]] void store(PigmentCell& cell) const {
        for (int q = 0; q < kQuads; ++q)
            quads[q].copy_to(cell.data() + 4 * q, lanes::stdx::element_aligned);
    }
    [[gnu::always_inline]] ChannelInts operator-() const {
        ChannelInts result;
        for (int q = 0; q < kQuads; ++q)
            result.quads[q] = -quads[q];
        return result;
    }
};

[[gnu::always_inline]] inline Quad load_quad(const float* values) {
    return Quad(values, lanes::stdx::element_aligned);
}

/// The slope of the concentration at the donor cell: the smaller of both sides' where they agree in
/// sign.
[[gnu::always_inline]] inline Quad minmod(Quad a, Quad b) {
    const Quad smaller = lanes::min(lanes::abs(a), lanes::abs(b));
    return lanes::select(a * b > Quad(0.0F), lanes::copysign(smaller, a), Quad(0.0F));
}

/// Thinner than this (0.03 um), a concentration says nothing.
constexpr std::int32_t kTraceQuanta = 1 << 10;

/// Reads the fluxes and concentrations of a tile and says what pigment passes a face.
struct PigmentFluxes {
    const TileScratch& scratch;
    const float* concentrations;

    /// The signed pigment that `flux` thickness quanta take with them from the cell before the face to
    /// the one behind it. `block_step` and `concentration_step` lead from one to the other. With the
    /// flux at most a quarter of its cell and |slope| <= concentration, the four outflows f/4 (1 + (1 -
    /// f)/2), f = 4 flux / cell, never exceed what the cell holds.
    [[gnu::always_inline]] ChannelInts through(std::int32_t flux, int cell, int concentration,
                                               int block_step, int concentration_step) const {
        if (flux == 0) return {};
        const bool forward = flux > 0;
        const int downwind_step = forward ? block_step : -block_step;
        const int to_downwind = forward ? concentration_step : -concentration_step;
        const std::int32_t* quanta = &scratch.block.quanta[forward ? cell : cell + block_step];
        const float* donor =
            concentrations + (forward ? concentration : concentration + concentration_step);
        const float amount = static_cast<float>(forward ? flux : -flux);
        const bool smooth =
            quanta[downwind_step] > kTraceQuanta && quanta[-downwind_step] > kTraceQuanta;
        const float reach = smooth ? 0.5F - 2.0F * amount / static_cast<float>(*quanta) : 0.0F;
        ChannelInts carried;
        for (int q = 0; q < kQuads; ++q) {
            const Quad here = load_quad(donor + 4 * q);
            const Quad slope = minmod(here - load_quad(donor + 4 * q - to_downwind),
                                      load_quad(donor + 4 * q + to_downwind) - here);
            const Quad exact = Quad(amount) * (here + Quad(reach) * slope) + Quad(0.5F);
            const IntQuad rounded = lanes::stdx::static_simd_cast<IntQuad>(exact);
            carried.quads[q] = forward ? rounded : -rounded;
        }
        return carried;
    }
    [[gnu::always_inline]] ChannelInts through_x(int x, int y) const {
        return through(scratch.flux_x[face_index(x, y)], block_index(x, y), concentration_index(x, y), 1,
                       pigment::kChannels);
    }
    [[gnu::always_inline]] ChannelInts through_y(int x, int y) const {
        return through(scratch.flux_y[face_index(x, y)], block_index(x, y), concentration_index(x, y),
                       kBlockStride, pigment::kChannels * kConcentrationSide);
    }
};

void add_runoff(const ChannelInts& outward, PigmentTotals& totals) {
    for (int k = 0; k < pigment::kChannels; ++k)
        totals[k] += outward.quads[k / 4][k % 4];
}

}  // namespace

FlowExtremes tile_flow(const StepConstants& step, int columns, int rows, const ClosedEdges& closed,
                       TileScratch& scratch) {
    if (scratch.block.last_wet_row >= scratch.block.first_wet_row) {
        if (step.full_curvature)
            prepare_pressure<true>(step, scratch);
        else
            prepare_pressure<false>(step, scratch);
    }
    FlowExtremes extremes = flow_faces(step, scratch);
    shut_edges(columns, rows, closed, scratch);
    if (extremes.speed_mm_s >= 0.5F * step.cell_mm / step.dt_s)
        extremes.clamped_faces = count_clamped(step, scratch.velocity_x, -1, 0) +
                                 count_clamped(step, scratch.velocity_y, 0, -1);
    return extremes;
}

PigmentTotals transport_pigment(const TileScratch& scratch, const float* concentrations, int columns,
                                int rows, const OpenEdges& runoff_edges, const PigmentCell* before,
                                PigmentCell* after) {
    const PigmentFluxes fluxes{scratch, concentrations};
    PigmentTotals runoff{};
    std::array<PigmentCell, kTileSize> from_above;
    for (int x = 0; x < columns; ++x) {
        const ChannelInts top = fluxes.through_y(x, -1);
        if (runoff_edges.top) add_runoff(-top, runoff);
        top.store(from_above[x]);
    }
    for (int y = 0; y < rows; ++y) {
        ChannelInts left = fluxes.through_x(-1, y);
        if (runoff_edges.left) add_runoff(-left, runoff);
        for (int x = 0; x < columns; ++x) {
            const int cell = y * kTileSize + x;
            const ChannelInts right = fluxes.through_x(x, y);
            const ChannelInts below = fluxes.through_y(x, y);
            const ChannelInts above = ChannelInts::load(from_above[x]);
            ChannelInts now = ChannelInts::load(before[cell]);
            for (int q = 0; q < kQuads; ++q)
                now.quads[q] += (left.quads[q] - right.quads[q]) + (above.quads[q] - below.quads[q]);
            now.store(after[cell]);
            below.store(from_above[x]);
            left = right;
            if (runoff_edges.bottom && y == rows - 1) add_runoff(below, runoff);
        }
        if (runoff_edges.right) add_runoff(left, runoff);
    }
    return runoff;
}

void concentrate(const PigmentCell* pigment, const std::int32_t* thickness, int count, float* out) {
    // Two quanta and one part in a million stay behind: the four roundings of a cell's outflows and the
    // rounding of the product then never take more than it holds.
    constexpr float kShare = 1.0F - 0x1p-20F;
    for (int cell = 0; cell < count; ++cell) {
        const float inverse = thickness[cell] > 0 ? kShare / static_cast<float>(thickness[cell]) : 0.0F;
        const ChannelInts held = ChannelInts::load(pigment[cell]);
        for (int q = 0; q < kQuads; ++q) {
            const IntQuad movable = lanes::stdx::max(IntQuad(held.quads[q] - IntQuad(2)), IntQuad(0));
            const Quad concentration = lanes::stdx::static_simd_cast<Quad>(movable) * Quad(inverse);
            concentration.copy_to(out + cell * pigment::kChannels + 4 * q, lanes::stdx::element_aligned);
        }
    }
}

}  // namespace pastoso::film::PASTOSO_ISA
