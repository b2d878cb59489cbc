// Compiled once per instruction set; see pastoso_add_kernels.
#include "film/explicit/tile_kernels.hpp"
#include "film/face/face_loading.hpp"
#include "film/large/drag_answer.hpp"
#include "film/large/large_kernels.hpp"
#include "film/large/settling.hpp"

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

/// At a film's end: a velocity that carries no more through the face in a step than it may, nor further
/// than a cell.
template <FaceModel kModel>
[[gnu::always_inline]] inline Lanes limited_at_end(Lanes velocity, const FaceDrive<kModel, Lanes>& drive,
                                                   const StepConstants& step) {
    const Lanes cell_per_step(step.cell_mm / step.dt_s);
    const Lanes passing = lanes::max(drive.thickness, Lanes(1e-30F));
    const Lanes most = cell_per_step * lanes::min(Lanes(1.0F), Lanes(drive.most_mm / passing));
    return lanes::clamp(velocity, Lanes(-most), most);
}

/// How fast an end of the film draws back; next to nothing moves in one that fills little of its cell.
template <FaceModel kModel>
[[gnu::always_inline]] inline Lanes retreat(const FaceNeighbourhood<Lanes>& face, Lanes flow,
                                            const FaceDrive<kModel, Lanes>& drive,
                                            const StepConstants& step) {
    const Lanes zero(0.0F), one(1.0F), wedge_mm(0.5F * step.cell_mm);
    const Lanes receding = drive.paint.tan_receding(step) + Lanes(1e-6F);
    const auto draws_back = (ends_left(face) && flow > zero) || (ends_right(face) && flow < zero);
    const Lanes filling = lanes::min(one, Lanes(drive.thickness / (wedge_mm * receding)));
    return lanes::select(draws_back, Lanes(lanes::abs(flow) * filling), zero);
}

/// The drag of a face that is explicit: at a film's edge that a contact angle holds, or shut.
constexpr float kExplicit = -1.0F;

/// A film that the body force beyond its yield stress would carry more than a fifth of a cell a step
/// runs slower than real: the share of that force that it feels. `yield_speed` is the velocity whose
/// drag is the yield stress.
[[gnu::always_inline]] inline Lanes followed_force(Lanes drag_rate, Lanes yield_speed,
                                                   const StepConstants& step, const Axis& axis) {
    const float force_norm =
        lanes::sqrt(axis.force * axis.force + axis.force_across * axis.force_across) + 1e-30F;
    const Lanes speed = Lanes(0.2F * step.cell_mm / step.dt_s) + yield_speed;
    return lanes::min(Lanes(1.0F), Lanes(speed * drag_rate / Lanes(force_norm)));
}

/// Whether a group of faces has no paint on either side, so that a contact angle shuts them all.
[[gnu::always_inline]] inline bool is_dry(const HaloBlock& block, const StepConstants& step, int i,
                                          int along) {
    if (!step.has_contact_angle()) return false;
    const float* thickness = &block.thickness[i];
    return lanes::all(lanes::max(load(thickness), load(thickness + along)) <= Lanes(step.wet_mm));
}

/// Assembles a row of faces, a stage at a time: whole faces are chains of operations too long for the
/// processor to overlap.
template <FaceModel kModel>
struct LargeFaceRow {
    const TileScratch& scratch;
    const float* lag;  ///< pressure, that of the last step or of this one's last solution
    const StepConstants& step;
    const Axis& axis;
    int first_x, y;
    LargeFaces& faces;
    FaceArray<float>& carried;  ///< momentum that arrives, mm/s
    LargeTile& tile;            ///< what is found out about its motion before the step

    template <FacePlace kPlace>
    [[gnu::always_inline]] FaceNeighbourhood<Lanes> face_at(int x) const {
        return neighbourhood<kModel, kPlace>(scratch, step, axis, AlongRow{}, block_index(x, y));
    }

    bool is_shut(int x) const { return is_dry(scratch.block, step, block_index(x, y), axis.along); }

    /// At the old velocity, by the mean thickness.
    Lanes old_viscosity(const FaceNeighbourhood<Lanes>& face) const {
        const FacePaint<Lanes, kModel> paint = face_paint<kModel>(face, step);
        if constexpr (!kModel.shear_thinning) return paint.viscosity(step);
        const Lanes speed = lanes::sqrt(Lanes(face.u * face.u + face.v * face.v));
        const Lanes mean_mm = Lanes(0.5F) * (face.h_left + face.h_right);
        return paint.viscosity(step) * relative_viscosity<kModel.yield>(speed, mean_mm,
                                                                        paint.against_yield(step),
                                                                        paint.flow_index(step));
    }

