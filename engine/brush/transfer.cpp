#include "brush/transfer.hpp"

#include "brush/contents_kernels.hpp"
#include "brush/laid_film.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pastoso::brush {

namespace {

/// Path length after which a bristle has closed 1 - 1/e of the gap, in footprint radii. An edge that is
/// stiff leaves its own shape behind, as good as exactly.
constexpr double kClosingLength_radii = 0.8, kStiffClosingLength_radii = 0.25;
/// By how much less a bristle without body reaches than the thickest, in saturations.
constexpr float kThinBristleLoss = 0.6F, kThickestBody = 1.2F;
/// Keeps what a bristle among others covers finite.
constexpr float kLeastAlone = 1e-6F;
/// Keeps the fade of the contact finite.
constexpr float kLeastBead_mm = 1e-4F;
/// Shares of its load that an element gives in one step at most, by depositing and by swapping.
constexpr double kLargestDeposit = 0.5, kLargestKnifeDeposit = 0.7, kLargestSwap = 0.25;
/// How far down into two strata what is stiff reaches, against hairs.
constexpr float kStiffDepth = 0.1F;
constexpr float kBands = 0.5F * film::kPigmentChannels;
/// Less than this in a bristle counts as nothing.
constexpr double kEmpty_mm3 = 1e-6;

float square(float x) {
    return x * x;
}

/// How far paint hangs below an element: with little paint left, thin bristles lose touch first.
float bead_mm(const Brush& brush, const Bristle& bristle, float saturation, float press,
              const StepRates& rates) {
    const float weakness = brush.tip.rigid ? 0.0F : kThinBristleLoss * (kThickestBody - bristle.body);
    const float supply = std::max(0.0F, saturation - weakness * (1.0F - 0.7F * saturation));
    const float wetted = std::min(1.0F, supply / 0.2F);
    return kLeastBead_mm + wetted * (0.005F + 0.05F * press) +
           1.2F * rates.reach * rates.film_mm * square(supply);
}

/// How much of its film an element leaves; what absorbs leaves a stain of that thickness.
float saturation_of(const Brush& brush, double held_mm3, const StepRates& rates) {
    if (brush.preset.exchange.absorbs) return 1.0F;
    return saturation(static_cast<float>(held_mm3 * rates.per_capacity_mm3));
}

float mix_of(const Brush& brush, const Contact& contact) {
    return (1.0F - contact.ride) * static_cast<float>(brush.preset.exchange.mix);
}

/// The axes of an element's footprint, divided by its half sizes.
void set_axes(const Brush& brush, const Contact& contact, const StepRates& rates, ExchangeRule& rule) {
    rule.lane = brush.tip.rigid;
    rule.across_x = static_cast<float>(contact.across_x * rates.across_per_mm);
    rule.across_y = static_cast<float>(contact.across_y * rates.across_per_mm);
    rule.along_x = static_cast<float>(-contact.across_y * rates.along_per_mm);
    rule.along_y = static_cast<float>(contact.across_x * rates.along_per_mm);
}

/// Scale that brings what is wanted down to what there is.
float scale_to(double available, std::int64_t wanted) {
    return static_cast<double>(wanted) > available
               ? static_cast<float>(available / static_cast<double>(wanted))
               : 1.0F;
}

/// The held paint as carried quanta per thickness quantum. A negligible amount, which the roundings up
/// in all cells could overdraw, stays where it is.
film::PaintCoefficients given_paint(const Contents& held, double kept_share, int cells,
                                    double cell_area_mm2) {
    film::PaintCoefficients given;
    core::kernels<ContentsKernels>().give(
        held, {kept_share, cells * film::kPaintQuantum * cell_area_mm2, kStrongestPaint_per_mm}, given);
    return given;
}

/// The way 1 / (K + S) that light goes in a paint, K and S the means over the bands.
float hiding_quanta(const film::PaintCoefficients& given) {
    const float sum = std::accumulate(given.begin(), given.begin() + film::kPigmentChannels, 0.0F);
    const float optical_per_quantum = sum / kBands * static_cast<float>(film::kPaintQuantum);
    return optical_per_quantum > 0.0F ? 1.0F / optical_per_quantum
                                      : static_cast<float>(film::kMaxThickness_quanta);
}

bool does_nothing(const WantedSums& wanted, const Limits& limits) {
    return !wanted.changes && !(wanted.touches && limits.depth > 0.0F);
}

bool changes_anything(const CellBatch& batch, const CellBatch::TilePart& part, bool stirs) {
    for (int i = part.begin; i < part.end; ++i) {
        const bool acts =
            batch.change[i] != 0 || batch.swap[i] != 0 || (stirs && batch.touched[i] > 0.0F);
        if (acts && batch.may_change(part, i)) return true;
    }
    return false;
}

TileCells cells_of(const CellBatch& batch, const CellBatch::TilePart& part, std::int32_t* thickness,
                   film::PaintCell* paint, std::int32_t* worked) {
    return {thickness,
            paint,
            worked,
            batch.cell.data() + part.begin,
            batch.thickness.data() + part.begin,
            batch.found.data() + part.begin,
            part.pass_found,
            batch.change.data() + part.begin,
            batch.swap.data() + part.begin,
            batch.touched.data() + part.begin,
            part.end - part.begin};
}

bool begins_strata(const ApplyRule& rule, const CellBatch& batch, const CellBatch::TilePart& part,
                   const film::FilmState& film) {
    return core::kernels<TransferKernels>().meets_other(
        rule, film.paint.read(part.tile), cells_of(batch, part, nullptr, nullptr, nullptr));
}

/// Leaves of what is planned for a cell the share that may be changed of it. Returns what is wanted
/// then.
WantedSums limit_plan(CellBatch& batch, WantedSums wanted) {
    for (const CellBatch::TilePart& part : batch.parts()) {
        for (int i = part.begin; i < part.end; ++i) {
            const std::uint8_t share = batch.share(part, i);
            if (share == grid::kWhole) continue;
            const std::int32_t change = grid::share_of(batch.change[i], share);
            const std::int32_t swap = grid::share_of(batch.swap[i], share);
            wanted.deposit -= std::max(batch.change[i], 0) - std::max(change, 0);
            wanted.swap -= batch.swap[i] - swap;
            batch.change[i] = change;
            batch.swap[i] = swap;
            batch.touched[i] *= grid::fraction_of(share);
        }
    }
    return wanted;
}

}  // namespace

