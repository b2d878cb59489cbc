// Semi-Lagrangian advection of a row: back along the flow by the midpoint rule, then the value there.
// Compiled once per instruction set; see pastoso_add_kernels.
#include "liquid/flow/kernels.hpp"
#include "liquid/flow/sample_groups.hpp"

namespace pastoso::liquid::PASTOSO_ISA {
namespace {

/// The velocity in the middle between two faces from the four nearest along their axis.
[[gnu::always_inline]] inline float fourth_order_mean(const float* face, std::ptrdiff_t stride) {
    return 0.5625F * (face[0] + face[stride]) - 0.0625F * (face[-stride] + face[2 * stride]);
}

/// The value in between, of a group's points that have the same samples around them.
template <Interpolation kInterpolation>
struct GroupValue {
    GroupCubics cubics;
    std::ptrdiff_t stride_y, stride_z;

    [[gnu::always_inline]] GroupValue(const ThreeGroups& share, std::ptrdiff_t y, std::ptrdiff_t z)
        : cubics(share), stride_y(y), stride_z(z) {}
    template <class Samples>
    [[gnu::always_inline]] Group operator()(const Samples& first) const {
        return cubic_of<kInterpolation == Interpolation::LimitedCubic>(first, cubics, stride_y,
                                                                       stride_z);
    }
};
template <>
struct GroupValue<Interpolation::Linear> {
    ThreeGroups share;
    std::ptrdiff_t stride_y, stride_z;

    [[gnu::always_inline]] GroupValue(const ThreeGroups& at, std::ptrdiff_t y, std::ptrdiff_t z)
        : share(at), stride_y(y), stride_z(z) {}
    template <class Samples>
    [[gnu::always_inline]] Group operator()(const Samples& first) const {
        return linear_of(first, share, stride_y, stride_z);
    }
};

/// Neighbours of a row, one after the other from sample `first` on, and how to read where they were.
/// Places are counted from the samples themselves: neighbours that moved through the same cells have the
/// same.
struct RowGroup {
    std::ptrdiff_t first, stride_y, stride_z;
    std::ptrdiff_t memory_begin, memory_end;  ///< the samples that a field has
    int count;

    /// results[n] = the value of field n at the places.
    template <Interpolation kInterpolation>
    [[gnu::always_inline]] void sample(const GroupPlace& place, const float* const* fields,
                                       int field_count, Group* results) const {
        // A stencil begins so many samples before its place along each axis and ends one more behind.
        constexpr int kBefore = kInterpolation == Interpolation::Linear ? 0 : 1;
        const std::ptrdiff_t diagonal = 1 + stride_y + stride_z;
        const GroupValue<kInterpolation> value(place.share, stride_y, stride_z);
        for_indices(place.index, count, [&](std::int32_t index, const auto& same) PASTOSO_LANE_MEMBER {
            const std::ptrdiff_t at = first + index;
            const bool lies_in_memory = at - kBefore * diagonal >= memory_begin &&
                                        at + (kBefore + 1) * diagonal + kPointsTogether <= memory_end;
            if (!lies_in_memory) [[unlikely]] {
                for (int n = 0; n < field_count; ++n)
                    results[n] = lanes::select(
                        same,
                        one_by_one<kInterpolation>(place.share, lanes::mask_bits(same), fields[n] + at),
                        results[n]);
                return;
            }
            for (int n = 0; n < field_count; ++n)
                results[n] = lanes::select(same, value(BesideOneAnother{fields[n] + at}), results[n]);
        });
    }

  private:
    /// At the edges of memory, where the group's other points would read beyond it.
    template <Interpolation kInterpolation>
    [[gnu::noinline]] Group one_by_one(const ThreeGroups& share, std::uint32_t points,
                                       const float* from) const {
        float values[kPointsTogether] = {};
        for (int lane = 0; lane < kPointsTogether; ++lane) {
            if ((points >> lane & 1U) == 0) continue;
            const Place place = {lane, Four{share.x[lane], share.y[lane], share.z[lane], 0.0F}};
            if constexpr (kInterpolation == Interpolation::Linear)
                values[lane] = linear(from, place, stride_y, stride_z);
            else
                values[lane] = cubic<kInterpolation == Interpolation::LimitedCubic>(
                    from, place, cubic_weights_at(place.share), stride_y, stride_z);
        }
        return lanes::load<Group>(values);
    }
};

/// A group of a row's samples, and where they lie in cell units.
struct Samples {
    const AdvectionView& flow;
    int axis;
    ThreeGroups here;
    RowGroup group;