    void carry() const {
        Lanes fastest(0.0F);
        for_each_lane_group(first_x, kTileSize, [&](int x) {
            if (is_shut(x)) return;
            const FaceNeighbourhood<Lanes> face = face_at<FacePlace::InFilm>(x);
            const Lanes viscosity = old_viscosity(face);
            store(&carried[face_index(x, y)], saturated(carried_velocity(face, viscosity, step), step));
            fastest = lanes::max(fastest, lanes::abs(face.u));
        });
        tile.fastest_mm_s = lanes::max(tile.fastest_mm_s, lanes::largest(fastest));
    }

    /// What drives each face and what resists it. `thinned` takes the flow that thins the paint from the
    /// faces' velocities.
    void drive(bool thinned) const {
        for_each_lane_group(first_x, kTileSize, [&](int x) {
            if (is_shut(x)) return shut_group(face_index(x, y));
            if (are_in_film<kModel>(scratch, step, axis, block_index(x, y)))
                drive_group<FacePlace::InFilm>(x, thinned);
            else
                drive_near_end(x, thinned);
        });
    }
    /// Not inlined: what it keeps in registers would slow down the faces in the middle of the film.
    [[gnu::noinline]] void drive_near_end(int x, bool thinned) const {
        drive_group<FacePlace::Anywhere>(x, thinned);
    }

    template <FacePlace kPlace>
    [[gnu::always_inline]] void drive_group(int x, bool thinned) const {
        const int f = face_index(x, y), i = block_index(x, y);
        const FaceNeighbourhood<Lanes> face = face_at<kPlace>(x);
        if (!thinned) store(&faces.first[f], face.u);
        const Lanes gradient = (load(lag + i + axis.along) - load(lag + i)) * Lanes(step.inverse_cell);
        const Lanes along = kModel.shear_thinning && thinned ? load(&faces.velocity[f]) : face.u;
        const auto shut = load(&faces.drag[f]) < Lanes(0.0F) && load(&faces.depth[f]) == Lanes(0.0F);
        if constexpr (kModel.shear_thinning) thin_by(face, along, f);
        // What pressure drives along the faces is in the answer to it.
        drive_faces<kPlace>(face, {load(&carried[f]), gradient, Lanes(0.0F), along}, x);
        // What is shut stays so when it is assembled again.
        if (thinned && lanes::any(shut)) put_explicit(shut, Lanes(0.0F), Lanes(0.0F), f);
    }

    /// The velocities that the paint is thinned by. Their whole counts, of which only the part along the
    /// axis is to be found.
    [[gnu::always_inline]] void thin_by(const FaceNeighbourhood<Lanes>& face, Lanes along, int f) const {
        const Lanes along2 = along * along, one(1.0F);
        const Lanes share = along2 / (along2 + face.v * face.v + Lanes(1e-30F));
        const Lanes flow_index = face_paint<kModel>(face, step).flow_index(step);
        store(&faces.velocity[f], along);
        store(&faces.index[f], one - (one - flow_index) * share);
    }

    PressureRow pressure() const {
        const int first = block_index(0, y);
        return {lag + first, &scratch.block.quanta[first], axis.along, axis.across};
    }

