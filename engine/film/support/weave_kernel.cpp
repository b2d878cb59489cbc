// Compiled once per instruction set; see pastoso_add_kernels.
//
// Where threads cross, one lies above the other, in turn, so that every thread rises and dips like a
// wave; its cross-section is a round crown. The cloth's surface is the higher of the two, with the
// valleys between them filled by the priming.
#include "film/support/weave_kernel.hpp"

#include "core/lane_memory.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

namespace lanes = core::lanes;

using F = lanes::Widest<float>;

/// A thread where a line crosses it; lengths in pitches.
struct Section {
    F centre, half_width, crown;
};

/// The threads on both sides of a place and where between their centres it lies.
struct Neighbours {
    Section before, after;
    F parity;  ///< of the one before
    F share;   ///< 0 at its centre, 1 at that of the other
};

PASTOSO_LANE_FUNCTION Section section_at(const SectionColumns& columns, int k) {
    return {lanes::load<F>(columns.centre + k), lanes::load<F>(columns.half_width + k),
            lanes::load<F>(columns.crown + k)};
}

template <class Mask>
PASTOSO_LANE_FUNCTION Section select(Mask condition, const Section& a, const Section& b) {
    return {lanes::select(condition, a.centre, b.centre),
            lanes::select(condition, a.half_width, b.half_width),
            lanes::select(condition, a.crown, b.crown)};
}

PASTOSO_LANE_FUNCTION F floor(F x) {
    const F truncated = lanes::convert<float>(lanes::convert<std::int32_t>(x));
    return truncated - lanes::select(truncated > x, F(1.0F), F(0.0F));
}

PASTOSO_LANE_FUNCTION F smooth_step(F t) {
    return t * t * (F(3.0F) - F(2.0F) * t);
}

/// cos(pi t) for t in [0, 1], as a cubic with the same values and slopes at both ends.
PASTOSO_LANE_FUNCTION F half_wave(F t) {
    return F(1.0F) - F(2.0F) * smooth_step(t);
}

/// How deep the furrow between two plies is at a place on a thread, 0 to 1: they wind around each other.
PASTOSO_LANE_FUNCTION F furrow(F along, F across) {
    constexpr float kLay = 1.3F, kAslant = 0.5F;  // length of a turn in pitches; turns across the thread
    const F turn = along / F(kLay) + F(kAslant) * across;
    const F share = turn - floor(turn);
    return F(1.0F) - smooth_step(F(2.0F) * lanes::min(share, F(1.0F) - share));
}

/// Height of a thread at `offset` pitches from its centre line; `rise` is 1 where it passes over a
/// crossing thread and -1 where it passes under.
template <bool kTwisted>
PASTOSO_LANE_FUNCTION F thread_height(const Section& thread, F offset, F rise, F along, F twist) {
    constexpr float kDip = 0.7F;  // of the crown's height, from the top of a wave to its bottom
    const F across = offset / thread.half_width;
    const F roundness = lanes::sqrt(lanes::max(F(0.0F), F(1.0F) - across * across));
    const F height = thread.crown * roundness * (F(1.0F) - F(0.5F * kDip) * (F(1.0F) - rise));
    if constexpr (!kTwisted) return height;
    const F furrowed = height * (F(1.0F) - twist * furrow(along, across));
    return lanes::select(roundness > F(0.0F), furrowed, height);
}

/// The larger of two, rounded where they are nearly equal: priming fills the groove between threads.
PASTOSO_LANE_FUNCTION F primed_maximum(F a, F b) {
    constexpr float kFill = 0.12F;
    const F gap = lanes::max(F(0.0F), F(kFill) - lanes::abs(a - b));
    return lanes::max(a, b) + gap * gap / F(4.0F * kFill);
}

PASTOSO_LANE_FUNCTION F share_between(const Section& before, const Section& after, F place) {
    return lanes::clamp((place - before.centre) / (after.centre - before.centre), F(0.0F), F(1.0F));
}

template <bool kTwisted>
PASTOSO_LANE_FUNCTION F cloth_height(const Neighbours& warp, F u, const Neighbours& weft, F v, F twist) {
    const F parity = warp.parity * weft.parity;
    const F along_warp = parity * half_wave(weft.share);
    const F along_weft = -parity * half_wave(warp.share);
    const auto height = [&](const Section& thread, F place, F rise, F along) PASTOSO_LANE_MEMBER {
        return thread_height<kTwisted>(thread, place - thread.centre, rise, along, twist);
    };
    const F warp_height =
        lanes::max(height(warp.before, u, along_warp, v), height(warp.after, u, -along_warp, v));
    const F weft_height =
        lanes::max(height(weft.before, v, along_weft, u), height(weft.after, v, -along_weft, u));
    return lanes::min(F(1.0F), primed_maximum(warp_height, weft_height));
}

/// The mean of cloth_height() around a place: thick threads raise it.
PASTOSO_LANE_FUNCTION F mean_height(const Neighbours& warp, const Neighbours& weft) {
    constexpr float kOfCrown = 0.66F;
    const F crowns = warp.before.crown + warp.after.crown + weft.before.crown + weft.after.crown;
    return F(kOfCrown * 0.25F) * crowns;
}

PASTOSO_LANE_FUNCTION Neighbours warp_at(const ClothLine& line, int k, F u) {
    const Section before = section_at(line.warp_before, k), after = section_at(line.warp_after, k);
    return {before, after, lanes::load<F>(line.warp_parity + k), share_between(before, after, u)};
}

/// The last thread whose centre, and all before it, lie before the line.
PASTOSO_LANE_FUNCTION Neighbours weft_at(const ClothLine& line, int k, F v) {
    Section before = section_at(line.weft[0], k), after = section_at(line.weft[1], k);
    F parity(line.weft_parity);
    auto passed = after.centre <= v;
    for (int next = 2; next < kWeftsNear; ++next) {
        const Section further = section_at(line.weft[next], k);
        before = select(passed, after, before);
        parity = lanes::select(passed, F(next % 2 == 0 ? -line.weft_parity : line.weft_parity), parity);
        after = select(passed, further, after);
        passed = passed && further.centre <= v;
    }
    return {before, after, parity, share_between(before, after, v)};
}

template <bool kTwisted>
PASTOSO_LANE_FUNCTION void put_heights(const ClothLine& line, float* heights) {
    const F v(line.v), twist(line.twist), nap(line.nap), shown(line.shown);
    for (int k = 0; k < line.count; k += F::kLanes) {
        const F u = lanes::load<F>(line.u + k);
        const Neighbours warp = warp_at(line, k, u), weft = weft_at(line, k, v);
        F height = cloth_height<kTwisted>(warp, u, weft, v, twist);
        if (line.nap > 0.0F) {
            const F above = lanes::load<F>(line.fibres_above + k),
                    below = lanes::load<F>(line.fibres_below + k);
            const F fibres = above + F(line.fibres_share) * (below - above);
            height = lanes::clamp(height + nap * (fibres - F(0.5F)), F(0.0F), F(1.0F));
        }
        if (line.shown != 1.0F) {
            const F mean = mean_height(warp, weft);
            height = mean + shown * (height - mean);
        }
        lanes::store(heights + k, height);
    }
}

void cloth_heights(const ClothLine& line, float* heights) {
    if (line.twist > 0.0F)
        put_heights<true>(line, heights);
    else
        put_heights<false>(line, heights);
}

}  // namespace
}  // namespace pastoso::film::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::film, WeaveKernels, cloth_heights)
