// Compiled once per instruction set; see pastoso_add_kernels.
#include "film/drag_answer.hpp"
#include "film/face_loading.hpp"
#include "film/large_kernels.hpp"
#include "film/tile_kernels.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

using grid::kTileSize;

/// The momentum that arrives at a face, as a convex average of the old velocities around it: upwind
/// advection taken implicitly in the face's own velocity, then lateral viscosity likewise. No step is
/// too long for it.
[[gnu::always_inline]] inline Lanes carried_velocity(const FaceNeighbourhood<Lanes>& face,
                                                     Lanes viscosity, const StepConstants& step) {
    const Lanes zero(0.0F), one(1.0F);
    const Lanes courant(step.inertia * step.dt_s * step.inverse_cell);
    const Lanes forward = lanes::max(face.u, zero), backward = lanes::max(Lanes(-face.u), zero);
    const Lanes down = lanes::max(face.v, zero), up = lanes::max(Lanes(-face.v), zero);
    const Lanes arriving =
        forward * face.u_back + backward * face.u_front + down * face.u_before + up * face.u_after;
    const Lanes exchange =
        viscosity * Lanes(step.lateral * step.dt_s * step.inverse_cell * step.inverse_cell);
    const Lanes around = face.u_back + face.u_front + (face.u_before + face.u_after);
    const Lanes passing = one + courant * (lanes::abs(face.u) + lanes::abs(face.v));
    return (face.u + courant * arriving + passing * exchange * around) /
           (passing * (one + Lanes(4.0F) * exchange));
}

/// Bends a velocity smoothly towards one cell a step: w / (1 + (w dt/dx)^8)^(1/8). What is not bent by a
/// bit is left alone.
[[gnu::always_inline]] inline Lanes saturated(Lanes velocity, const StepConstants& step) {
    const Lanes courant = velocity * Lanes(step.dt_s * step.inverse_cell);
    const Lanes two = courant * courant, four = two * two;
    if (lanes::all(four < Lanes(1e-4F))) return velocity;
    return velocity / lanes::sqrt(lanes::sqrt(lanes::sqrt(Lanes(Lanes(1.0F) + four * four))));
}

/// At a film's edge: velocities that would carry more than an eighth of a cell a step are bent towards a
/// quarter.
[[gnu::always_inline]] inline Lanes softly_limited(Lanes velocity, const StepConstants& step) {
    constexpr float kFree = 0.125F;
    const Lanes courant =
        lanes::max(Lanes(lanes::abs(velocity) * Lanes(step.dt_s * step.inverse_cell)), Lanes(kFree));
    return velocity * Lanes(kFree) * (Lanes(2.0F) - Lanes(kFree) / courant) / courant;
}

/// What drives the paint through a face, and what resists it.
struct LargeDrive {
    Lanes driven;      ///< velocity but for drag and pressure, mm/s
    Lanes unresisted;  ///< with the lagged pressure
    Lanes across;      ///< the same along the face; 0 without a yield stress
    Lanes drag;        ///< lambda dt
    Lanes resistance;  ///< wall stress in yield stresses per velocity, s/mm; 0 without a yield stress
    Lanes drag_depth;  ///< of the film that drags, mm
    Lanes depth;       ///< of the film that passes
};

/// Where the film's edge is held by a contact angle.
struct LargeEdge {
    lanes::stdx::native_simd<float>::mask_type inner;  ///< faces that flow like any other
    Lanes depth;                                       ///< of what passes at those that do not
    Lanes drag_depth;
    Lanes acceleration;
};

/// Without a contact angle nothing holds the film's edge: it is a face like any other.
[[gnu::always_inline]] inline LargeEdge large_edge(const FaceNeighbourhood<Lanes>& face,
                                                   const StepConstants& step, Lanes force) {
    const Lanes zero(0.0F), wet_mm(step.wet_mm);
    const auto wet_left = face.h_left > wet_mm, wet_right = face.h_right > wet_mm;
    const auto wet = wet_left || wet_right;
    const auto inner = step.has_contact_angle() ? wet_left && wet_right : wet;
    if (lanes::all(inner)) return {inner, zero, zero, zero};
    const ContactFace<Lanes> edge = contact_face(face, step, force);
    const Lanes passing = lanes::max(Lanes(edge.h_wet - edge.pinned_mm), zero);
    return {inner, lanes::select(wet && !inner, passing, zero), edge.h_wet, edge.acceleration};
}

