// Compiled once per instruction set; see pastoso_add_kernels.
#include "brush/transfer_kernels.hpp"

#include "brush/cell_batch.hpp"
#include "brush/lane_weight.hpp"
#include "core/lane_memory.hpp"
#include "film/state.hpp"

#include <limits>

namespace pastoso::brush::PASTOSO_ISA {
namespace {

namespace lanes = core::lanes;

using Floats = lanes::Widest<float>;
using Ints = lanes::As<std::int32_t, Floats>;
constexpr int kLanes = Floats::kLanes;

constexpr auto kQuantum_mm = static_cast<float>(film::kThicknessQuantum_mm);
constexpr auto kQuantaPerMm = static_cast<float>(1.0 / film::kThicknessQuantum_mm);
constexpr auto kMost_mm = static_cast<float>(film::kMaxThickness_mm);
/// What a channel can count.
constexpr std::int32_t kMostPigment = std::numeric_limits<std::int32_t>::max();
/// A tool takes at most this share of a cell's paint in one step.
constexpr float kLargestBite = 0.9F;
/// A film thinner than 10 nm is not left behind: it would be invisible and keep cells wet for ever.
constexpr std::int32_t kNegligibleQuanta = 336;

/// The channels in groups of one register: one, two or four.
constexpr int kGroups = film::kPaintChannels / kLanes;

/// Sums modulo 2^32.
using Wrapping = lanes::As<std::uint32_t, Floats>;

/// For sums of single numbers: half as many as a register of 32 bits holds.
using Wide = lanes::Widest<std::uint64_t>;

/// A bristle's profile, told apart by its segments because a table of sixteen can be looked up within
/// registers.
struct AnyProfile {
    const float* heights;

    PASTOSO_LANE_MEMBER explicit AnyProfile(const ExchangeRule& rule) : heights(rule.profile) {}
    PASTOSO_LANE_MEMBER Floats at(Ints index, Floats share) const {
        return lanes::generate<Floats>([&](int lane) {
            const float* low = heights + index[lane];
            return low[0] + share[lane] * (low[1] - low[0]);
        });
    }
};
struct SixteenSegments {
    static constexpr int kRegisters = 16 / kLanes;
    Floats low[kRegisters], high[kRegisters];

