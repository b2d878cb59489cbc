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
/// A film thinner than 10 nm is not left behind: it would be invisible and keep cells wet for ever.
constexpr std::int32_t kTraceQuanta = 336;

#define PASTOSO_KERNEL_INLINE [[gnu::always_inline]] inline

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
    const float wanted = rule.underside_mm + rule.groove_mm * radius2 + rule.hair_mm * hair_at(rule, s);
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
    const float swap_mm = room > 0 ? rule.mix * share * smaller(h, rule.mix_depth_mm) : 0.0F;
    batch.swap[i] = static_cast<std::int32_t>(swap_mm * kQuantaPerMm);
}

template <bool kLane>
PASTOSO_KERNEL_INLINE WantedSums plan_batch(const ExchangeRule& rule, const BatchColumns& batch) {
    WantedSums sums;
    for (int first = 0; first < batch.padded_count; first += kBatchStep) {
        for (int i = 0; i < kBatchStep; ++i)
            plan_cell<kLane>(rule, batch, first + i);
        for (int i = 0; i < kBatchStep; ++i) {
            sums.deposit += larger(batch.change[first + i], 0);
            sums.swap += batch.swap[first + i];
        }
    }
    return sums;
}

/// A number in [0, 1) that is spread evenly over neighbouring cells: roundings with it have no bias.
PASTOSO_KERNEL_INLINE float dither(std::uint32_t cell, std::uint32_t seed) {
    return static_cast<float>((cell * 0x9E3779B9U + seed) >> 8) * 0x1p-24F;
}

/// The channels as groups of four, which every instruction set has registers for.
constexpr int kLanes = 4, kGroups = film::kPaintChannels / kLanes;
using FloatLanes [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;
using IntLanes [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = std::int32_t;
using WideLanes [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = std::int64_t;

/// Exchanges pigment: `out_share` of the cell's leaves, `gained` thickness quanta of the tool's come in.
PASTOSO_KERNEL_INLINE void exchange_pigment(IntLanes* pigment, const FloatLanes* given, float out_share,
                                            float gained, float rounding, WideLanes* sums) {
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
        sums[group] += __builtin_convertvector(change, WideLanes);
    }
}

PASTOSO_KERNEL_INLINE void take_all_pigment(IntLanes* pigment, WideLanes* sums) {
    for (int group = 0; group < kGroups; ++group) {
        sums[group] -= __builtin_convertvector(pigment[group], WideLanes);
        pigment[group] = IntLanes{};
    }
}

}  // namespace

WantedSums plan(const ExchangeRule& rule, const BatchColumns& batch) {
    return rule.lane ? plan_batch<true>(rule, batch) : plan_batch<false>(rule, batch);
}

void apply(const ApplyRule& rule, const TileCells& cells, ChangeSums& sums) {
    const auto* given = reinterpret_cast<const FloatLanes*>(rule.given.data());
    WideLanes gains[kGroups] = {};
    for (int i = 0; i < cells.count; ++i) {
        const std::int32_t cell = cells.cell[i];
        const std::int32_t h = cells.thickness[cell];
        std::int32_t change = cells.change[i];
        if (change > 0)
            change = static_cast<std::int32_t>(static_cast<float>(change) * rule.deposit_scale);
        if (change != 0 && h + change < kTraceQuanta) change = -h;
        const auto swap = static_cast<std::int32_t>(static_cast<float>(cells.swap[i]) * rule.swap_scale);
        if (change == 0 && swap == 0) continue;
        sums.any = true;
        sums.thickness += change;
        cells.thickness[cell] = h + change;
        auto* pigment = reinterpret_cast<IntLanes*>(cells.paint[cell].data());
        if (h + change == 0) {
            take_all_pigment(pigment, gains);
            continue;
        }
        const auto gained = static_cast<float>(swap + larger(change, 0));
        const auto lost = static_cast<float>(swap + larger(-change, 0));
        const float out_share = h > 0 ? smaller(lost / static_cast<float>(h), 1.0F) : 0.0F;
        exchange_pigment(pigment, given, out_share, gained,
                         dither(static_cast<std::uint32_t>(cell), rule.dither_seed), gains);
    }
    for (int k = 0; k < film::kPaintChannels; ++k)
        sums.paint[k] += gains[k / kLanes][k % kLanes];
}

}  // namespace pastoso::brush::PASTOSO_ISA