/// A film that the body force alone would carry more than a fifth of a cell a step runs slower than
/// real: the share of that force that it feels.
[[gnu::always_inline]] inline Lanes followed_force(Lanes drag_rate, const StepConstants& step,
                                                   const Axis& axis) {
    const float force_norm =
        lanes::sqrt(axis.force * axis.force + axis.force_across * axis.force_across) + 1e-30F;
    return lanes::min(Lanes(1.0F),
                      Lanes(Lanes(0.2F * step.cell_mm / (step.dt_s * force_norm)) * drag_rate));
}

/// `along` is the flow that shear-thinning paint is thinned by.
template <FaceModel kModel>
[[gnu::always_inline]] inline LargeDrive large_drive(const FaceNeighbourhood<Lanes>& face,
                                                     const LargeEdge& edge, Lanes lag_gradient,
                                                     Lanes along, const StepConstants& step,
                                                     const Axis& axis) {
    const Lanes zero(0.0F), dt(step.dt_s), force(axis.force);
    const auto paint = face_paint<kModel>(face, step);
    Lanes push = force;
    if constexpr (kModel.horizontal_tension) push = push + horizontal_tension(face, step);
    const Lanes carried = saturated(carried_velocity(face, paint.viscosity(step), step), step);
    const Lanes guess = carried + dt * (push - lag_gradient);
    const auto donor_wet = lanes::select(guess > zero, face.h_left, face.h_right) > Lanes(step.wet_mm);

    LargeDrive drive;
    drive.depth = lanes::select(donor_wet && guess != zero, upwind_thickness(face, guess), zero);
    drive.drag_depth = lanes::select(edge.inner, drive.depth, edge.drag_depth);
    Lanes coefficient(step.drag_along);
    if constexpr (kModel.alpha_range) coefficient = alpha_drag(face, step);
    if constexpr (kModel.shear_thinning) {
        const Lanes speed = lanes::sqrt(Lanes(along * along + face.v * face.v));
        coefficient = coefficient * relative_viscosity<kModel.yield>(speed, drive.drag_depth,
                                                                     paint.against_yield(step), step);
    }
    const DragRate<Lanes> lambda =
        drag_rate(coefficient, drive.drag_depth, paint.viscosity(step), paint.fluidity(step), step);
    drive.drag = lanes::min(Lanes(lambda.rate * dt), Lanes(1e12F));
    drive.driven = carried + dt * (push - force + force * followed_force(lambda.rate, step, axis));
    drive.unresisted = lanes::select(edge.inner, Lanes(drive.driven - dt * lag_gradient),
                                     Lanes(carried + dt * edge.acceleration));
    drive.across = drive.resistance = zero;
    if constexpr (kModel.yield) {
        drive.across =
            face.v + dt * (Lanes(axis.force_across) - Lanes(step.gravity_mm_s2) * face.eta_slope_across);
        drive.resistance = paint.over_yield_in_step(Lanes(drive.drag * drive.drag_depth), step);
    }
    return drive;
}

/// Assembles the faces of a row: u = u* - D dt grad p with u* = F - F' (w - driven) and D = F' for the
/// flow F that drag leaves of the velocity w at the lagged pressure; the mobility is dt^2 D h / dx^2. A
/// face at an edge that a contact angle holds is explicit. `again` says that the lagged pressure is that
/// of this step's last solution, and the faces' velocities too: shear-thinning paint is then thinned by
/// that flow. Returns by what part a flux of that solution was wrong.
template <FaceModel kModel>
float face_row(const TileScratch& scratch, const float* lag, bool again, const StepConstants& step,
               const Axis& axis, int first_x, int y, LargeFaces& faces) {
    const Lanes zero(0.0F), per_pressure(step.dt_s * step.dt_s * step.inverse_cell * step.inverse_cell);
    Lanes error(0.0F);
    for_each_lane_group(first_x, kTileSize, [&](int x) {
        const int i = block_index(x, y), f = face_index(x, y);
        const FaceNeighbourhood<Lanes> face = neighbourhood<kModel>(scratch, step, axis, AlongRow{}, i);
        const Lanes lag_gradient =
            (load(lag + i + axis.along) - load(lag + i)) * Lanes(step.inverse_cell);
        const Lanes along = again ? load(&faces.velocity[f]) : face.u;
        const LargeEdge edge = large_edge(face, step, Lanes(axis.force));
        const LargeDrive drive = large_drive<kModel>(face, edge, lag_gradient, along, step, axis);
        const DragAnswer answer =
            drag_answer<kModel.yield>(drive.unresisted, drive.across, drive.drag, drive.resistance);
        const Lanes star = answer.flow - answer.slope * (drive.unresisted - drive.driven);
        const Lanes at_edge = lanes::select(edge.depth > zero, softly_limited(answer.flow, step), zero);
        if (again)
            error = lanes::max(
                error,
                lanes::select(edge.inner, flux_error(answer.flow, along, drive.depth, step), zero));
        store(&faces.old[f], face.u);
        store(&faces.driven[f], drive.driven);
        store(&faces.across[f], drive.across);
        store(&faces.drag[f], drive.drag);
        store(&faces.resistance[f], lanes::select(edge.inner, drive.resistance, zero));
        store(&faces.depth[f], lanes::select(edge.inner, drive.depth, edge.depth));
        store(&faces.star[f], lanes::select(edge.inner, star, at_edge));
        store(&faces.mobility[f],
              lanes::select(edge.inner, Lanes(per_pressure * answer.slope * drive.depth), zero));
    });
    return lanes::stdx::hmax(error);
}

