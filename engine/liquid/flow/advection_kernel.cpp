// Semi-Lagrangian advection of a row: back along the flow by the midpoint rule, then the value there.
// Compiled once per instruction set; see pastoso_add_kernels.
#include "liquid/flow/kernels.hpp"
#include "liquid/flow/sample_lanes.hpp"

namespace pastoso::liquid::PASTOSO_ISA {
namespace {

/// The velocity in the middle between two faces from the four nearest along their axis.
[[gnu::always_inline]] inline float fourth_order_mean(const float* face, std::ptrdiff_t stride) {
    return 0.5625F * (face[0] + face[stride]) - 0.0625F * (face[-stride] + face[2 * stride]);
}

template <bool kPeriodic>
struct Tracer {
    AdvectionView flow;
    Four size;
    std::ptrdiff_t to_previous;  ///< from a face to the cell before it, in floats; 0: samples at middles
    const float* row;            ///< the row's centre 0
    Four first;                  ///< where the row's sample 0 lies

    [[gnu::always_inline]] Tracer(const AdvectionView& view, const AdvectedRow& samples)
        : flow(view),
          size{view.size_cells[0], view.size_cells[1], view.size_cells[2], 1.0F},
          to_previous(samples.axis == 0   ? 4
                      : samples.axis == 1 ? 4 * view.stride_y
                      : samples.axis == 2 ? 4 * view.stride_z
                                          : 0),
          row(view.centres + 4 * (samples.j * view.stride_y + samples.k * view.stride_z)),
          first(location_of(samples.axis) +
                Four{0.0F, static_cast<float>(samples.j), static_cast<float>(samples.k), 0.0F}) {}

    [[gnu::always_inline]] Four here(int i) const {
        return first + Four{static_cast<float>(i), 0.0F, 0.0F, 0.0F};
    }
    /// Where sample i was half a step ago, among the centres.
    [[gnu::always_inline]] Place halfway(int i) const {
        const float* centre = row + 4 * static_cast<std::ptrdiff_t>(i);
        const Four velocity =
            Four(0.5F) * (lanes::load<Four>(centre) + lanes::load<Four>(centre - to_previous));
        const Four middle = in_box<kPeriodic>(here(i) - Four(0.5F * flow.step) * velocity, size);
        return place_of(middle - location_of(3), flow.stride_y, flow.stride_z);
    }
    /// Where it came from, in cell units.
    [[gnu::always_inline]] Four origin(int i, const Place& halfway) const {
        const Four velocity = linear_of_four(flow.centres, halfway, flow.stride_y, flow.stride_z);
        return in_box<kPeriodic>(here(i) - Four(flow.step) * velocity, size);
    }
};

/// Samples whose ways back are found before any value is: each is a long chain, and the processor
/// follows several at once as long as nothing else comes between.
constexpr int kBlock = 32;

template <bool kPeriodic, Interpolation kInterpolation>
[[gnu::always_inline]] inline void advect(const AdvectionView& flow, const AdvectedRow& row) {
    const Tracer<kPeriodic> tracer(flow, row);
    const Four location = location_of(row.axis);
    const std::ptrdiff_t y = flow.stride_y, z = flow.stride_z;
    Place places[kBlock];
    for (int begin = row.begin; begin < row.end; begin += kBlock) {
        const int count = row.end - begin < kBlock ? row.end - begin : kBlock;
        for (int i = 0; i < count; ++i)
            places[i] = tracer.halfway(begin + i);
        for (int i = 0; i < count; ++i)
            places[i] = place_of(tracer.origin(begin + i, places[i]) - location, y, z);
        for (int i = 0; i < count; ++i) {
            if constexpr (kInterpolation == Interpolation::Linear) {
                for (int f = 0; f < row.field_count; ++f)
                    row.fields[f].to[begin + i] = linear(row.fields[f].from, places[i], y, z);
            } else {
                const CubicWeights weights = cubic_weights_at(places[i].share);
                for (int f = 0; f < row.field_count; ++f)
                    row.fields[f].to[begin + i] = cubic<kInterpolation == Interpolation::LimitedCubic>(
                        row.fields[f].from, places[i], weights, y, z);
            }
        }
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

template <bool kPeriodic, bool kCubic>
[[gnu::always_inline]] inline Four face_velocity(const CarryView& flow, Four at) {
    float velocity[3];
    for (int axis = 0; axis < 3; ++axis) {
        const Place place = place_of(at - location_of(axis), flow.stride_y, flow.stride_z);
        if constexpr (kCubic)
            velocity[axis] = cubic<false>(flow.faces[axis], place, cubic_weights_at(place.share),
                                          flow.stride_y, flow.stride_z);
        else
            velocity[axis] = linear(flow.faces[axis], place, flow.stride_y, flow.stride_z);
    }
    return Four{velocity[0], velocity[1], velocity[2], 0.0F};
}

template <bool kPeriodic, bool kCubic>
void carry(const CarryView& flow, float* points, int count) {
    const Four size = {flow.size_cells[0], flow.size_cells[1], flow.size_cells[2], 1.0F};
    for (int p = 0; p < count; ++p) {
        const Four here = lanes::load<Four>(points + 4 * p);
        const Four inside = in_box<kPeriodic>(here, size);
        const Four middle = in_box<kPeriodic>(
            inside + Four(0.5F * flow.step) * face_velocity<kPeriodic, false>(flow, inside), size);
        const Four moved = in_box<kPeriodic>(
            inside + Four(flow.step) * face_velocity<kPeriodic, kCubic>(flow, middle), size);
        lanes::store(points + 4 * p, moved);
    }
}

template <bool kPeriodic>
void carry_by_interpolation(const CarryView& flow, float* points, int count) {
    if (flow.interpolation == Interpolation::Linear) return carry<kPeriodic, false>(flow, points, count);
    carry<kPeriodic, true>(flow, points, count);
}

}  // namespace

void centre_velocity(const FaceRows& faces, int count, float* out) {
    for (int m = 0; m < count; ++m) {
        const Four velocity = {fourth_order_mean(faces.x + m, 1),
                               fourth_order_mean(faces.y + m, faces.stride_y),
                               fourth_order_mean(faces.z + m, faces.stride_z), 0.0F};
        lanes::store(out + 4 * static_cast<std::ptrdiff_t>(m), velocity);
    }
}

void advect_row(const AdvectionView& flow, const AdvectedRow& row) {
    if (flow.edges == Edges::Periodic) return advect_by_interpolation<true>(flow, row);
    advect_by_interpolation<false>(flow, row);
}

void carry_points(const CarryView& flow, float* points, int count) {
    if (flow.edges == Edges::Periodic) return carry_by_interpolation<true>(flow, points, count);
    carry_by_interpolation<false>(flow, points, count);
}

}  // namespace pastoso::liquid::PASTOSO_ISA
