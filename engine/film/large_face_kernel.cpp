// Compiled once per instruction set; see pastoso_add_kernels.
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
    const Lanes advected =
        (face.u + courant * arriving) / (one + courant * (lanes::abs(face.u) + lanes::abs(face.v)));
    const Lanes exchange =
        viscosity * Lanes(step.lateral * step.dt_s * step.inverse_cell * step.inverse_cell);
    const Lanes around = face.u_back + face.u_front + (face.u_before + face.u_after);
    return (advected + exchange * around) / (one + Lanes(4.0F) * exchange);
}

/// Bends a velocity smoothly towards one cell a step: w / (1 + (w dt/dx)^8)^(1/8).
[[gnu::always_inline]] inline Lanes saturated(Lanes velocity, const StepConstants& step) {
    const Lanes courant = velocity * Lanes(step.dt_s * step.inverse_cell);
    const Lanes two = courant * courant, four = two * two;
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

/// The drag factor that makes a given flow its own answer. With the stress t = drag |u| / y that the
/// velocity u stands for (y = dt tau_y / (rho h)), the wall shear x of the film law solves x - 3/2 +
/// 1/(2 x^2) = t, and the factor is t / (t + drag x). Fixing the factor of the last solution lowers the
/// exact dissipation with every pass, where fixing that of the last pressure would swing between flowing
/// and arrested.
[[gnu::always_inline]] inline Lanes factor_of_flow(Lanes drag, Lanes stress) {
    const Lanes one(1.0F), half(0.5F);
    Lanes x = one + stress + lanes::sqrt(Lanes(stress * Lanes(2.0F / 3.0F)));
    for (int iteration = 0; iteration < 4; ++iteration) {
        const Lanes inverse = one / x;
        const Lanes residual = x - Lanes(1.5F) + half * inverse * inverse - stress;
        const Lanes derivative = one - inverse * inverse * inverse;
        x = lanes::max(Lanes(x - residual / (derivative + Lanes(1e-12F))), one);
    }
    return stress / (stress + drag * x);
}

struct LargeFace {
    Lanes star, depth, mobility;
};

/// A face that flows freely gets the velocity but for the new pressure, u* = D (w + dt F), and the
/// mobility dt^2 D h_f / dx^2 of u = u* - D dt grad p, where D is the drag factor at the pressure
/// gradient of the last step; or, where `flowing` gives the velocity found so far, the factor that
/// belongs to it. A face at an edge that a contact angle holds is explicit.
template <FaceModel kModel>
[[gnu::always_inline]] inline LargeFace large_face(const FaceNeighbourhood<Lanes>& face,
                                                   Lanes lag_gradient, const Lanes* flowing,
                                                   const StepConstants& step, const Axis& axis) {
    const Lanes zero(0.0F), one(1.0F);
    const Lanes dt(step.dt_s), wet_mm(step.wet_mm), force(axis.force);
    const auto wet_left = face.h_left > wet_mm, wet_right = face.h_right > wet_mm;
    // Without a contact angle nothing holds the film's edge: it is a face like any other.
    const auto inner = step.has_contact_angle() ? wet_left && wet_right : wet_left || wet_right;
    const auto at_edge = (wet_left || wet_right) && !inner;

    const ContactFace<Lanes> edge = contact_face(face, step, force);
    const auto paint = face_paint<kModel>(face, step);
    Lanes push = force;
    if constexpr (kModel.horizontal_tension) push = push + horizontal_tension(face, step);
    const Lanes carried = saturated(carried_velocity(face, paint.viscosity(step), step), step);
    const Lanes guess = carried + dt * (push - lag_gradient);
    const auto donor_wet = (guess > zero && wet_left) || (guess < zero && wet_right);
    const Lanes inner_depth = lanes::select(donor_wet, upwind_thickness(face, guess), zero);
    const Lanes drag_depth = lanes::select(inner, inner_depth, edge.h_wet);
    const Lanes edge_depth =
        lanes::select(at_edge, lanes::max(Lanes(edge.h_wet - edge.pinned_mm), zero), zero);

    Lanes coefficient(step.drag_along);
    if constexpr (kModel.alpha_range) coefficient = alpha_drag(face, step);
    if constexpr (kModel.shear_thinning) {
        const Lanes along = flowing != nullptr ? *flowing : face.u;
        const Lanes speed = lanes::sqrt(Lanes(along * along + face.v * face.v));
        coefficient = coefficient * relative_viscosity<kModel.yield>(speed, drag_depth,
                                                                     paint.against_yield(step), step);
    }
    const DragRate<Lanes> lambda =
        drag_rate(coefficient, drag_depth, paint.viscosity(step), paint.fluidity(step), step);
    const Lanes drag = lanes::min(Lanes(lambda.rate * dt), Lanes(1e12F));

    // A film that the body force alone would carry more than a fifth of a cell a step runs slower than
    // real.
    const float force_norm =
        lanes::sqrt(axis.force * axis.force + axis.force_across * axis.force_across) + 1e-30F;
    const Lanes followed =
        lanes::min(one, Lanes(Lanes(0.2F * step.cell_mm / (step.dt_s * force_norm)) * lambda.rate));
    const Lanes driven = carried + dt * (push - force + force * followed);
    const Lanes unresisted =
        lanes::select(inner, Lanes(driven - dt * lag_gradient), Lanes(carried + dt * edge.acceleration));
    Lanes factor = one / (one + drag);
    if constexpr (kModel.yield) {
        const Lanes across =
            face.v + dt * (Lanes(axis.force_across) - Lanes(step.gravity_mm_s2) * face.eta_slope_across);
        factor = bingham_drag(drag, stopping_stress(drag, drag_depth, unresisted, across, paint, step))
                     .factor;
        if (flowing != nullptr) {
            const Lanes speed =
                lanes::sqrt(Lanes(unresisted * unresisted + across * across)) + Lanes(1e-30F);
            const Lanes share = lanes::max(Lanes(lanes::abs(unresisted) / speed), Lanes(0.1F));
            const Lanes stress =
                stopping_stress(drag, drag_depth, Lanes(*flowing / share), zero, paint, step);
            factor = lanes::select(inner && *flowing != zero, factor_of_flow(drag, stress), factor);
        }
    }

    LargeFace result;
    result.depth = lanes::select(inner, inner_depth, edge_depth);
    result.star = lanes::select(
        inner, Lanes(factor * driven),
        lanes::select(edge_depth > zero, softly_limited(Lanes(factor * unresisted), step), zero));
    const Lanes per_pressure(step.dt_s * step.dt_s * step.inverse_cell * step.inverse_cell);
    result.mobility = lanes::select(inner, Lanes(per_pressure * factor * inner_depth), zero);
    return result;
}

/// The arrays of one direction of faces.
struct LargeFaces {
    FaceArray<float>&star, &depth, &mobility, &weight, &old, &velocity;
};

/// Assembles the faces of a row; `refine` takes the drag of yielding faces from `velocity`, the solution
/// so far. Returns by what part a face's flux is about to change through that, fluxes of less than 1/50
/// cell a step counting as that much.
template <FaceModel kModel>
float face_row(const TileScratch& scratch, const float* lag, bool refine, const StepConstants& step,
               const Axis& axis, int first_x, int y, const LargeFaces& faces) {
    constexpr float kTraceFlux = 0.02F;
    const float per_cell = step.dt_s * step.inverse_cell * step.inverse_cell;
    Lanes change(0.0F);
    for_each_lane_group(first_x, kTileSize, [&](int x) {
        const int i = block_index(x, y), f = face_index(x, y);
        const FaceNeighbourhood<Lanes> face = neighbourhood<kModel>(scratch, step, axis, AlongRow{}, i);
        const Lanes lag_gradient =
            (load(lag + i + axis.along) - load(lag + i)) * Lanes(step.inverse_cell);
        const Lanes flowing = refine ? load(&faces.velocity[f]) : Lanes(0.0F);
        const LargeFace result =
            large_face<kModel>(face, lag_gradient, refine ? &flowing : nullptr, step, axis);
        if (refine) {
            const Lanes before = load(&faces.mobility[f]);
            const Lanes ratio = lanes::abs(Lanes(result.mobility - before)) / (before + Lanes(1e-30F));
            const Lanes flux = lanes::abs(flowing) * result.depth * Lanes(per_cell);
            change = lanes::max(change, Lanes(flux * ratio / (flux + Lanes(kTraceFlux))));
        }
        store(&faces.old[f], face.u);
        store(&faces.star[f], result.star);
        store(&faces.depth[f], result.depth);
        store(&faces.mobility[f], result.mobility);
    });
    return lanes::stdx::hmax(change);
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
float assemble_faces(const StepConstants& step, const float* lag, bool refine, TileScratch& scratch,
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
    const LargeFaces x_faces{tile.star_x,   tile.depth_x, tile.mobility_x,
                             tile.weight_x, tile.old_x,   tile.velocity_x};
    const LargeFaces y_faces{tile.star_y,   tile.depth_y, tile.mobility_y,
                             tile.weight_y, tile.old_y,   tile.velocity_y};
    const auto weights = step.full_curvature ? weight_row<true> : weight_row<false>;
    const auto clear = [](const LargeFaces& faces, int y) {
        for (auto* values : {&faces.star, &faces.depth, &faces.mobility, &faces.weight, &faces.old})
            clear_row(*values, y);
    };
    const int first = block.first_wet_row, last = block.last_wet_row;
    float change = 0.0F;
    for (int y = -1; y < kTileSize; ++y) {
        if (y >= first - 1 && y <= last) {
            change =
                lanes::max(change, face_row<kModel>(scratch, lag, refine, step, y_axis, 0, y, y_faces));
            weights(scratch, step, 0, y, kBlockStride, 1, scratch.normal_y.data(), tile.weight_y);
        } else {
            clear(y_faces, y);
        }
        if (y >= first && y <= last && y >= 0) {
            change =
                lanes::max(change, face_row<kModel>(scratch, lag, refine, step, x_axis, -1, y, x_faces));
            weights(scratch, step, -1, y, 1, kBlockStride, scratch.normal_x.data(), tile.weight_x);
        } else {
            clear(x_faces, y);
        }
    }
    return change;
}

/// Nothing flows through a face at a closed edge or beyond the canvas.
void shut_edges(int columns, int rows, const ClosedEdges& closed, LargeTile& tile) {
    for_each_shut_face(
        columns, rows, closed,
        [&](int f) { tile.star_x[f] = tile.depth_x[f] = tile.mobility_x[f] = 0.0F; },
        [&](int f) { tile.star_y[f] = tile.depth_y[f] = tile.mobility_y[f] = 0.0F; });
}

/// A wall mirrors the surface and beyond an open edge nothing answers: no response across the canvas'
/// edges.
void cut_response(int columns, int rows, const CanvasEdges& edges, LargeTile& tile) {
    for (int y = 0; y < kTileSize; ++y) {
        if (edges.left) tile.weight_x[face_index(-1, y)] = 0.0F;
        if (edges.right) tile.weight_x[face_index(columns - 1, y)] = 0.0F;
    }
    for (int x = 0; x < kTileSize; ++x) {
        if (edges.top) tile.weight_y[face_index(x, -1)] = 0.0F;
        if (edges.bottom) tile.weight_y[face_index(x, rows - 1)] = 0.0F;
    }
}

}  // namespace

/// f = -(dt/dx) div(h_f u*)
void find_source(const StepConstants& step, LargeTile& tile) {
    const Lanes courant(step.dt_s * step.inverse_cell);
    const auto flow_x = [&](int f) { return load(&tile.star_x[f]) * load(&tile.depth_x[f]); };
    const auto flow_y = [&](int f) { return load(&tile.star_y[f]) * load(&tile.depth_y[f]); };
    for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x < kTileSize; x += kLanes) {
            const int f = face_index(x, y);
            const Lanes outflow = (flow_x(f) - flow_x(f - 1)) + (flow_y(f) - flow_y(f - kFaceStride));
            store(&tile.source[y * kTileSize + x], -courant * outflow);
        }
}

float assemble_large_tile(const StepConstants& step, int columns, int rows, const ClosedEdges& closed,
                          const CanvasEdges& edges, bool refine, LargeScratch& large,
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
    const float change = with_face_model(step, [&]<FaceModel kModel>() {
        return assemble_faces<kModel>(step, lag.data(), refine, scratch, tile);
    });
    shut_edges(columns, rows, closed, tile);
    cut_response(columns, rows, edges, tile);
    find_source(step, tile);
    if (refine) return change;
    const float lowest_mm = step.has_contact_angle() ? step.wet_mm : -1.0F;
    for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x < kTileSize; x += kLanes) {
            const int i = block_index(x, y), cell = y * kTileSize + x;
            const auto flows = load(&block.thickness[i]) > Lanes(lowest_mm);
            const Lanes rest = is_defined(y) ? load(&scratch.pressure[i]) : Lanes(0.0F);
            store(&tile.rest_pressure[cell], lanes::select(flows, rest, Lanes(0.0F)));
            store(&tile.pressure[cell], lanes::select(flows, load(&lag[i]), Lanes(0.0F)));
        }
    return change;
}

}  // namespace pastoso::film::PASTOSO_ISA
