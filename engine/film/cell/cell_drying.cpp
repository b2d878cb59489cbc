#include "film/cell/cell_drying.hpp"

#include "core/elementary.hpp"

#include <algorithm>
#include <limits>

namespace pastoso::film {
namespace {

constexpr auto kBindingQuanta = static_cast<std::int32_t>(kBindingFilm_mm / kThicknessQuantum_mm);

constexpr double kStiffest_m2_s = 1e4;
constexpr double kStiffestLog = 23.02585093;  ///< ln(kStiffest_m2_s / kThinnest_m2_s)
constexpr double kHardest_Pa = 1000.0;
constexpr double kYieldPerViscosity = 250.0;  ///< Pa per m2/s

/// A carried amount per millimetre of thickness, and back.
double per_mm(std::int32_t carried, std::int32_t thickness) {
    return static_cast<double>(carried) * static_cast<double>(kQuantaPerCarried) / thickness;
}
std::int32_t carried(double per_mm, std::int32_t thickness) {
    return static_cast<std::int32_t>(per_mm * thickness / static_cast<double>(kQuantaPerCarried) + 0.5);
}

/// Rounded down to what the support counts in.
std::int32_t whole_steps(std::int32_t thickness) {
    return thickness / kQuantaPerSupport * kQuantaPerSupport;
}

/// True when the soluble stratum can take up the pigment without leaving the range of its integers.
bool fits(const PigmentCell& stratum, const PaintCell& paint) {
    for (int k = 0; k < kPigmentChannels; ++k)
        if (stratum[k] > std::numeric_limits<std::int32_t>::max() - paint[k]) return false;
    return true;
}

void add(std::int32_t thickness, const std::int32_t* pigment, DriedTotals& sums) {
    sums.thickness += thickness;
    for (int k = 0; k < kPigmentChannels; ++k)
        sums.pigment[k] += pigment[k];
}

}  // namespace

std::int32_t solids(std::int32_t thickness, const PaintCell& paint) {
    const std::int64_t carried_quanta = paint[kSolidsChannel] * kQuantaPerCarried;
    return static_cast<std::int32_t>(std::min<std::int64_t>(thickness, carried_quanta));
}

std::int32_t dry_on(std::int32_t time, std::int32_t& thickness, PaintCell& paint) {
    const std::int32_t left = paint[kDryingChannel] - time;
    const double share_left = static_cast<double>(left) / paint[kDryingChannel];
    const std::int32_t solvent = thickness - solids(thickness, paint);
    const double share_gone = static_cast<double>(time) / paint[kDryingChannel];
    const auto evaporated = static_cast<std::int32_t>(solvent * share_gone);  // less than all of it
    const std::int32_t remaining = thickness - evaporated;

    const double logarithm = per_mm(paint[kViscosityChannel], thickness);
    const double viscosity_m2_s = kThinnest_m2_s * core::exponential(std::min(logarithm, kStiffestLog));
    const double stiffer_log = std::min(logarithm - 2.0 * core::natural_log(share_left), kStiffestLog);
    const double stiffer_m2_s = std::min(viscosity_m2_s / (share_left * share_left), kStiffest_m2_s);
    const double yield_Pa = per_mm(paint[kYieldChannel], thickness);
    const double harder_Pa =
        std::min(yield_Pa + kYieldPerViscosity * (stiffer_m2_s - viscosity_m2_s), kHardest_Pa);

    thickness = remaining;
    paint[kViscosityChannel] = carried(std::max(stiffer_log, logarithm), remaining);
    paint[kYieldChannel] = carried(std::max(harder_Pa, yield_Pa), remaining);
    paint[kDryingChannel] = left;
    return evaporated;
}

void follow(std::int32_t thickness_before, const PaintCell& before, std::int32_t thickness,
            const PaintCell& paint, LowerCell& lower) {
    if (lower.thickness == 0) return;
    const auto part = [](std::int32_t held, std::int32_t whole_before, std::int32_t whole) {
        return whole_before > 0 ? static_cast<std::int32_t>(std::int64_t{held} * whole / whole_before)
                                : 0;
    };
    lower.thickness = part(lower.thickness, thickness_before, thickness);
    for (int k = kPigmentChannels; k < kPaintChannels; ++k)
        lower.paint[k] = part(lower.paint[k], before[k], paint[k]);
    if (lower.thickness == 0) lower = {};
}

void seal(const StrataCell& below) {
    if (is_empty(below.soluble_pigment, below.soluble_thickness)) return;
    below.optics = laid_over(below.soluble_pigment.data(), below.optics);
    add(below.soluble_thickness, below.soluble_pigment.data(), below.fixed);
    if (below.soluble_thickness > 0)
        below.uppermost = mixture_of(below.soluble_pigment.data(), below.soluble_thickness);
    below.soluble_thickness = 0;
    below.soluble_pigment = {};
}

namespace {

/// Turns wet paint into a stratum that can be dissolved, or one that covers and seals what is below.
std::int32_t lay_dry(std::int32_t thickness, const PaintCell& paint, bool soluble,
                     const StrataCell& below) {
    const std::int32_t stays = whole_steps(solids(thickness, paint));
    if (!soluble || !fits(below.soluble_pigment, paint)) seal(below);
    if (soluble) {
        below.soluble_thickness += stays;
        for (int k = 0; k < kPigmentChannels; ++k)
            below.soluble_pigment[k] += paint[k];
    } else {
        below.optics = laid_over(paint.data(), below.optics);
        below.uppermost = mixture_of(paint.data(), thickness);
        add(stays, paint.data(), below.fixed);
    }
    below.support_mm += thickness_mm(stays);
    return thickness - stays;
}

bool is_soluble(std::int32_t thickness, const PaintCell& paint) {
    return whole_steps(solids(thickness, paint)) < kBindingQuanta;
}

}  // namespace

std::int32_t become_stratum(std::int32_t& thickness, PaintCell& paint, const StrataCell& below) {
    const std::int32_t evaporated = lay_dry(thickness, paint, is_soluble(thickness, paint), below);
    thickness = 0;
    paint = {};
    return evaporated;
}

std::int32_t become_strata(std::int32_t& thickness, PaintCell& paint, const LowerCell& lower,
                           const StrataCell& below) {
    if (lower.thickness == 0) return become_stratum(thickness, paint, below);
    const bool soluble = is_soluble(thickness, paint);
    std::int32_t evaporated = lay_dry(lower.thickness, lower.paint, soluble, below);
    evaporated += lay_dry(thickness - lower.thickness, upper_paint(lower.paint, paint), soluble, below);
    thickness = 0;
    paint = {};
    return evaporated;
}

}  // namespace pastoso::film
