// Compiled once per instruction set; see pastoso_add_kernels.
#include "brush/transfer_kernels.hpp"

#include "brush/cell_batch.hpp"
#include "film/state.hpp"

#include <limits>

namespace pastoso::brush::PASTOSO_ISA {
namespace {

constexpr auto kQuantum_mm = static_cast<float>(film::kThicknessQuantum_mm);
constexpr auto kQuantaPerMm = static_cast<float>(1.0 / film::kThicknessQuantum_mm);
constexpr auto kMost_mm = static_cast<float>(film::kMaxThickness_mm);
/// What a channel can count.
constexpr std::int32_t kMostPigment = std::numeric_limits<std::int32_t>::max();
/// A tool takes at most this share of a cell's paint in one step.
constexpr float kLargestBite = 0.9F;
/// Height of a groove's bottom above tau, in depths of the groove.
constexpr float kGrooveRise = 0.25F;
/// A film thinner than 10 nm is not left behind: it would be invisible and keep cells wet for ever.
constexpr std::int32_t kTraceQuanta = 336;

#define PASTOSO_KERNEL_INLINE [[gnu::always_inline]] inline

/// The channels in groups of one register: one, two or four.
#if defined(__AVX512F__)
constexpr int kLanes = 16;
#elif defined(__AVX2__)
constexpr int kLanes = 8;
#else
constexpr int kLanes = 4;
#endif
constexpr int kGroups = film::kPaintChannels / kLanes;
using FloatLanes [[gnu::vector_size(4 * kLanes), gnu::aligned(4), gnu::may_alias]] = float;
using IntLanes [[gnu::vector_size(4 * kLanes), gnu::aligned(4), gnu::may_alias]] = std::int32_t;

/// For sums of single numbers: half as many as a register of 32 bits holds.
constexpr int kWideLanes = kLanes / 2;
using NarrowLanes [[gnu::vector_size(4 * kWideLanes), gnu::aligned(4), gnu::may_alias]] = std::int32_t;
using WideLanes [[gnu::vector_size(8 * kWideLanes)]] = std::int64_t;

PASTOSO_KERNEL_INLINE float smaller(float a, float b) {
    return a < b ? a : b;
}
PASTOSO_KERNEL_INLINE float larger(float a, float b) {
    return a > b ? a : b;
}
PASTOSO_KERNEL_INLINE std::int32_t smaller(std::int32_t a, std::int32_t b) {
    return a < b ? a : b;
}
PASTOSO_KERNEL_INLINE std::int32_t larger(std::int32_t a, std::int32_t b) {
    return a > b ? a : b;
}

PASTOSO_KERNEL_INLINE float hair_at(const ExchangeRule& rule, float s) {
    const float half = 0.5F * static_cast<float>(rule.hairs_per_bristle);
    const float last = static_cast<float>(rule.hairs_per_bristle) - 0.001F;
    const float place = smaller(larger(s * half + half, 0.0F), last);
    const auto index = static_cast<std::int32_t>(place);
    const float share = place - static_cast<float>(index);
    return rule.hairs[index] + share * (rule.hairs[index + 1] - rule.hairs[index]);
}

template <bool kLane>
PASTOSO_KERNEL_INLINE void plan_cell(const ExchangeRule& rule, const BatchColumns& batch, int i) {
    const float s = batch.dx_mm[i] * rule.across_x + batch.dy_mm[i] * rule.across_y;
    const float t = batch.dx_mm[i] * rule.along_x + batch.dy_mm[i] * rule.along_y;
    const float s2 = s * s, t2 = t * t;
    const float radius2 = kLane ? t2 : s2 + t2;
    const float lane_share = kLane ? larger(0.0F, 1.0F - (s < 0.0F ? -s : s)) : 1.0F;
    const float weight = larger(0.0F, 1.0F - radius2 * radius2) * lane_share;

    const float h = static_cast<float>(batch.thickness[i]) * kQuantum_mm;
    const float wanted =
        rule.underside_mm + rule.groove_mm * (s2 + kGrooveRise) + rule.hair_mm * hair_at(rule, s);
    const float surface = batch.support_mm[i] + h;
    const float gap = wanted - surface;
    const float contact = smaller(larger((surface - rule.lowest_mm) * rule.fade_per_mm, 0.0F), 1.0F);
    const float share = rule.rate * weight * contact;

    const float given = smaller(share * gap, kMost_mm);
    const float taken = larger(share * gap * rule.pickup, -kLargestBite * h);
    const float change_mm = gap > 0.0F ? given : taken;
    const auto change = static_cast<std::int32_t>(change_mm * kQuantaPerMm);
    const std::int32_t room = larger(0, film::kMaxThickness_quanta - batch.thickness[i]);
    batch.change[i] = smaller(change, room);
    const float ground = static_cast<float>(smaller(batch.thickness[i], batch.found[i])) * kQuantum_mm;
    const float swap_mm = room > 0 ? rule.mix * share * smaller(ground, rule.mix_depth_mm) : 0.0F;
    batch.swap[i] = static_cast<std::int32_t>(swap_mm * kQuantaPerMm);
}

template <bool kLane>
PASTOSO_KERNEL_INLINE WantedSums plan_batch(const ExchangeRule& rule, const BatchColumns& batch) {
    WideLanes deposit = {}, swap = {};
    for (int first = 0; first < batch.padded_count; first += kBatchStep) {
        for (int i = first; i < first + kBatchStep; ++i)
            plan_cell<kLane>(rule, batch, i);
        for (int i = first; i < first + kBatchStep; i += kWideLanes) {
            const auto change = *reinterpret_cast<const NarrowLanes*>(&batch.change[i]);
            deposit += __builtin_convertvector(change > 0 ? change : NarrowLanes{}, WideLanes);
            swap += __builtin_convertvector(*reinterpret_cast<const NarrowLanes*>(&batch.swap[i]),
                                            WideLanes);
        }
    }
    WantedSums sums;
    for (int lane = 0; lane < kWideLanes; ++lane) {
        sums.deposit += deposit[lane];
        sums.swap += swap[lane];
    }
    return sums;
}

/// A number in [0, 1) that is spread evenly over neighbouring cells: roundings with it have no bias.
PASTOSO_KERNEL_INLINE float dither(std::uint32_t cell, std::uint32_t seed) {
    return static_cast<float>((cell * 0x9E3779B9U + seed) >> 8) * 0x1p-24F;
}

/// Sums of the channels' changes over up to 2^15 cells, in halves that do not overflow.
constexpr int kHalfBits = 16;
struct ChannelSums {
    IntLanes low[kGroups] = {};   ///< of the lower bits, as numbers >= 0
    IntLanes high[kGroups] = {};  ///< of the upper bits