void clear_row(FaceArray<float>& values, int y) {
    for (int x = -1; x < kTileSize; ++x)
        values[face_index(x, y)] = 0.0F;
}

/// How much of a height difference the surface tension feels at a face: 1 in a film of small slopes,
/// less where it is steep, and at the film's edge the derivative of the contact slope.
template <bool kFullCurvature>
void weight_row(const TileScratch& scratch, const StepConstants& step, int first_x, int y, int axis,
                int across, const float* normal_along, FaceArray<float>& weight) {
    const HaloBlock& block = scratch.block;
    const float* h = block.thickness.data();
    const float* eta = block.eta.data();
    const Lanes one(1.0F), zero(0.0F), wet(step.wet_mm), steep(2.0F * step.inverse_cell);
    const auto edge_weight = [&](int i) {
        const Lanes sum = load(&scratch.normal_x[i]) + load(&scratch.normal_y[i]);
        const Lanes slope = steep * load(h + i);
        const auto follows =
            (slope < Lanes(step.tan_advancing) * sum) && (slope > Lanes(step.tan_receding) * sum);
        return lanes::select(follows, Lanes(Lanes(2.0F) * load(normal_along + i) / (sum + Lanes(1e-9F))),
                             zero);
    };
    for_each_lane_group(first_x, kTileSize, [&](int x) {
        const int left = block_index(x, y), right = left + axis;
        Lanes inner = one;
        if constexpr (kFullCurvature) {
            const Lanes slope = (load(eta + right) - load(eta + left)) * Lanes(step.inverse_cell);
            const Lanes slope_across = Lanes(0.25F * step.inverse_cell) *
                                       ((load(eta + left + across) - load(eta + left - across)) +
                                        (load(eta + right + across) - load(eta + right - across)));
            inner = one / lanes::sqrt(Lanes(one + slope * slope + slope_across * slope_across));
        }
        Lanes result = inner;
        if (step.has_contact_angle()) {
            const auto wet_left = load(h + left) > wet, wet_right = load(h + right) > wet;
            const Lanes edge = lanes::select(wet_left, edge_weight(left),
                                             lanes::select(wet_right, edge_weight(right), zero));
            result = lanes::select(wet_left && wet_right, inner, edge);
        }
        store(&weight[face_index(x, y)], result);
    });
}

template <FaceModel kModel>
float assemble_faces(const StepConstants& step, const float* lag, bool again, TileScratch& scratch,
                     LargeTile& tile) {
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
    const auto weights = step.full_curvature ? weight_row<true> : weight_row<false>;
    const auto clear = [](LargeFaces& faces, int y) {
        for (auto* values : {&faces.old, &faces.driven, &faces.across, &faces.drag, &faces.resistance,
                             &faces.depth, &faces.star, &faces.mobility, &faces.weight})
            clear_row(*values, y);
    };
    const int first = block.first_wet_row, last = block.last_wet_row;
    float error = 0.0F;
    for (int y = -1; y < kTileSize; ++y) {
        if (y >= first - 1 && y <= last) {
            error = lanes::max(error, face_row<kModel>(scratch, lag, again, step, y_axis, 0, y, tile.y));
            weights(scratch, step, 0, y, kBlockStride, 1, scratch.normal_y.data(), tile.y.weight);
        } else {
            clear(tile.y, y);
        }
        if (y >= first && y <= last && y >= 0) {
            error =
                lanes::max(error, face_row<kModel>(scratch, lag, again, step, x_axis, -1, y, tile.x));
            weights(scratch, step, -1, y, 1, kBlockStride, scratch.normal_x.data(), tile.x.weight);
        } else {
            clear(tile.x, y);
        }
    }
    return error;
}