StepRates step_rates(const Brush& brush, const ResolvedTip& tip, const HandPose& hand, double step_mm) {
    StepRates rates;
    rates.tip = &tip;
    rates.along_per_mm = 1.0 / tip.radius_mm;
    rates.across_per_mm = brush.tip.rigid ? 1.0 / tip.lane_mm : rates.along_per_mm;
    rates.per_capacity_mm3 = 1.0 / brush.tip.capacity_mm3;
    rates.half_depth_mm_per_mm3 = 0.5 / brush.tip.area_mm2;
    const double closing_mm =
        (brush.tip.rigid ? kStiffClosingLength_radii : kClosingLength_radii) * brush.tip.radius_mm;
    rates.rate = static_cast<float>(1.0 - std::exp(-step_mm / closing_mm));
    rates.film_mm = static_cast<float>(full_film_mm(brush.preset) * hand.film);
    rates.reach = static_cast<float>(brush.preset.paint.reach * hand.reach);
    rates.pickup = static_cast<float>(std::min(1.0, brush.preset.exchange.pickup * hand.pickup));
    return rates;
}

ExchangeRule exchange_rule(const Brush& brush, int index, const Contact& contact,
                           const StepRates& rates) {
    const PaintPreset& paint = brush.preset.paint;
    const Bristle& bristle = brush.tip.bristles[index];
    const double held_mm3 = brush.held[index].volume_mm3;
    const float saturation = saturation_of(brush, held_mm3, rates);
    const float wet_mm = rates.film_mm * square(saturation);
    const float tau_mm = wet_mm * bristle.body * (1.0F - 0.5F * contact.press) *
                         (1.0F + static_cast<float>(paint.edge) * contact.edge) *
                         (1.0F + static_cast<float>(paint.start) * saturation * contact.freshness);
    const float bead = bead_mm(brush, bristle, saturation, contact.press, rates);
    ExchangeRule rule{};
    set_axes(brush, contact, rates, rule);
    rule.underside_mm = contact.support_mm + tau_mm;
    rule.side_by_side = brush.tip.rigid && brush.preset.tip.shape != TipShape::Comb;
    rule.lane_core = rates.tip->lane_core;
    rule.crown = rates.tip->crown;
    rule.cover = rates.tip->cover / std::max({contact.alone, square(1.0F - saturation), kLeastAlone});
    rule.bearing_mm = contact.support_mm;
    rule.coat = static_cast<float>(paint.coat);
    rule.profile_mm = wet_mm;
    rule.profile = rates.tip->profile_of(index);
    rule.segments = rates.tip->segments;
    rule.lowest_mm = contact.support_mm - bead;
    rule.fade_per_mm = 1.0F / (0.4F * bead);
    rule.rate = rates.rate * rates.tip->share;
    rule.pickup = (1.0F - contact.ride) * rates.pickup;
    rule.mix = held_mm3 > kEmpty_mm3 ? mix_of(brush, contact) * (0.4F + 1.2F * bristle.body) : 0.0F;
    rule.mix_depth_mm = static_cast<float>(held_mm3 * rates.half_depth_mm_per_mm3);
    return rule;
}

WantedSums plan_exchange(const ExchangeRule& rule, CellBatch& batch) {
    return core::kernels<TransferKernels>().plan(
        rule, {batch.dx_mm.data(), batch.dy_mm.data(), batch.thickness.data(), batch.found.data(),
               batch.support_mm.data(), batch.change.data(), batch.swap.data(), batch.touched.data(),
               batch.padded_count()});
}