    PASTOSO_LANE_MEMBER explicit SixteenSegments(const ExchangeRule& rule) {
        for (int part = 0; part < kRegisters; ++part) {
            low[part] = lanes::load<Floats>(rule.profile + part * kLanes);
            high[part] = lanes::load<Floats>(rule.profile + 1 + part * kLanes);
        }
    }
    PASTOSO_LANE_MEMBER static Floats pick(const Floats* table, Ints index) {
        Floats found = lanes::shuffled(table[0], index);
        for (int part = 1; part < kRegisters; ++part)
            found = lanes::select(index >= part * kLanes, lanes::shuffled(table[part], index), found);
        return found;
    }
    PASTOSO_LANE_MEMBER Floats at(Ints index, Floats share) const {
        const Floats left = pick(low, index), right = pick(high, index);
        return left + share * (right - left);
    }
};

template <class Profile>
PASTOSO_LANE_FUNCTION Floats profile_at(const Profile& profile, const ExchangeRule& rule, Floats s) {
    const float half = 0.5F * static_cast<float>(rule.segments);
    const float last = static_cast<float>(rule.segments) - 0.001F;
    const Floats place = lanes::min(lanes::max(s * half + half, Floats(0.0F)), Floats(last));
    const Ints index = lanes::convert<std::int32_t>(place);
    return profile.at(index, place - lanes::convert<float>(index));
}

/// The part of a share that an element closes at s across its lane.
PASTOSO_LANE_FUNCTION Floats lane_part(const ExchangeRule& rule, Floats closed, Floats s) {
    const Floats weight = lane_weight(s, rule.lane_core);
    return rule.side_by_side ? lane_share(closed, weight) : closed * weight;
}

/// What a register of cells is to gain and to swap.
struct Wanted {
    Ints change, swap;
    Floats touched;
};

template <bool kLane, class Profile>
PASTOSO_LANE_FUNCTION Wanted wanted_at(const ExchangeRule& rule, const Profile& profile,
                                       const BatchColumns& batch, int i) {
    const auto dx = lanes::load<Floats>(batch.dx_mm + i), dy = lanes::load<Floats>(batch.dy_mm + i);
    const Floats s = dx * rule.across_x + dy * rule.across_y;
    const Floats t = dx * rule.along_x + dy * rule.along_y;
    const Floats s2 = s * s, t2 = t * t, none(0.0F);
    const Floats radius2 = kLane ? t2 : s2 + t2;
    const Floats weight = lanes::max(none, 1.0F - radius2) * (1.0F + rule.crown * radius2);

    const auto quanta = lanes::load<Ints>(batch.thickness + i);
    const Ints found = found_thickness(lanes::load<Ints>(batch.found + i));
    const Floats h = lanes::convert<float>(quanta) * kQuantum_mm;
    const auto support = lanes::load<Floats>(batch.support_mm + i);
    const Floats wanted = rule.underside_mm + rule.profile_mm * profile_at(profile, rule, s) -
                          rule.coat * (rule.bearing_mm - support);
    const Floats surface = support + h;
    const Floats gap = wanted - surface;
    const Floats reached = lanes::max((surface - rule.lowest_mm) * rule.fade_per_mm, none);
    const Floats touched = lanes::min(reached, Floats(1.0F));
    const Floats closed = rule.rate * weight * touched;
    const Floats share = kLane ? lane_part(rule, closed, s) : closed;

    const Floats covered =
        lanes::min(weight * rule.cover, Floats(1.0F)) * (1.0F - rule.coat * (1.0F - touched));
    const Floats missing = covered * (gap + h) - h;
    const Floats given = lanes::min(share * lanes::max(missing, none), Floats(kMost_mm));
    const Floats taken = lanes::max(share * gap * rule.pickup, -kLargestBite * h);
    const Ints change =
        lanes::convert<std::int32_t>(lanes::select(gap > none, given, taken) * kQuantaPerMm);
    const Ints capacity_left = lanes::max(Ints(0), film::kMaxThickness_quanta - quanta);
    const Floats ground = lanes::convert<float>(lanes::min(quanta, found)) * kQuantum_mm;
    const Floats swap_mm = rule.mix * share * lanes::min(ground, Floats(rule.mix_depth_mm));
    return {lanes::min(change, capacity_left),
            lanes::convert<std::int32_t>(lanes::select(capacity_left > 0, swap_mm, none) * kQuantaPerMm),
            share};
}

/// Adds numbers that are not negative to sums wide enough for all of them.
PASTOSO_LANE_FUNCTION void add_to(Wide& sums, Ints numbers) {
    const auto pairs = lanes::bits<std::uint64_t>(numbers);
    sums += (pairs & 0xFFFFFFFFU) + (pairs >> 32);
}

PASTOSO_LANE_FUNCTION std::int64_t total(Wide sums) {
    std::uint64_t sum = 0;
    for (int lane = 0; lane < Wide::kLanes; ++lane)
        sum += sums[lane];
    return static_cast<std::int64_t>(sum);
}

/// Cells that gain paint on enough of what the pass found, with hardly any of the stroke's own, and for
/// which it isn't settled yet whether that is buried. At the front of a thick stroke paint flows onto
/// what was found, up to as much again between touches.
PASTOSO_LANE_FUNCTION Ints::MaskOf may_be_buried(Ints held, Ints found, Ints change, Ints swap) {
    return held - found < film::kLeastStratum_quanta + found &&
           lanes::min(held, found) >= film::kLeastStratum_quanta && lanes::max(change, swap) > Ints(0);
}

template <bool kLane, class Profile>
PASTOSO_LANE_FUNCTION WantedSums plan_batch(const ExchangeRule& rule, const BatchColumns& batch) {
    const Profile profile(rule);
    Wide deposit(0), swap(0);
    Ints moved(0);
    Floats touched(0.0F);
    Ints::MaskOf buries = Ints(0) > Ints(0);
    for (int i = 0; i < batch.padded_count; i += kLanes) {
        const Wanted wanted = wanted_at<kLane>(rule, profile, batch, i);
        buries = buries || may_be_buried(lanes::load<Ints>(batch.thickness + i),
                                         lanes::load<Ints>(batch.found + i), wanted.change, wanted.swap);
        lanes::store(batch.change + i, wanted.change);
        lanes::store(batch.swap + i, wanted.swap);
        lanes::store(batch.touched + i, wanted.touched);
        add_to(deposit, lanes::max(wanted.change, Ints(0)));
        add_to(swap, wanted.swap);
        moved = moved | wanted.change | wanted.swap;
        touched = lanes::max(touched, wanted.touched);
    }
    return {total(deposit), total(swap), lanes::any(buries), lanes::any(moved != Ints(0)),
            lanes::any(touched > Floats(0.0F))};
}

/// Numbers in [0, 1) that are spread evenly over neighbouring cells: roundings with them have no bias.
PASTOSO_LANE_FUNCTION Floats dither(Ints cell, std::uint32_t seed) {
    const auto scattered = lanes::bits<std::uint32_t>(cell) * 0x9E3779B9U + seed;
    return lanes::convert<float>(lanes::bits<std::int32_t>(scattered >> 8)) * 0x1p-24F;
}

/// Sums of the channels' changes over up to 2^15 cells. A sum S comes from that of the upper halves,
/// H = sum floor(c / 2^16), and from S modulo 2^32: S - 2^16 H, the sum of the lower halves, is less.
constexpr int kHalfBits = 16;
struct ChannelSums {
    Wrapping whole[kGroups] = {};
    Ints upper[kGroups] = {};