void shut(LargeFaces& faces, int f) {
    faces.resistance[f] = faces.depth[f] = faces.star[f] = faces.mobility[f] = 0.0F;
}

/// Nothing flows through a face at a closed edge or beyond the canvas.
void shut_edges(int columns, int rows, const ClosedEdges& closed, LargeTile& tile) {
    for_each_shut_face(
        columns, rows, closed, [&](int f) { shut(tile.x, f); }, [&](int f) { shut(tile.y, f); });
}

/// A wall mirrors the surface and beyond an open edge nothing answers: no response across the canvas'
/// edges.
void cut_response(int columns, int rows, const CanvasEdges& edges, LargeTile& tile) {
    for (int y = 0; y < kTileSize; ++y) {
        if (edges.left) tile.x.weight[face_index(-1, y)] = 0.0F;
        if (edges.right) tile.x.weight[face_index(columns - 1, y)] = 0.0F;
    }
    for (int x = 0; x < kTileSize; ++x) {
        if (edges.top) tile.y.weight[face_index(x, -1)] = 0.0F;
        if (edges.bottom) tile.y.weight[face_index(x, rows - 1)] = 0.0F;
    }
}

}  // namespace

/// f = -(dt/dx) div(h_f u*)
void find_source(const StepConstants& step, LargeTile& tile) {
    const Lanes courant(step.dt_s * step.inverse_cell);
    const auto flow = [](const LargeFaces& faces, int f) {
        return load(&faces.star[f]) * load(&faces.depth[f]);
    };
    for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x < kTileSize; x += kLanes) {
            const int f = face_index(x, y);
            const Lanes outflow = (flow(tile.x, f) - flow(tile.x, f - 1)) +
                                  (flow(tile.y, f) - flow(tile.y, f - kFaceStride));
            store(&tile.source[y * kTileSize + x], -courant * outflow);
        }
}

float assemble_large_tile(const StepConstants& step, int columns, int rows, const ClosedEdges& closed,
                          const CanvasEdges& edges, bool again, LargeScratch& large,
                          TileScratch& scratch, LargeTile& tile) {
    const HaloBlock& block = scratch.block;
    const bool wet = block.last_wet_row >= block.first_wet_row;
    if (wet) prepare_pressure(step, scratch);
    BlockArray<float>& lag = large.lagged_pressure;
    const auto is_defined = [&](int y) {
        return wet && y >= block.first_wet_row - 1 && y <= block.last_wet_row + 1;
    };
    for (int y = -1; y <= kTileSize; ++y)
        for_each_lane_group(-1, kTileSize + 1, [&, defined = is_defined(y)](int x) {
            const int i = block_index(x, y);
            const Lanes last = load(&lag[i]);
            const Lanes rest = defined ? load(&scratch.pressure[i]) : Lanes(0.0F);
            store(&lag[i], lanes::select(last != Lanes(0.0F), last, rest));
        });
    const float error = with_face_model(step, [&]<FaceModel kModel>() {
        return assemble_faces<kModel>(step, lag.data(), again, scratch, tile);
    });
    shut_edges(columns, rows, closed, tile);
    cut_response(columns, rows, edges, tile);
    find_source(step, tile);
    if (again) return error;
    const float lowest_mm = step.has_contact_angle() ? step.wet_mm : -1.0F;
    for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x < kTileSize; x += kLanes) {
            const int i = block_index(x, y), cell = y * kTileSize + x;
            const auto flows = load(&block.thickness[i]) > Lanes(lowest_mm);
            const Lanes rest = is_defined(y) ? load(&scratch.pressure[i]) : Lanes(0.0F);
            store(&tile.rest_pressure[cell], lanes::select(flows, rest, Lanes(0.0F)));
            store(&tile.pressure[cell], lanes::select(flows, load(&lag[i]), Lanes(0.0F)));
        }
    return error;
}

}  // namespace pastoso::film::PASTOSO_ISA
