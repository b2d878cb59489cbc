// Compiled once per instruction set; see pastoso_add_kernels.
//
// The four random numbers around a place are hashed for each place anew: lanes do that faster than they
// would find them in a table.
#include "film/support/gesso_kernel.hpp"

#include "core/lane_memory.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

namespace lanes = core::lanes;

using F = lanes::Widest<float>;
using U = lanes::As<std::uint32_t, F>;
/// Half as many, and so as many registers.
using D = lanes::Lanes<double, F::kLanes / 2>;

/// Whether the columns of a line are along the marks or across them.
enum class Line { Along, Across };

struct Place {
    U before;
    F share;
};

/// core::scramble().
PASTOSO_LANE_FUNCTION U scramble(U x) {
    x = (x ^ (x >> 16)) * U(0x7feb352dU);
    x = (x ^ (x >> 15)) * U(0x846ca68bU);
    return x ^ (x >> 16);
}

/// core::uniform_noise(), of a stream that is scrambled already.
PASTOSO_LANE_FUNCTION F uniform_noise(U index, U scrambled_stream) {
    const U found = scramble((index * U(0x9E3779B9U)) ^ scrambled_stream);
    return lanes::convert<float>(lanes::bits<std::int32_t>(found >> 8)) * F(1.0F / 16777216.0F);
}

/// smooth_noise() along a line.
PASTOSO_LANE_FUNCTION F smooth_noise(const Place& place, U stream) {
    const U scrambled = scramble(stream);
    const F before = uniform_noise(place.before, scrambled);
    return before + place.share * (uniform_noise(place.before + U(1U), scrambled) - before);
}

/// The same in the plane.
PASTOSO_LANE_FUNCTION F smooth_noise(const Place& along, const Place& across, U plane) {
    const U row = plane + across.before;
    const F above = smooth_noise(along, row);
    return above + across.share * (smooth_noise(along, row + U(1U)) - above);
}

template <class V>
PASTOSO_LANE_FUNCTION V smooth_step(V t) {
    return t * t * (V(3.0F) - V(2.0F) * t);
}

PASTOSO_LANE_FUNCTION D floor(D x) {
    const D truncated = lanes::convert<double>(lanes::convert<std::int32_t>(x));
    return truncated - lanes::select(truncated > x, D(1.0), D(0.0));
}

template <bool kVaries>
PASTOSO_LANE_FUNCTION Place place_at(const NoiseColumns& columns, int k) {
    if constexpr (kVaries)
        return {lanes::load<U>(columns.before + k), lanes::load<F>(columns.share + k)};
    else
        return {U(*columns.before), F(*columns.share)};
}

/// Where drifted marks lie across themselves.
struct Drifted {
    D first_mm, second_mm;

    PASTOSO_LANE_MEMBER Place place(double across_mm) const {
        const D first = first_mm / D(across_mm), second = second_mm / D(across_mm);
        const D first_whole = floor(first), second_whole = floor(second);
        return {lanes::bits<std::uint32_t>(lanes::joined(lanes::convert<std::int32_t>(first_whole),
                                                         lanes::convert<std::int32_t>(second_whole))),
                lanes::joined(smooth_step(lanes::convert<float>(first - first_whole)),
                              smooth_step(lanes::convert<float>(second - second_whole)))};
    }
};

template <Line kLine>
PASTOSO_LANE_FUNCTION Drifted drifted(const double* across_mm, int k, F drift) {
    D first_mm(*across_mm), second_mm(*across_mm);
    if constexpr (kLine == Line::Across) {
        first_mm = lanes::load<D>(across_mm + k);
        second_mm = lanes::load<D>(across_mm + k + D::kLanes);
    }
    return {first_mm + D(kGessoDrift_mm) * lanes::convert<double>(lanes::half_of<0>(drift)),
            second_mm + D(kGessoDrift_mm) * lanes::convert<double>(lanes::half_of<1>(drift))};
}

template <Line kLine>
PASTOSO_LANE_FUNCTION void put_heights(const GessoLine& line, float* heights) {
    constexpr bool kAlong = kLine == Line::Along;
    const U drift(kGessoDrift.plane), broad(kBroadMarks.plane), fine(kFineMarks.plane),
        grain(kGessoGrain.plane);
    for (int k = 0; k < line.count; k += F::kLanes) {
        const F drifts = smooth_noise(place_at<kAlong>(line.drift_along, k),
                                      place_at<!kAlong>(line.drift_across, k), drift);
        const Drifted marks = drifted<kLine>(line.across_mm, k, drifts);
        const F broads = smooth_noise(place_at<kAlong>(line.broad_along, k),
                                      marks.place(kBroadMarks.across_mm), broad);
        const F fines =
            smooth_noise(place_at<kAlong>(line.fine_along, k), marks.place(kFineMarks.across_mm), fine);
        const F grains = smooth_noise(place_at<kAlong>(line.grain_along, k),
                                      place_at<!kAlong>(line.grain_across, k), grain);
        lanes::store(heights + k, F(0.4F) * broads + F(0.4F) * fines + F(0.2F) * grains);
    }
}

void along_marks(const GessoLine& line, float* heights) {
    put_heights<Line::Along>(line, heights);
}

void across_marks(const GessoLine& line, float* heights) {
    put_heights<Line::Across>(line, heights);
}

}  // namespace
}  // namespace pastoso::film::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::film, GessoKernels, along_marks, across_marks)