    PASTOSO_KERNEL_INLINE void add(int group, IntLanes change) {
        low[group] += change & ((1 << kHalfBits) - 1);
        high[group] += change >> kHalfBits;
    }
    PASTOSO_KERNEL_INLINE void add_to(std::array<std::int64_t, film::kPaintChannels>& sums) const {
        alignas(64) std::int32_t lower[film::kPaintChannels], upper[film::kPaintChannels];
        for (int group = 0; group < kGroups; ++group) {
            *reinterpret_cast<IntLanes*>(lower + group * kLanes) = low[group];
            *reinterpret_cast<IntLanes*>(upper + group * kLanes) = high[group];
        }
        for (int k = 0; k < film::kPaintChannels; ++k)
            sums[k] += std::int64_t{upper[k]} * (1 << kHalfBits) + lower[k];
    }
};

/// Exchanges pigment: `out_share` of the cell's leaves, `gained` thickness quanta of the tool's come in.
PASTOSO_KERNEL_INLINE void exchange_pigment(IntLanes* pigment, const FloatLanes* given, float out_share,
                                            float gained, float rounding, ChannelSums& sums) {
    for (int group = 0; group < kGroups; ++group) {
        const IntLanes held = pigment[group];
        const IntLanes wanted = __builtin_convertvector(
            __builtin_convertvector(held, FloatLanes) * out_share + rounding, IntLanes);
        const IntLanes out = wanted < held ? wanted : held;
        const IntLanes offered = __builtin_convertvector(given[group] * gained + rounding, IntLanes);
        const IntLanes room = kMostPigment - (held - out);
        const IntLanes in = offered < room ? offered : room;
        const IntLanes change = in - out;
        pigment[group] = held + change;
        sums.add(group, change);
    }
}

PASTOSO_KERNEL_INLINE void take_all_pigment(IntLanes* pigment, ChannelSums& sums) {
    for (int group = 0; group < kGroups; ++group) {
        sums.add(group, -pigment[group]);
        pigment[group] = IntLanes{};
    }
}

/// What happens to a few cells, worked out for all of them at once before their pigment is touched.
constexpr int kChunk = 64;
static_assert(kChunk % kBatchStep == 0);
struct CellChanges {
    std::int32_t thickness[kChunk];
    std::int32_t swap[kChunk];
    float out_share[kChunk];  ///< of the cell's pigment
    float gained[kChunk];     ///< thickness quanta of the tool's paint
    float rounding[kChunk];
    std::int32_t active[kChunk];  ///< cells that change, in order
};

PASTOSO_KERNEL_INLINE void settle_change(const ApplyRule& rule, const TileCells& cells, int first, int i,
                                         CellChanges& changes) {
    const std::int32_t h = cells.held[first + i];
    const std::int32_t wanted = cells.change[first + i];
    const auto scaled = static_cast<std::int32_t>(static_cast<float>(wanted) * rule.deposit_scale);
    const std::int32_t fitting = wanted > 0 ? scaled : wanted;
    const std::int32_t change = fitting != 0 && h + fitting < kTraceQuanta ? -h : fitting;
    const auto swap =
        static_cast<std::int32_t>(static_cast<float>(cells.swap[first + i]) * rule.swap_scale);
    const float share = static_cast<float>(swap + larger(-change, 0)) / static_cast<float>(larger(h, 1));
    changes.thickness[i] = change;
    changes.swap[i] = swap;
    changes.out_share[i] = smaller(share, 1.0F);
    changes.gained[i] = static_cast<float>(swap + larger(change, 0));
    changes.rounding[i] = dither(static_cast<std::uint32_t>(cells.cell[first + i]), rule.dither_seed);
}

PASTOSO_KERNEL_INLINE void settle_changes(const ApplyRule& rule, const TileCells& cells, int first,
                                          int count, CellChanges& changes) {
    // Whole batch steps: a few cells of the next part or of the padding are worked out in vain.
    for (int begin = 0; begin < count; begin += kBatchStep) {
        for (int i = begin; i < begin + kBatchStep; ++i)
            settle_change(rule, cells, first, i, changes);
    }
}

PASTOSO_KERNEL_INLINE int list_active(int count, CellChanges& changes) {
    int active = 0;
    for (int i = 0; i < count; ++i) {
        changes.active[active] = i;
        active += (changes.thickness[i] | changes.swap[i]) != 0 ? 1 : 0;
    }
    return active;
}

/// Moves the thickness and the pigment of up to kChunk cells.
PASTOSO_KERNEL_INLINE void apply_chunk(const ApplyRule& rule, const TileCells& cells, int first,
                                       int count, ChangeSums& sums) {
    CellChanges changes;
    settle_changes(rule, cells, first, count, changes);
    const int active = list_active(count, changes);
    const auto* given = reinterpret_cast<const FloatLanes*>(rule.given.data());
    ChannelSums gains;
    for (int n = 0; n < active; ++n) {
        const int i = changes.active[n];
        const std::int32_t cell = cells.cell[first + i];
        const std::int32_t thickness = cells.held[first + i] + changes.thickness[i];
        sums.thickness += changes.thickness[i];
        cells.thickness[cell] = thickness;
        auto* pigment = reinterpret_cast<IntLanes*>(cells.paint[cell].data());
        if (thickness == 0)
            take_all_pigment(pigment, gains);
        else
            exchange_pigment(pigment, given, changes.out_share[i], changes.gained[i],
                             changes.rounding[i], gains);
    }
    sums.any = sums.any || active > 0;
    gains.add_to(sums.paint);
}

}  // namespace

WantedSums plan(const ExchangeRule& rule, const BatchColumns& batch) {
    return rule.lane ? plan_batch<true>(rule, batch) : plan_batch<false>(rule, batch);
}

void apply(const ApplyRule& rule, const TileCells& cells, ChangeSums& sums) {
    for (int first = 0; first < cells.count; first += kChunk)
        apply_chunk(rule, cells, first, smaller(kChunk, cells.count - first), sums);
}

}  // namespace pastoso::brush::PASTOSO_ISA