    PASTOSO_LANE_MEMBER void add(int group, Ints change) {
        whole[group] += lanes::bits<std::uint32_t>(change);
        upper[group] += change >> kHalfBits;
    }
    PASTOSO_LANE_MEMBER void add_to(std::array<std::int64_t, film::kPaintChannels>& sums) const {
        alignas(64) std::uint32_t wholes[film::kPaintChannels];
        alignas(64) std::int32_t uppers[film::kPaintChannels];
        for (int group = 0; group < kGroups; ++group) {
            lanes::store(wholes + group * kLanes, whole[group]);
            lanes::store(uppers + group * kLanes, upper[group]);
        }
        for (int k = 0; k < film::kPaintChannels; ++k) {
            const std::int64_t high = std::int64_t{uppers[k]} * (1 << kHalfBits);
            sums[k] += high + static_cast<std::uint32_t>(wholes[k] - static_cast<std::uint32_t>(high));
        }
    }
};

/// `out_share` of a cell's pigment, rounded.
PASTOSO_LANE_FUNCTION Ints leaving(Ints held, float out_share, float rounding) {
    return lanes::min(lanes::convert<std::int32_t>(lanes::convert<float>(held) * out_share + rounding),
                      held);
}

/// The tool's pigment in `gained` thickness quanta, rounded, as far as it fits on top of `held`.
PASTOSO_LANE_FUNCTION Ints coming(Floats given, float gained, float rounding, Ints held) {
    return lanes::min(lanes::convert<std::int32_t>(given * gained + rounding), kMostPigment - held);
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
};

/// The cells of one kind, in order.
struct CellList {
    std::int32_t cells[kChunk + kLanes];
    int count = 0;