    [[gnu::always_inline]] Samples(const AdvectionView& view, int of_axis, int begin, int end, int j,
                                   int k)
        : flow(view),
          axis(of_axis),
          here{Group(static_cast<float>(begin) + (axis == 0 ? 0.0F : 0.5F)) + lanes::counting<Group>(),
               Group(static_cast<float>(j) + (axis == 1 ? 0.0F : 0.5F)),
               Group(static_cast<float>(k) + (axis == 2 ? 0.0F : 0.5F))},
          group{begin + j * view.stride_y + k * view.stride_z,
                view.stride_y,
                view.stride_z,
                view.memory_begin,
                view.memory_end,
                end - begin < kPointsTogether ? end - begin : kPointsTogether} {}

    /// The places `way` back, among the samples of an axis.
    template <bool kPeriodic>
    [[gnu::always_inline]] GroupPlace back(const ThreeGroups& way, int among) const {
        GroupPlace place =
            place_among(in_box<kPeriodic>(ThreeGroups{here.x - way.x, here.y - way.y, here.z - way.z},
                                          flow.size_cells),
                        among, flow.stride_y, flow.stride_z);
        place.index -=
            GroupIndex(static_cast<std::int32_t>(group.first)) + lanes::counting<GroupIndex>();
        return place;
    }
    [[gnu::always_inline]] void write(const Group& values, float* first) const {
        if (group.count == kPointsTogether)
            lanes::store(first, values);
        else
            store_first(first, values, group.count);
    }
};

/// From a face to the cell before it; 0: samples at middles.
[[gnu::always_inline]] inline std::ptrdiff_t to_previous(const AdvectionView& flow, int axis) {
    return axis == 0 ? 1 : axis == 1 ? flow.stride_y : axis == 2 ? flow.stride_z : 0;
}

/// The mean of a group's cells and others.
[[gnu::always_inline]] inline Group mean_with(const float* cell, std::ptrdiff_t to_other) {
    return Group(0.5F) * (lanes::load<Group>(cell) + lanes::load<Group>(cell - to_other));
}

template <bool kPeriodic>
void trace(const AdvectionView& flow, const TracedRow& row) {
    const std::ptrdiff_t to_other = to_previous(flow, row.axis);
    for (int begin = row.begin; begin < row.end; begin += kPointsTogether) {
        const Samples samples(flow, row.axis, begin, row.end, row.j, row.k);
        const auto half = [&](int component) PASTOSO_LANE_MEMBER {
            return Group(0.5F * flow.step) *
                   mean_with(flow.centres[component] + samples.group.first, to_other);
        };
        const GroupPlace halfway = samples.back<kPeriodic>({half(0), half(1), half(2)}, 3);
        Group velocity[3] = {Group(0.0F), Group(0.0F), Group(0.0F)};
        samples.group.sample<Interpolation::Linear>(halfway, flow.centres, 3, velocity);
        for (int component = 0; component < 3; ++component)
            samples.write(Group(flow.step) * velocity[component], row.way[component] + begin);
    }
}

template <bool kPeriodic, Interpolation kInterpolation>
[[gnu::always_inline]] inline void advect(const AdvectionView& flow, const AdvectedRow& row) {
    const float* from[kMaxFieldsTogether];
    for (int f = 0; f < row.field_count; ++f)
        from[f] = row.fields[f].from;
    const std::ptrdiff_t to_other = flow.ways_of_cells ? to_previous(flow, row.axis) : 0;
    for (int begin = row.begin; begin < row.end; begin += kPointsTogether) {
        const Samples samples(flow, row.axis, begin, row.end, row.j, row.k);
        const auto way = [&](int axis) PASTOSO_LANE_MEMBER {
            return mean_with(flow.ways[axis] + samples.group.first, to_other);
        };
        const GroupPlace origin = samples.template back<kPeriodic>({way(0), way(1), way(2)}, row.axis);
        Group values[kMaxFieldsTogether] = {Group(0.0F), Group(0.0F), Group(0.0F), Group(0.0F)};
        samples.group.template sample<kInterpolation>(origin, from, row.field_count, values);
        for (int f = 0; f < row.field_count; ++f)
            samples.write(values[f], row.fields[f].to + begin);
    }
}

template <bool kPeriodic>
void advect_by_interpolation(const AdvectionView& flow, const AdvectedRow& row) {
    if (row.interpolation == Interpolation::Linear)
        return advect<kPeriodic, Interpolation::Linear>(flow, row);
    if (row.interpolation == Interpolation::Cubic)
        return advect<kPeriodic, Interpolation::Cubic>(flow, row);
    advect<kPeriodic, Interpolation::LimitedCubic>(flow, row);
}

/// The velocity on faces at a group's places.
template <Interpolation kInterpolation>
[[gnu::always_inline]] inline ThreeGroups face_velocity(const CarryView& flow, const ThreeGroups& at) {
    Group velocity[3] = {Group(0.0F), Group(0.0F), Group(0.0F)};
    for (int axis = 0; axis < 3; ++axis) {
        const GroupPlace place = place_among(at, axis, flow.stride_y, flow.stride_z);
        const GroupValue<kInterpolation> value(place.share, flow.stride_y, flow.stride_z);
        for_indices(
            place.index, kPointsTogether, [&](std::int32_t index, const auto& same) PASTOSO_LANE_MEMBER {
                velocity[axis] =
                    lanes::select(same, value(InOnePlace{flow.faces[axis] + index}), velocity[axis]);
            });
    }
    return {velocity[0], velocity[1], velocity[2]};
}

template <bool kPeriodic>
[[gnu::always_inline]] inline ThreeGroups moved(const CarryView& flow, const ThreeGroups& from,
                                                const ThreeGroups& velocity, float step) {
    return in_box<kPeriodic>(
        ThreeGroups{from.x + Group(step) * velocity.x, from.y + Group(step) * velocity.y,
                    from.z + Group(step) * velocity.z},
        flow.size_cells);
}

template <bool kPeriodic, Interpolation kInterpolation>
void carry(const CarryView& flow, const CarriedPoints& points, int count) {
    for (int p = 0; p < count; p += kPointsTogether) {
        const auto load = [&](int axis)
                              PASTOSO_LANE_MEMBER { return lanes::load<Group>(points.at[axis] + p); };
        const ThreeGroups from =
            in_box<kPeriodic>(ThreeGroups{load(0), load(1), load(2)}, flow.size_cells);
        const ThreeGroups middle = moved<kPeriodic>(
            flow, from, face_velocity<Interpolation::Linear>(flow, from), 0.5F * flow.step);
        const ThreeGroups to =
            moved<kPeriodic>(flow, from, face_velocity<kInterpolation>(flow, middle), flow.step);
        lanes::store(points.at[0] + p, to.x);
        lanes::store(points.at[1] + p, to.y);
        lanes::store(points.at[2] + p, to.z);
    }
}

template <bool kPeriodic>
void carry_by_interpolation(const CarryView& flow, const CarriedPoints& points, int count) {
    if (flow.interpolation == Interpolation::Linear)
        return carry<kPeriodic, Interpolation::Linear>(flow, points, count);
    carry<kPeriodic, Interpolation::Cubic>(flow, points, count);
}

}  // namespace

void centre_velocity(const FaceRows& faces, int count, float* const* out) {
    const float* const from[3] = {faces.x, faces.y, faces.z};
    const std::ptrdiff_t along[3] = {1, faces.stride_y, faces.stride_z};
    for (int axis = 0; axis < 3; ++axis) {
        const float* face = from[axis];
        const std::ptrdiff_t stride = along[axis];
        float* __restrict middle = out[axis];
        for (int m = 0; m < count; ++m)
            middle[m] = fourth_order_mean(face + m, stride);
    }
}

void trace_row(const AdvectionView& flow, const TracedRow& row) {
    if (flow.edges == Edges::Periodic) return trace<true>(flow, row);
    trace<false>(flow, row);
}

void advect_row(const AdvectionView& flow, const AdvectedRow& row) {
    if (flow.edges == Edges::Periodic) return advect_by_interpolation<true>(flow, row);
    advect_by_interpolation<false>(flow, row);
}

void carry_points(const CarryView& flow, const CarriedPoints& points, int count) {
    if (flow.edges == Edges::Periodic) return carry_by_interpolation<true>(flow, points, count);
    carry_by_interpolation<false>(flow, points, count);
}

}  // namespace pastoso::liquid::PASTOSO_ISA
