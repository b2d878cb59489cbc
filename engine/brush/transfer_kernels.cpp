// Compiled once per instruction set; see pastoso_add_kernels.
#include "brush/transfer_kernels.hpp"

#include "brush/cell_batch.hpp"
#include "brush/kernel_lanes.hpp"
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

/// The channels in groups of one register: one, two or four.
constexpr int kGroups = film::kPaintChannels / kLanes;

/// Sums modulo 2^32.
using WrappingLanes [[gnu::vector_size(4 * kLanes)]] = std::uint32_t;

/// For sums of single numbers: half as many as a register of 32 bits holds.
constexpr int kWideLanes = kLanes / 2;
using WideLanes [[gnu::vector_size(8 * kWideLanes)]] = std::uint64_t;

/// Heights of a bristle's hairs, told apart by their number because a table of sixteen can be looked
/// up within registers.
struct AnyHairs {
    const float* heights;

    PASTOSO_KERNEL_INLINE explicit AnyHairs(const ExchangeRule& rule) : heights(rule.hairs) {}
    PASTOSO_KERNEL_INLINE FloatLanes at(IntLanes index, FloatLanes share) const {
        FloatLanes found = {};
        for (int lane = 0; lane < kLanes; ++lane) {
            const float* low = heights + index[lane];
            found[lane] = low[0] + share[lane] * (low[1] - low[0]);
        }
        return found;
    }
};
struct SixteenHairs {
    static constexpr int kRegisters = 16 / kLanes;
    FloatLanes low[kRegisters], high[kRegisters];

    PASTOSO_KERNEL_INLINE explicit SixteenHairs(const ExchangeRule& rule) {
        for (int part = 0; part < kRegisters; ++part) {
            low[part] = load<FloatLanes>(rule.hairs + part * kLanes);
            high[part] = load<FloatLanes>(rule.hairs + 1 + part * kLanes);
        }
    }
    PASTOSO_KERNEL_INLINE static FloatLanes pick(const FloatLanes* table, IntLanes index) {
        FloatLanes found = shuffled(table[0], index);
        for (int part = 1; part < kRegisters; ++part)
            found = index >= part * kLanes ? shuffled(table[part], index) : found;
        return found;
    }
    PASTOSO_KERNEL_INLINE FloatLanes at(IntLanes index, FloatLanes share) const {
        const FloatLanes left = pick(low, index), right = pick(high, index);
        return left + share * (right - left);
    }
};

template <class Hairs>
PASTOSO_KERNEL_INLINE FloatLanes hairs_at(const Hairs& hairs, const ExchangeRule& rule, FloatLanes s) {
    const float half = 0.5F * static_cast<float>(rule.hairs_per_bristle);
    const float last = static_cast<float>(rule.hairs_per_bristle) - 0.001F;
    const FloatLanes place = smaller(larger(s * half + half, FloatLanes{}), all_lanes(last));
    const IntLanes index = as_ints(place);
    return hairs.at(index, place - as_floats(index));
}

/// What a register of cells is to gain and to swap.
struct Wanted {
    IntLanes change, swap;
};

template <bool kLane, class Hairs>
PASTOSO_KERNEL_INLINE Wanted wanted_at(const ExchangeRule& rule, const Hairs& hairs,
                                       const BatchColumns& batch, int i) {
    const auto dx = load<FloatLanes>(batch.dx_mm + i), dy = load<FloatLanes>(batch.dy_mm + i);
    const FloatLanes s = dx * rule.across_x + dy * rule.across_y;
    const FloatLanes t = dx * rule.along_x + dy * rule.along_y;
    const FloatLanes s2 = s * s, t2 = t * t, none = {};
    const FloatLanes radius2 = kLane ? t2 : s2 + t2;
    const FloatLanes core = larger(none, 1.0F - radius2 * radius2);
    const FloatLanes weight = kLane ? core * larger(none, 1.0F - (s < none ? -s : s)) : core;

    const auto quanta = load<IntLanes>(batch.thickness + i), found = load<IntLanes>(batch.found + i);
    const FloatLanes h = as_floats(quanta) * kQuantum_mm;
    const FloatLanes wanted = rule.underside_mm + rule.groove_mm * (s2 + kGrooveRise) +
                              rule.hair_mm * hairs_at(hairs, rule, s);
    const FloatLanes surface = load<FloatLanes>(batch.support_mm + i) + h;
    const FloatLanes gap = wanted - surface;
    const FloatLanes reached = larger((surface - rule.lowest_mm) * rule.fade_per_mm, none);
    const FloatLanes share = rule.rate * weight * smaller(reached, all_lanes(1.0F));

    const FloatLanes given = smaller(share * gap, all_lanes(kMost_mm));
    const FloatLanes taken = larger(share * gap * rule.pickup, -kLargestBite * h);
    const IntLanes change = as_ints((gap > none ? given : taken) * kQuantaPerMm);
    const IntLanes capacity_left = larger(IntLanes{}, film::kMaxThickness_quanta - quanta);
    const FloatLanes ground = as_floats(smaller(quanta, found)) * kQuantum_mm;
    const FloatLanes swap_mm = rule.mix * share * smaller(ground, all_lanes(rule.mix_depth_mm));
    return {smaller(change, capacity_left),
            as_ints((capacity_left > 0 ? swap_mm : none) * kQuantaPerMm)};
}