    PASTOSO_LANE_MEMBER void add(Ints numbers, Ints::MaskOf chosen) {
        count += lanes::store_compressed(cells + count, numbers, chosen);
    }
};
/// Cells that only gain paint, that only lose some, and those where paint goes both ways. Apart, since
/// the first two take half the work.
struct CellLists {
    CellList gaining, losing, swapping;
};

PASTOSO_LANE_FUNCTION void settle_change(const ApplyRule& rule, const TileCells& cells, int first, int i,
                                         CellChanges& changes) {
    const Ints none(0), one(1);
    const auto h = lanes::load<Ints>(cells.held + first + i);
    const auto wanted = lanes::load<Ints>(cells.change + first + i);
    const Ints scaled = lanes::convert<std::int32_t>(lanes::convert<float>(wanted) * rule.deposit_scale);
    const Ints fitting = lanes::select(wanted > none, scaled, wanted);
    const Ints change = lanes::select(fitting != none && h + fitting < kNegligibleQuanta, -h, fitting);
    const Ints swap = lanes::convert<std::int32_t>(
        lanes::convert<float>(lanes::load<Ints>(cells.swap + first + i)) * rule.swap_scale);
    const Floats share = lanes::convert<float>(swap + lanes::max(-change, none)) /
                         lanes::convert<float>(lanes::max(h, one));
    lanes::store(changes.thickness + i, change);
    lanes::store(changes.swap + i, swap);
    lanes::store(changes.out_share + i, lanes::min(share, Floats(1.0F)));
    lanes::store(changes.gained + i, lanes::convert<float>(swap + lanes::max(change, none)));
    lanes::store(changes.rounding + i,
                 dither(lanes::load<Ints>(cells.cell + first + i), rule.dither_seed));
}

/// Puts a register of cells of one stratum on the lists.
PASTOSO_LANE_FUNCTION void list_cells(int count, int i, const CellChanges& changes, CellLists& lists) {
    const Ints none(0), number = lanes::counting<Ints>() + i;
    const auto change = lanes::load<Ints>(changes.thickness + i);
    const auto swap = lanes::load<Ints>(changes.swap + i);
    lists.gaining.add(number, swap == none && change > none && number < count);
    lists.losing.add(number, swap == none && change < none && number < count);
    lists.swapping.add(number, swap != none && number < count);
}

/// Whatever a tool touches in a cell, it shears all of it.
PASTOSO_LANE_FUNCTION void set_thickness(const TileCells& cells, int cell, std::int32_t thickness) {
    cells.thickness[cell] = thickness;
    if (cells.worked != nullptr) cells.worked[cell] = thickness;
}

/// Moves the thickness of the listed cells, and their pigment by pigment(i, emptied, group, held), the
/// change of a register of channels.
template <class Pigment>
PASTOSO_LANE_FUNCTION void change_cells(const TileCells& cells, int first, const CellList& list,
                                        const CellChanges& changes, ChangeSums& sums, ChannelSums& gains,
                                        const Pigment& pigment) {
    std::int64_t gained = 0;
    for (int n = 0; n < list.count; ++n) {
        const int i = list.cells[n];
        const std::int32_t cell = cells.cell[first + i];
        const std::int32_t thickness = cells.held[first + i] + changes.thickness[i];
        gained += changes.thickness[i];
        set_thickness(cells, cell, thickness);
        std::int32_t* channels = cells.paint[cell].data();
        for (int group = 0; group < kGroups; ++group) {
            const auto held = lanes::load<Ints>(channels + group * kLanes);
            const Ints change = thickness == 0 ? -held : pigment(i, group, held);
            lanes::store(channels + group * kLanes, held + change);
            gains.add(group, change);
        }
    }
    sums.thickness += gained;
}

/// The tool's paint, a register of channels each.
struct GivenPaint {
    Floats per_quantum[kGroups];
    Floats least[kGroups];  ///< of what comes, for a channel to tell colours apart