Limits touch_limits(const Brush& brush, const Contact& contact) {
    const float deepest = brush.tip.rigid ? kStiffDepth : 1.0F;
    return {brush.tip.rigid ? kLargestKnifeDeposit : kLargestDeposit, kLargestSwap,
            std::min(1.0F, deepest * mix_of(brush, contact) * contact.press)};
}

ApplyRule apply_rule(const Limits& limits, WantedSums wanted, std::uint32_t dither_seed,
                     const film::FilmState& film, const Contents& held, CellBatch& batch) {
    if (does_nothing(wanted, limits)) {
        for (CellBatch::TilePart& part : batch.parts())
            part.changes = false;
        return {};
    }
    if (batch.is_limited()) wanted = limit_plan(batch, wanted);
    const double cell_area_mm2 = film.cell_mm * film.cell_mm;
    const bool empty = held.volume_mm3 <= kEmpty_mm3;
    const double held_quanta =
        empty ? 0.0 : held.volume_mm3 / (film::kThicknessQuantum_mm * cell_area_mm2);
    ApplyRule rule;
    rule.deposit_scale = scale_to(limits.deposit_share * held_quanta, wanted.deposit);
    rule.swap_scale = scale_to(limits.swap_share * held_quanta, wanted.swap);
    rule.depth = limits.depth;
    if (!empty)
        rule.given = given_paint(held, 1.0 - limits.deposit_share - limits.swap_share, batch.count(),
                                 cell_area_mm2);
    rule.dither_seed = dither_seed;
    bool any_strata = false;
    for (CellBatch::TilePart& part : batch.parts()) {
        const bool has_strata = film.lower.is_in(part.tile);
        part.changes = changes_anything(batch, part, has_strata && rule.depth > 0.0F);
        part.has_strata =
            has_strata || (part.changes && wanted.may_bury && begins_strata(rule, batch, part, film));
        any_strata = any_strata || part.has_strata;
    }
    if (any_strata) rule.hiding_quanta = hiding_quanta(rule.given);
    return rule;
}

bool owns_planned_tiles(const CellBatch& batch, const film::FilmState& film) {
    return std::all_of(batch.parts().begin(), batch.parts().end(), [&](const auto& part) {
        const bool owns_whole =
            film.thickness.block(part.tile).unique() && film.paint.block(part.tile).unique();
        const bool owns_lower =
            film.lower.thickness.block(part.tile).unique() && film.lower.paint.block(part.tile).unique();
        const bool owns_worked = film.worked.thickness.block(part.tile).unique();
        return !part.changes || (owns_whole && (owns_lower || !part.has_strata) &&
                                 (owns_worked || !film.worked.is_followed));
    });
}

void own_planned_tiles(const CellBatch& batch, film::FilmState& film) {
    for (const CellBatch::TilePart& part : batch.parts()) {
        if (!part.changes) continue;
        film.thickness.write(part.tile);
        film.paint.write(part.tile);
        if (film.worked.is_followed) film.worked.thickness.write(part.tile);
        if (!part.has_strata) continue;
        film.lower.thickness.write(part.tile);
        film.lower.paint.write(part.tile);
    }
}

grid::Rect apply(const ApplyRule& rule, const CellBatch& batch, film::FilmState& film, Contents& held,
                 MediaExchange* media) {
    if (std::none_of(batch.parts().begin(), batch.parts().end(),
                     [](const CellBatch::TilePart& part) { return part.changes; }))
        return {};
    alignas(64) ChangeSums gained;  // across cache lines, clearing it takes a sixth of this function
    const auto& kernels = core::kernels<TransferKernels>();
    for (const CellBatch::TilePart& part : batch.parts()) {
        if (!part.changes) continue;
        std::int32_t* worked =
            film.worked.is_followed ? film.worked.thickness.write(part.tile) : nullptr;
        const TileCells cells =
            cells_of(batch, part, film.thickness.write(part.tile), film.paint.write(part.tile), worked);
        if (part.has_strata)
            kernels.apply_strata(
                rule, cells, {film.lower.thickness.write(part.tile), film.lower.paint.write(part.tile)},
                gained);
        else
            kernels.apply(rule, cells, gained);
        if (media != nullptr) exchange_media(rule, cells, part.tile, film, *media);
    }
    core::kernels<ContentsKernels>().take(gained, film.cell_mm * film.cell_mm, held);
    return gained.any ? batch.cells() : grid::Rect{};
}

grid::Rect apply_batch(CellBatch& batch, WantedSums wanted, const Limits& limits,
                       std::uint32_t dither_seed, film::FilmState& film, Contents& held,
                       MediaExchange* media) {
    const ApplyRule rule = apply_rule(limits, wanted, dither_seed, film, held, batch);
    if (media != nullptr) prepare_media(*media, batch.cells(), film);
    return apply(rule, batch, film, held, media);
}

}  // namespace pastoso::brush