/// Adds numbers that are not negative to sums wide enough for all of them.
PASTOSO_KERNEL_INLINE void add_to(WideLanes& sums, IntLanes numbers) {
    const auto pairs = reinterpret_cast<WideLanes>(numbers);
    sums += (pairs & 0xFFFFFFFFU) + (pairs >> 32);
}

PASTOSO_KERNEL_INLINE std::int64_t total(WideLanes sums) {
    std::uint64_t sum = 0;
    for (int lane = 0; lane < kWideLanes; ++lane)
        sum += sums[lane];
    return static_cast<std::int64_t>(sum);
}

template <bool kLane, class Hairs>
PASTOSO_KERNEL_INLINE WantedSums plan_batch(const ExchangeRule& rule, const BatchColumns& batch) {
    const Hairs hairs(rule);
    WideLanes deposit = {}, swap = {};
    for (int i = 0; i < batch.padded_count; i += kLanes) {
        const Wanted wanted = wanted_at<kLane>(rule, hairs, batch, i);
        store(batch.change + i, wanted.change);
        store(batch.swap + i, wanted.swap);
        add_to(deposit, larger(wanted.change, IntLanes{}));
        add_to(swap, wanted.swap);
    }
    return {total(deposit), total(swap)};
}

/// Numbers in [0, 1) that are spread evenly over neighbouring cells: roundings with them have no bias.
PASTOSO_KERNEL_INLINE FloatLanes dither(IntLanes cell, std::uint32_t seed) {
    const auto scattered = reinterpret_cast<WrappingLanes>(cell) * 0x9E3779B9U + seed;
    return as_floats(reinterpret_cast<IntLanes>(scattered >> 8)) * 0x1p-24F;
}

/// Sums of the channels' changes over up to 2^15 cells. A sum S comes from that of the upper halves,
/// H = sum floor(c / 2^16), and from S modulo 2^32: S - 2^16 H, the sum of the lower halves, is less.
constexpr int kHalfBits = 16;
struct ChannelSums {
    WrappingLanes whole[kGroups] = {};
    IntLanes upper[kGroups] = {};

    PASTOSO_KERNEL_INLINE void add(int group, IntLanes change) {
        whole[group] += reinterpret_cast<WrappingLanes>(change);
        upper[group] += change >> kHalfBits;
    }
    PASTOSO_KERNEL_INLINE void add_to(std::array<std::int64_t, film::kPaintChannels>& sums) const {
        alignas(64) std::uint32_t wholes[film::kPaintChannels];
        alignas(64) std::int32_t uppers[film::kPaintChannels];
        for (int group = 0; group < kGroups; ++group) {
            store(wholes + group * kLanes, whole[group]);
            store(uppers + group * kLanes, upper[group]);
        }
        for (int k = 0; k < film::kPaintChannels; ++k) {
            const std::int64_t high = std::int64_t{uppers[k]} * (1 << kHalfBits);
            sums[k] += high + static_cast<std::uint32_t>(wholes[k] - static_cast<std::uint32_t>(high));
        }
    }
};

/// `out_share` of a cell's pigment, rounded.
PASTOSO_KERNEL_INLINE IntLanes leaving(IntLanes held, float out_share, float rounding) {
    return smaller(as_ints(as_floats(held) * out_share + rounding), held);
}

/// The tool's pigment in `gained` thickness quanta, rounded, as far as it fits on top of `held`.
PASTOSO_KERNEL_INLINE IntLanes coming(FloatLanes given, float gained, float rounding, IntLanes held) {
    return smaller(as_ints(given * gained + rounding), kMostPigment - held);
}

/// What happens to a few cells, worked out for all of them at once before their pigment is touched.
constexpr int kChunk = 64;
static_assert(kChunk % kBatchStep == 0);
struct CellChanges {
    std::int32_t thickness[kChunk];
    float out_share[kChunk];  ///< of the cell's pigment
    float gained[kChunk];     ///< thickness quanta of the tool's paint
    float rounding[kChunk];
};

/// The cells of one kind, in order.
struct CellList {
    std::int32_t cells[kChunk + kLanes];
    int count = 0;

    PASTOSO_KERNEL_INLINE void add(IntLanes numbers, IntLanes chosen) {
        count += store_chosen(cells + count, numbers, chosen);
    }
};
/// Cells that only gain paint, that only lose some, and those where paint goes both ways. Apart, since
/// the first two take half the work.
struct CellLists {
    CellList gaining, losing, swapping;
};