    /// Stores depth, drag and what drives a group of faces; where some are explicit, their flow as well.
    template <FacePlace kPlace>
    [[gnu::always_inline]] void drive_faces(const FaceNeighbourhood<Lanes>& face,
                                            const FaceStart<Lanes>& start, int x) const {
        const int f = face_index(x, y);
        const Lanes zero(0.0F), dt(step.dt_s), force(axis.force);
        constexpr FaceKind kKind{FaceScheme::Large, kPlace};
        const auto inside = inside_film<kKind>(face, step);
        FaceDrive<kModel, Lanes> drive;
        face_drive<kModel, kKind>(face, step, axis.force, axis.force_across, start, drive);
        const Lanes rate = drag_rate(drive, step).rate;
        const Lanes drag = lanes::min(Lanes(rate * dt), Lanes(1e12F));
        Lanes resistance(0.0F), yield_speed(0.0F);
        if constexpr (kModel.yield) {
            resistance = drive.paint.over_yield_in_step(Lanes(drag * drive.drag_thickness), step);
            yield_speed = Lanes(1.0F) / (resistance + Lanes(1e-30F));
            store(&faces.across[f], drive.across);
            store(&faces.resistance[f], resistance);
        }
        Lanes followed(0.0F);
        if constexpr (kModel.horizontal_tension) followed = horizontal_tension(face, step);
        if constexpr (kModel.media) followed = followed + tension_pull(face, drive.paint, step);
        followed = followed + force * followed_force(rate, yield_speed, step, axis);
        const Lanes momentum = settled(face, start.momentum, drive.thickness, inside, drag);
        store(&faces.driven[f], Lanes(momentum + dt * followed));
        store(&faces.drag[f], drag);
        store(&faces.depth[f], drive.thickness);
        if constexpr (kPlace == FacePlace::InFilm) return;
        if (lanes::all(inside)) return;

        Lanes across(0.0F);
        if constexpr (kModel.yield) across = pressure().drive_across(step, drive.across, x);
        const Lanes flow = drag_answer<kModel.yield>(drive.driven, across, drag, resistance).flow;
        const auto flows = drive.thickness > zero;
        const Lanes back = lanes::select(!inside && flows, retreat(face, flow, drive, step), zero);
        tile.fastest_retreat_mm_s = lanes::max(tile.fastest_retreat_mm_s, lanes::largest(back));
        put_explicit(!inside, drive.thickness,
                     lanes::select(flows, limited_at_end(flow, drive, step), zero), f);
    }

    /// The momentum of faces that remember it, where it moves paint of another depth than arrives.
    template <class Mask>
    [[gnu::always_inline]] Lanes settled(const FaceNeighbourhood<Lanes>& face, Lanes momentum,
                                         Lanes depth, Mask inside, Lanes drag) const {
        const auto remembers = inside && drag < Lanes(kInertialDrag);
        if (!lanes::any(remembers)) return momentum;
        tile.inertial = true;
        const Lanes mean = Lanes(0.5F) * (face.h_left + face.h_right);
        return lanes::select(remembers, momentum * settled_share<Lanes>(mean, depth), momentum);
    }

    void shut_group(int f) const {
        store(&faces.drag[f], Lanes(kExplicit));
        for (auto* values : {&faces.driven, &faces.across, &faces.resistance, &faces.depth, &faces.star,
                             &faces.mobility})
            store(&(*values)[f], Lanes(0.0F));
    }

    /// Faces that do not wait for the new pressure.
    template <class Mask>
    void put_explicit(Mask where, Lanes depth, Lanes flow, int f) const {
        const auto put = [&](FaceArray<float>& values, Lanes value) {
            store(&values[f], lanes::select(where, value, load(&values[f])));
        };
        put(faces.drag, Lanes(kExplicit));
        put(faces.depth, depth);
        put(faces.star, flow);
        put(faces.mobility, Lanes(0.0F));
    }

    float assemble(bool again) const {
        carry();
        drive(again);
        if (again)
            return answer_row<kModel.yield, true, kModel.shear_thinning>(step, pressure(), first_x, y,
                                                                         faces);
        answer_row<kModel.yield, false, kModel.shear_thinning>(step, pressure(), first_x, y, faces);
        if (step.has_contact_angle()) forget_first_near_ends();
        return 0.0F;
    }

    /// Where the film ends within two cells, what the last pressure would make is no measure: the line
    /// may have entered a cell since.
    void forget_first_near_ends() const {
        const float* h = scratch.block.thickness.data();
        for_each_lane_group(first_x, kTileSize, [&](int x) {
            const int f = face_index(x, y), i = block_index(x, y), s = axis.along;
            const Lanes thinnest = lanes::min(lanes::min(load(h + i - s), load(h + i)),
                                              lanes::min(load(h + i + s), load(h + i + 2 * s)));
            const auto inside = thinnest > Lanes(step.wet_mm);
            if (lanes::all(inside)) return;
            const auto keeps = inside || load(&faces.drag[f]) < Lanes(0.0F);
            store(&faces.first[f], lanes::select(keeps, load(&faces.first[f]), Lanes(0.0F)));
        });
    }
};