    /// A channel of pigment that is not given is one that too little is left of, unless none is.
    PASTOSO_LANE_MEMBER explicit GivenPaint(const ApplyRule& rule) {
        constexpr float kNever = std::numeric_limits<float>::infinity();
        bool is_clear = true;
        for (int g = 0; g < kGroups; ++g) {
            per_quantum[g] = lanes::load<Floats>(rule.given.data() + g * kLanes);
            is_clear = is_clear && !lanes::any(is_colour(g) && per_quantum[g] > Floats(0.0F));
        }
        for (int g = 0; g < kGroups; ++g)
            least[g] = lanes::select(is_colour(g), Floats(is_clear ? -1.0F : 0.0F), Floats(kNever));
    }
    PASTOSO_LANE_MEMBER static Ints::MaskOf is_colour(int group) {
        return lanes::counting<Ints>() + group * kLanes < film::kPigmentChannels;
    }
};

/// Paints are told apart by more than what looks alike (film::looks_like_one): else a film of
/// micrometres, whose weakest channels are a few quanta, would be another paint than what it was laid
/// with.
constexpr float kOtherShare = 1.5F * film::kLikeShare;
constexpr auto kOtherColour_quanta = static_cast<float>(4 * film::kNoColour / film::kPaintQuantum);

/// Whether `gained` quanta of the tool's paint are of another colour than as much, the share `part`, of
/// what lies above `lower`: by more than kOtherShare of the more and than kOtherColour_quanta.
PASTOSO_LANE_FUNCTION bool is_other(const GivenPaint& given, const std::int32_t* whole,
                                    const std::int32_t* lower, float part, float gained) {
    const Floats unseen(kOtherColour_quanta * part);
    bool any = false;
    for (int g = 0; g < kGroups; ++g) {
        Ints above = lanes::load<Ints>(whole + g * kLanes);
        if (lower != nullptr) above = above - lanes::load<Ints>(lower + g * kLanes);
        const Floats here = lanes::convert<float>(above) * part;
        const Floats coming = given.per_quantum[g] * gained;
        const Floats apart = lanes::max(here - coming, coming - here);
        const auto other = apart > lanes::max(lanes::max(here, coming) * kOtherShare, unseen);
        any |= lanes::any(other && coming > given.least[g]);
    }
    return any;
}

/// Whether the tool's paint differs from the upper of two strata by more than half of what they differ
/// by: else it is nearer to the upper one, which a tip that took up a little of the lower is too.
PASTOSO_LANE_FUNCTION bool is_third(const GivenPaint& given, const std::int32_t* whole,
                                    const std::int32_t* lower, std::int32_t upper_quanta,
                                    std::int32_t lower_quanta) {
    const float per_upper = 1.0F / static_cast<float>(upper_quanta);
    const float per_lower = 1.0F / static_cast<float>(lower_quanta);
    float from_upper = 0.0F, between = 0.0F;
    for (int g = 0; g < kGroups; ++g) {
        const auto below = lanes::load<Ints>(lower + g * kLanes);
        const Ints above = lanes::load<Ints>(whole + g * kLanes) - below;
        const Floats upper = lanes::convert<float>(above) * per_upper;
        const Floats apart = upper - lanes::convert<float>(below) * per_lower;
        const Floats none(0.0F), far = lanes::abs(given.per_quantum[g] - upper);
        from_upper =
            lanes::max(from_upper, lanes::largest(lanes::select(given.is_colour(g), far, none)));
        between = lanes::max(between,
                             lanes::largest(lanes::select(given.is_colour(g), lanes::abs(apart), none)));
    }
    return from_upper > 0.5F * between;
}

PASTOSO_LANE_FUNCTION Ints gain_of(const CellChanges& changes, int i) {
    return lanes::load<Ints>(changes.swap + i) +
           lanes::max(lanes::load<Ints>(changes.thickness + i), Ints(0));
}

/// Of a tile's cells from `i` on.
PASTOSO_LANE_FUNCTION Ints::MaskOf may_be_buried(const TileCells& cells, int i) {
    return may_be_buried(lanes::load<Ints>(cells.held + i), lanes::load<Ints>(cells.found + i),
                         lanes::load<Ints>(cells.change + i), lanes::load<Ints>(cells.swap + i)) &&
           lanes::counting<Ints>() + i < cells.count;
}

/// What comes as a share of what it comes onto where that, one of the `open` cells, is to lie below it
/// if it is of another colour; else 0. A cell has two strata at most: over two of them only what will
/// hide both makes one of them, and comes to lie above.
PASTOSO_LANE_FUNCTION Floats covering_share(const ApplyRule& rule, const TileCells& cells,
                                            Ints::MaskOf open, int first, int i, Ints lower,
                                            const CellChanges& changes) {
    const Ints gained = gain_of(changes, i);
    const Floats coming = lanes::convert<float>(gained);
    const auto held = lanes::load<Ints>(cells.held + first + i);
    const auto touched = lanes::load<Floats>(cells.touched + first + i);
    const auto hides = lower == Ints(0) || coming >= touched * rule.hiding_quanta;
    return lanes::select(gained >= film::kLostStratum_quanta && open && hides,
                         coming / lanes::convert<float>(held - lower), Floats(0.0F));
}

PASTOSO_LANE_FUNCTION Floats ratio(Ints part, Ints whole) {
    return lanes::min(lanes::convert<float>(part) / lanes::convert<float>(lanes::max(whole, Ints(1))),
                      Floats(1.0F));
}

/// What happens to the strata of a few cells: the shares of their pigment that leave, and what the lower
/// one is made of afterwards.
struct StrataChanges {
    std::int32_t after[kChunk];  ///< thickness of the lower one; 0: the cell's paint is one
    float out_above[kChunk], out_below[kChunk];
    float of_above[kChunk], of_below[kChunk];  ///< shares of what the strata held
    float of_tool[kChunk];                     ///< thickness quanta of the tool's paint
};

/// Keeps what leaves both strata, and what a stir then makes of the lower one: it gives away the share m
/// of itself that the upper one is of the cell, and gets as much back.
PASTOSO_LANE_FUNCTION void keep_strata(const ApplyRule& rule, Floats touched, Ints upper, Ints lower,
                                       Floats out_above, Floats out_below, Ints gained, int i,
                                       StrataChanges& strata) {
    const Floats one(1.0F), mixing = lanes::min(touched * rule.depth, one);
    const Floats above = ratio(upper, upper + lower);
    const Floats sinks = mixing * (one - above);
    const auto two = lanes::min(upper, lower) >= film::kLostStratum_quanta;
    lanes::store(strata.after + i, lanes::select(two, lower, Ints(0)));
    lanes::store(strata.out_above + i, out_above);
    lanes::store(strata.out_below + i, out_below);
    lanes::store(strata.of_above + i, (one - out_above) * sinks);
    lanes::store(strata.of_below + i, (one - out_below) * (one - mixing * above));
    lanes::store(strata.of_tool + i, lanes::convert<float>(gained) * sinks);
}

/// Of cells whose lower strata are `lower` thick. Without any, all that leaves comes from the upper.
PASTOSO_LANE_FUNCTION void settle_strata(const ApplyRule& rule, const TileCells& cells, int first, int i,
                                         Ints lower, const CellChanges& changes, StrataChanges& strata) {
    const auto held = lanes::load<Ints>(cells.held + first + i);
    const auto change = lanes::load<Ints>(changes.thickness + i);
    const auto swap = lanes::load<Ints>(changes.swap + i);
    const Ints upper = held - lower, gained = gain_of(changes, i), taken = gained - change;
    const Ints lost = taken - swap;
    const Floats lost_first = lanes::convert<float>(lanes::min(lost, upper));
    const Floats share = ratio(upper, held);
    const Floats lost_evenly = lanes::convert<float>(lost) * share;
    const Ints wanted = lanes::convert<std::int32_t>(
        lost_first + (lost_evenly - lost_first) * rule.depth + lanes::convert<float>(swap) * share);
    const Ints from_upper = lanes::min(lanes::max(wanted, taken - lower), lanes::min(upper, taken));
    const Ints from_lower = taken - from_upper;
    keep_strata(rule, lanes::load<Floats>(cells.touched + first + i), upper - from_upper + gained,
                lower - from_lower, ratio(from_upper, upper), ratio(from_lower, lower), gained, i,
                strata);
}

/// Of cells whose paint comes to lie below what they gain.
PASTOSO_LANE_FUNCTION void settle_covered(const ApplyRule& rule, const TileCells& cells, int first,
                                          int i, const CellChanges& changes, StrataChanges& strata) {
    const Ints gained = gain_of(changes, i);
    const Ints rest =
        lanes::load<Ints>(cells.held + first + i) + lanes::load<Ints>(changes.thickness + i) - gained;
    keep_strata(rule, lanes::load<Floats>(cells.touched + first + i), gained, rest, Floats(0.0F),
                lanes::load<Floats>(changes.out_share + i), gained, i, strata);
}

/// Of a few cells of a tile that has two strata somewhere.
struct TwoStrata {
    std::int32_t lower[kChunk];  ///< thickness; 0: the cell's paint is one
    std::int32_t is_covered[kChunk];
    StrataChanges as_they_lie, covered;
    CellList lying, covering;  ///< cells in which both strata change, or come to be two
};

/// A pass buries what it found in a cell once at most.
PASTOSO_LANE_FUNCTION void settle_pass(const TileCells& cells, int i) {
    if (cells.pass_found != nullptr) cells.pass_found[cells.cell[i]] = settled(cells.found[i]);
}

/// Finds the cells that are going to be covered. Each is looked at by itself, without a branch that the
/// processor could guess wrong: colours change from cell to cell.
PASTOSO_LANE_FUNCTION void find_covered(const ApplyRule& rule, const TileCells& cells,
                                        const LowerCells& tile, int first, int count,
                                        const GivenPaint& given, const CellChanges& changes,
                                        TwoStrata& two) {
    float shares[kChunk];
    CellList perhaps;
    for (int i = 0; i < count; i += kLanes) {
        const auto lower = lanes::gather(tile.thickness, lanes::load<Ints>(cells.cell + first + i));
        lanes::store(two.lower + i, lower);
        lanes::store(two.is_covered + i, Ints(0));
        const auto open = may_be_buried(cells, first + i);
        if (!lanes::any(open)) continue;
        const Floats share = covering_share(rule, cells, open, first, i, lower, changes);
        lanes::store(shares + i, share);
        perhaps.add(lanes::counting<Ints>() + i, share > Floats(0.0F));
    }
    for (int n = 0; n < perhaps.count; ++n) {
        const int i = perhaps.cells[n], cell = cells.cell[first + i];
        const std::int32_t *whole = cells.paint[cell].data(), *lower = tile.paint[cell].data();
        const std::int32_t below = two.lower[i];
        two.is_covered[i] =
            is_other(given, whole, lower, shares[i], changes.gained[i]) &&
            (below == 0 || is_third(given, whole, lower, cells.held[first + i] - below, below));
        settle_pass(cells, first + i);
    }
}

/// Puts a register of cells on the lists, each on one at most. Whoever only gains, does so on top.
PASTOSO_LANE_FUNCTION void list_cells(int count, int i, Floats stir, const CellChanges& changes,
                                      CellLists& plain, TwoStrata& two) {
    const Ints none(0), number = lanes::counting<Ints>() + i;
    const auto change = lanes::load<Ints>(changes.thickness + i);
    const auto swap = lanes::load<Ints>(changes.swap + i);
    const auto is_one = lanes::load<Ints>(two.lower + i) == none;
    const auto covered = lanes::load<Ints>(two.is_covered + i) != none;
    const auto stirred = !is_one && stir > Floats(0.0F);
    const auto here = number < count && !covered;
    const auto gains_only = swap == none && change > none && !stirred;
    plain.gaining.add(number, here && gains_only);
    plain.losing.add(number, here && is_one && swap == none && change < none);
    plain.swapping.add(number, here && is_one && swap != none);
    two.lying.add(number, here && !is_one && !gains_only && (swap != none || change != none || stirred));
    two.covering.add(number, covered);
}

/// Settles and lists the cells of a chunk.
PASTOSO_LANE_FUNCTION void settle_two(const ApplyRule& rule, const TileCells& cells, int first,
                                      int count, const CellChanges& changes, CellLists& plain,
                                      TwoStrata& two) {
    for (int i = 0; i < count; i += kLanes) {
        const auto lower = lanes::load<Ints>(two.lower + i);
        if (lanes::any(lower > Ints(0)))
            settle_strata(rule, cells, first, i, lower, changes, two.as_they_lie);
        if (lanes::any(lanes::load<Ints>(two.is_covered + i) != Ints(0)))
            settle_covered(rule, cells, first, i, changes, two.covered);
        list_cells(count, i, lanes::load<Floats>(cells.touched + first + i) * rule.depth, changes, plain,
                   two);
    }
}

/// Moves the paint of a cell with two strata, of which nothing is left where it is `bare`. Exact is the
/// whole; the lower stratum is some part of it.
template <bool kIsCovered>
PASTOSO_LANE_FUNCTION void change_strata(int i, const CellChanges& changes, const StrataChanges& strata,
                                         bool bare, const GivenPaint& given, std::int32_t* to_whole,
                                         std::int32_t* to_lower, ChannelSums& gains) {
    const bool two = strata.after[i] > 0;
    const float rounding = changes.rounding[i];
    for (int g = 0; g < kGroups; ++g, to_whole += kLanes, to_lower += kLanes) {
        const auto held = lanes::load<Ints>(to_whole);
        const Ints below = kIsCovered ? held : lanes::load<Ints>(to_lower);
        const Floats high = lanes::convert<float>(held - below), low = lanes::convert<float>(below);
        const Ints out = lanes::min(lanes::convert<std::int32_t>(high * strata.out_above[i] +
                                                                 low * strata.out_below[i] + rounding),
                                    held);
        const Ints left = held - out;
        const Ints after =
            bare ? Ints(0) : left + coming(given.per_quantum[g], changes.gained[i], rounding, left);
        const Ints lower =
            lanes::convert<std::int32_t>(high * strata.of_above[i] + low * strata.of_below[i] +
                                         given.per_quantum[g] * strata.of_tool[i] + 0.5F);
        lanes::store(to_whole, after);
        lanes::store(to_lower, two ? lanes::min(lower, after) : Ints(0));
        gains.add(g, after - held);
    }
}

template <bool kIsCovered>
PASTOSO_LANE_FUNCTION void change_listed(const TileCells& cells, const LowerCells& tile, int first,
                                         const CellList& list, const GivenPaint& given,
                                         const CellChanges& changes, const StrataChanges& strata,
                                         ChangeSums& sums, ChannelSums& gains) {
    std::int64_t gained = 0;
    for (int n = 0; n < list.count; ++n) {
        const int i = list.cells[n], cell = cells.cell[first + i];
        const std::int32_t thickness = cells.held[first + i] + changes.thickness[i];
        change_strata<kIsCovered>(i, changes, strata, thickness == 0, given, cells.paint[cell].data(),
                                  tile.paint[cell].data(), gains);
        set_thickness(cells, cell, thickness);
        tile.thickness[cell] = strata.after[i];
        gained += changes.thickness[i];
    }
    sums.thickness += gained;
    sums.any = sums.any || list.count > 0;
}

/// Lists the cells of a chunk, and changes those in which both strata change.
PASTOSO_LANE_FUNCTION void change_two(const ApplyRule& rule, const TileCells& cells,
                                      const LowerCells& tile, int first, int count,
                                      const GivenPaint& given, const CellChanges& changes,
                                      CellLists& plain, ChangeSums& sums, ChannelSums& gains) {
    TwoStrata two;
    find_covered(rule, cells, tile, first, count, given, changes, two);
    settle_two(rule, cells, first, count, changes, plain, two);
    change_listed<false>(cells, tile, first, two.lying, given, changes, two.as_they_lie, sums, gains);
    change_listed<true>(cells, tile, first, two.covering, given, changes, two.covered, sums, gains);
}

/// Moves the thickness and the pigment of up to kChunk cells.
PASTOSO_LANE_FUNCTION void apply_chunk(const ApplyRule& rule, const TileCells& cells,
                                       const LowerCells* lower, int first, int count, ChangeSums& sums) {
    CellChanges changes;
    // Whole registers: a few cells of the next part or of the padding are worked out in vain.
    CellLists lists;
    for (int i = 0; i < count; i += kLanes) {
        settle_change(rule, cells, first, i, changes);
        if (lower == nullptr) list_cells(count, i, changes, lists);
    }
    const GivenPaint given(rule);
    ChannelSums gains;
    if (lower != nullptr)
        change_two(rule, cells, *lower, first, count, given, changes, lists, sums, gains);
    change_cells(
        cells, first, lists.gaining, changes, sums,
        gains, [&](int i, int group, Ints held) __attribute__((always_inline)) {
            return coming(given.per_quantum[group], changes.gained[i], changes.rounding[i], held);
        });
    change_cells(
        cells, first, lists.losing, changes, sums,
        gains, [&](int i, int, Ints held) __attribute__((always_inline)) {
            return -leaving(held, changes.out_share[i], changes.rounding[i]);
        });
    change_cells(
        cells, first, lists.swapping, changes, sums,
        gains, [&](int i, int group, Ints held) __attribute__((always_inline)) {
            const Ints out = leaving(held, changes.out_share[i], changes.rounding[i]);
            return coming(given.per_quantum[group], changes.gained[i], changes.rounding[i], held - out) -
                   out;
        });
    sums.any = sums.any || lists.gaining.count + lists.losing.count + lists.swapping.count > 0;
    gains.add_to(sums.paint);
}

}  // namespace

bool meets_other(const ApplyRule& rule, const film::PaintCell* paint, const TileCells& cells) {
    const GivenPaint given(rule);
    CellChanges changes;
    float shares[kLanes];
    for (int i = 0; i < cells.count; i += kLanes) {
        const auto open = may_be_buried(cells, i);
        if (!lanes::any(open)) continue;
        settle_change(rule, cells, i, 0, changes);
        lanes::store(shares, covering_share(rule, cells, open, i, 0, Ints(0), changes));
        for (int n = 0; n < lanes::min(kLanes, cells.count - i); ++n) {
            const std::int32_t* whole = paint[cells.cell[i + n]].data();
            if (shares[n] <= 0.0F) continue;
            if (is_other(given, whole, nullptr, shares[n], changes.gained[n])) return true;
            settle_pass(cells, i + n);
        }
    }
    return false;
}

WantedSums plan(const ExchangeRule& rule, const BatchColumns& batch) {
    if (rule.segments == 16) {
        return rule.lane ? plan_batch<true, SixteenSegments>(rule, batch)
                         : plan_batch<false, SixteenSegments>(rule, batch);
    }
    return rule.lane ? plan_batch<true, AnyProfile>(rule, batch)
                     : plan_batch<false, AnyProfile>(rule, batch);
}

void apply(const ApplyRule& rule, const TileCells& cells, ChangeSums& sums) {
    for (int first = 0; first < cells.count; first += kChunk)
        apply_chunk(rule, cells, nullptr, first, lanes::min(kChunk, cells.count - first), sums);
}

void apply_strata(const ApplyRule& rule, const TileCells& cells, const LowerCells& lower,
                  ChangeSums& sums) {
    for (int first = 0; first < cells.count; first += kChunk)
        apply_chunk(rule, cells, &lower, first, lanes::min(kChunk, cells.count - first), sums);
}

}  // namespace pastoso::brush::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::brush, TransferKernels, plan, apply, meets_other, apply_strata)