PASTOSO_KERNEL_INLINE void settle_change(const ApplyRule& rule, const TileCells& cells, int first,
                                         int count, int i, CellChanges& changes, CellLists& lists) {
    const IntLanes none = {}, one = none + 1;
    const auto h = load<IntLanes>(cells.held + first + i);
    const auto wanted = load<IntLanes>(cells.change + first + i);
    const IntLanes scaled = as_ints(as_floats(wanted) * rule.deposit_scale);
    const IntLanes fitting = wanted > none ? scaled : wanted;
    const IntLanes change = (fitting != none) & (h + fitting < kTraceQuanta) ? -h : fitting;
    const IntLanes swap = as_ints(as_floats(load<IntLanes>(cells.swap + first + i)) * rule.swap_scale);
    const FloatLanes share = as_floats(swap + larger(-change, none)) / as_floats(larger(h, one));
    store(changes.thickness + i, change);
    store(changes.out_share + i, smaller(share, all_lanes(1.0F)));
    store(changes.gained + i, as_floats(swap + larger(change, none)));
    store(changes.rounding + i, dither(load<IntLanes>(cells.cell + first + i), rule.dither_seed));
    const IntLanes number = load<IntLanes>(kCounting) + i;
    lists.gaining.add(number, (swap == none) & (change > none) & (number < count));
    lists.losing.add(number, (swap == none) & (change < none) & (number < count));
    lists.swapping.add(number, (swap != none) & (number < count));
}

/// Moves the thickness of the listed cells, and their pigment by pigment(i, emptied, group, held), the
/// change of a register of channels.
template <class Pigment>
PASTOSO_KERNEL_INLINE void change_cells(const TileCells& cells, int first, const CellList& list,
                                        const CellChanges& changes, ChangeSums& sums, ChannelSums& gains,
                                        const Pigment& pigment) {
    std::int64_t gained = 0;
    for (int n = 0; n < list.count; ++n) {
        const int i = list.cells[n];
        const std::int32_t cell = cells.cell[first + i];
        const std::int32_t thickness = cells.held[first + i] + changes.thickness[i];
        gained += changes.thickness[i];
        cells.thickness[cell] = thickness;
        std::int32_t* channels = cells.paint[cell].data();
        for (int group = 0; group < kGroups; ++group) {
            const auto held = load<IntLanes>(channels + group * kLanes);
            const IntLanes change = thickness == 0 ? -held : pigment(i, group, held);
            store(channels + group * kLanes, held + change);
            gains.add(group, change);
        }
    }
    sums.thickness += gained;
}

/// Moves the thickness and the pigment of up to kChunk cells.
PASTOSO_KERNEL_INLINE void apply_chunk(const ApplyRule& rule, const TileCells& cells, int first,
                                       int count, ChangeSums& sums) {
    CellChanges changes;
    // Whole registers: a few cells of the next part or of the padding are worked out in vain.
    CellLists lists;
    for (int i = 0; i < count; i += kLanes)
        settle_change(rule, cells, first, count, i, changes, lists);
    FloatLanes given[kGroups];
    for (int group = 0; group < kGroups; ++group)
        given[group] = load<FloatLanes>(rule.given.data() + group * kLanes);
    ChannelSums gains;
    change_cells(
        cells, first, lists.gaining, changes, sums,
        gains, [&](int i, int group, IntLanes held) __attribute__((always_inline)) {
            return coming(given[group], changes.gained[i], changes.rounding[i], held);
        });
    change_cells(
        cells, first, lists.losing, changes, sums,
        gains, [&](int i, int, IntLanes held) __attribute__((always_inline)) {
            return -leaving(held, changes.out_share[i], changes.rounding[i]);
        });
    change_cells(
        cells, first, lists.swapping, changes, sums,
        gains, [&](int i, int group, IntLanes held) __attribute__((always_inline)) {
            const IntLanes out = leaving(held, changes.out_share[i], changes.rounding[i]);
            return coming(given[group], changes.gained[i], changes.rounding[i], held - out) - out;
        });
    sums.any = sums.any || lists.gaining.count + lists.losing.count + lists.swapping.count > 0;
    gains.add_to(sums.paint);
}

}  // namespace

WantedSums plan(const ExchangeRule& rule, const BatchColumns& batch) {
    if (rule.hairs_per_bristle == 16) {
        return rule.lane ? plan_batch<true, SixteenHairs>(rule, batch)
                         : plan_batch<false, SixteenHairs>(rule, batch);
    }
    return rule.lane ? plan_batch<true, AnyHairs>(rule, batch)
                     : plan_batch<false, AnyHairs>(rule, batch);
}

void apply(const ApplyRule& rule, const TileCells& cells, ChangeSums& sums) {
    for (int first = 0; first < cells.count; first += kChunk)
        apply_chunk(rule, cells, first, smaller(kChunk, cells.count - first), sums);
}

}  // namespace pastoso::brush::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::brush, TransferKernels, plan, apply)