void shut(LargeFaces& faces, int f) {
    faces.depth[f] = faces.star[f] = faces.mobility[f] = 0.0F;
    faces.drag[f] = kExplicit;
}

/// A row without paint.
void clear_row(LargeFaces& faces, int y) {
    for (int x = -1; x < kTileSize; ++x) {
        const int f = face_index(x, y);
        shut(faces, f);
        faces.driven[f] = faces.across[f] = faces.resistance[f] = faces.weight[f] = 0.0F;
    }
}

/// How much of a height difference the surface tension feels at a face: 1 in a film of small slopes,
/// less where it is steep, and at the film's edge the derivative of the contact slope.
template <bool kFullCurvature>
void weight_row(const TileScratch& scratch, const StepConstants& step, int first_x, int y, int axis,
                int across, const float* normal_along, FaceArray<float>& weight) {
    const HaloBlock& block = scratch.block;
    const float* h = block.thickness.data();
    const float* eta = block.eta.data();
    const Lanes one(1.0F), zero(0.0F), wet(step.wet_mm);
    const auto edge_weight = [&](int i) {
        const Lanes sum = load(&scratch.ends.normal_x[i]) + load(&scratch.ends.normal_y[i]);
        const Lanes slope = load(&scratch.ends.contact_slope[i]);
        const auto follows =
            slope < cell_number(block.numbers.tan_advancing, step.tan_advancing, i, step) &&
            slope > cell_number(block.numbers.tan_receding, step.tan_receding, i, step);
        return lanes::select(follows, Lanes(Lanes(2.0F) * load(normal_along + i) / (sum + Lanes(1e-9F))),
                             zero);
    };
    for_each_lane_group(first_x, kTileSize, [&](int x) {
        const int left = block_index(x, y), right = left + axis;
        if (is_dry(block, step, left, axis)) return store(&weight[face_index(x, y)], zero);
        Lanes inner = one;
        if constexpr (kFullCurvature) {
            const Lanes slope = (load(eta + right) - load(eta + left)) * Lanes(step.inverse_cell);
            const Lanes slope_across = Lanes(0.25F * step.inverse_cell) *
                                       ((load(eta + left + across) - load(eta + left - across)) +
                                        (load(eta + right + across) - load(eta + right - across)));
            inner = one / lanes::sqrt(Lanes(one + slope * slope + slope_across * slope_across));
        }
        Lanes result = inner;
        const auto wet_left = load(h + left) > wet, wet_right = load(h + right) > wet;
        if (step.has_contact_angle() && !lanes::all(wet_left && wet_right)) {
            const Lanes edge = lanes::select(wet_left, edge_weight(left),
                                             lanes::select(wet_right, edge_weight(right), zero));
            result = lanes::select(wet_left && wet_right, inner, edge);
        }
        if (step.media) result = relative_tension(block, step, left, right) * result;
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
    const int first = block.first_wet_row, last = block.last_wet_row;
    float error = 0.0F;
    for (int y = -1; y < kTileSize; ++y) {
        if (y >= first - 1 && y <= last) {
            const LargeFaceRow<kModel> row{scratch, lag, step, y_axis, 0, y, tile.y, scratch.velocity_y,
                                           tile};
            error = lanes::max(error, row.assemble(again));
            weights(scratch, step, 0, y, kBlockStride, 1, scratch.ends.normal_y.data(), tile.y.weight);
        } else {
            clear_row(tile.y, y);
        }
        if (y >= first && y <= last && y >= 0) {
            const LargeFaceRow<kModel> row{scratch, lag, step, x_axis, -1, y, tile.x, scratch.velocity_x,
                                           tile};
            error = lanes::max(error, row.assemble(again));
            weights(scratch, step, -1, y, 1, kBlockStride, scratch.ends.normal_x.data(), tile.x.weight);
        } else {
            clear_row(tile.x, y);
        }
    }
    return error;
}

/// Nothing flows through a face at a closed edge or beyond the canvas.
void shut_closed_faces(int columns, int rows, const ClosedFaces& closed, const HaloBlock& block,
                       LargeTile& tile) {
    for_each_shut_face(
        columns, rows, closed, block, [&](int f) { shut(tile.x, f); }, [&](int f) { shut(tile.y, f); });
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
void compute_source(const StepConstants& step, LargeTile& tile) {
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

namespace {

bool is_crowded(const HaloBlock& block) {
    std::int32_t thickest = 0;
    for (int y = -1; y <= kTileSize; ++y)
        for (int x = -1; x <= kTileSize; ++x)
            thickest = std::max(thickest, block.quanta[block_index(x, y)]);
    return thickest > kCrowded_quanta;
}

/// Where the rest pressure of the gathered block is known, and where it counts.
struct RestPressure {
    const TileScratch& scratch;
    bool wet;         ///< whether there is any paint
    float lowest_mm;  ///< thickness above which it counts

    RestPressure(const StepConstants& step, const TileScratch& tile)
        : scratch(tile),
          wet(tile.block.last_wet_row >= tile.block.first_wet_row),
          lowest_mm(step.has_contact_angle() ? step.wet_mm : -1.0F) {}
    [[gnu::always_inline]] Lanes at(int x, int y) const {
        const HaloBlock& block = scratch.block;
        const bool defined = wet && y >= block.first_wet_row - 1 && y <= block.last_wet_row + 1;
        return defined ? load(&scratch.pressure[block_index(x, y)]) : Lanes(0.0F);
    }
    /// A pressure where paint flows, else 0.
    [[gnu::always_inline]] Lanes where_wet(Lanes pressure, int x, int y) const {
        const auto flows = load(&scratch.block.thickness[block_index(x, y)]) > Lanes(lowest_mm);
        return lanes::select(flows, pressure, Lanes(0.0F));
    }
};

/// Beyond the canvas there is no pressure that answers.
void clear_beyond(int columns, int rows, const CanvasEdges& edges, WindowArray& pressure) {
    for (int y = -1; y <= kTileSize; ++y) {
        if (edges.left) pressure[window_index(-1, y)] = 0.0F;
        if (edges.right) pressure[window_index(columns, y)] = 0.0F;
    }
    for (int x = -1; x <= kTileSize; ++x) {
        if (edges.top) pressure[window_index(x, -1)] = 0.0F;
        if (edges.bottom) pressure[window_index(x, rows)] = 0.0F;
    }
}

/// The pressure that the step starts from, and the change of thickness that it makes.
void start_pressure(const RestPressure& rest, int columns, int rows, const CanvasEdges& edges,
                    LargeScratch& large, LargeTile& tile) {
    for (int y = -1; y <= kTileSize; ++y)
        for_each_lane_group(-1, kTileSize + 1, [&](int x) {
            const Lanes lagged = load(&large.lagged_pressure[block_index(x, y)]);
            store(&large.pressure[window_index(x, y)], rest.where_wet(lagged, x, y));
        });
    for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x < kTileSize; x += kLanes) {
            const int cell = y * kTileSize + x;
            store(&tile.rest_pressure[cell], rest.where_wet(rest.at(x, y), x, y));
            store(&tile.pressure[cell], load(&large.pressure[window_index(x, y)]));
        }
    clear_beyond(columns, rows, edges, large.pressure);
    compute_change(large, tile);
}

}  // namespace

float assemble_large_tile(const StepConstants& step, int columns, int rows, const ClosedFaces& closed,
                          const CanvasEdges& edges, bool again, LargeScratch& large,
                          TileScratch& scratch, LargeTile& tile) {
    const RestPressure rest(step, scratch);
    tile.inertial = false;
    tile.fastest_mm_s = 0.0F;
    tile.fastest_retreat_mm_s = 0.0F;
    tile.crowded = is_crowded(scratch.block);
    if (rest.wet) prepare_pressure(step, scratch);
    BlockArray<float>& lag = large.lagged_pressure;
    for (int y = -1; y <= kTileSize; ++y)
        for_each_lane_group(-1, kTileSize + 1, [&](int x) {
            const int i = block_index(x, y);
            const Lanes last = load(&lag[i]);
            store(&lag[i], lanes::select(last != Lanes(0.0F), last, rest.at(x, y)));
        });
    const float error = with_face_model(step, [&]<FaceModel kModel>() {
        return assemble_faces<kModel>(step, lag.data(), again, scratch, tile);
    });
    shut_closed_faces(columns, rows, closed, scratch.block, tile);
    cut_response(columns, rows, edges, tile);
    compute_source(step, tile);
    if (!again) start_pressure(rest, columns, rows, edges, large, tile);
    return error;
}

}  // namespace pastoso::film::PASTOSO_ISA
