// One cell of paint drying, and becoming part of the strata below (drying.hpp has the equations).
#pragma once

#include "film/state.hpp"
#include "film/support/support.hpp"

namespace pastoso::film {

/// Solids thinner than this, mm, cannot hold their pigment: it can be dissolved again.
inline constexpr double kBindingFilm_mm = 0.005;

/// Thickness quanta in a quantum of a carried thickness, and in a step of the support's grid.
inline constexpr auto kQuantaPerCarried =
    static_cast<std::int64_t>(kPaintQuantum / kThicknessQuantum_mm);
inline constexpr auto kQuantaPerSupport =
    static_cast<std::int32_t>(kSupportQuantum_mm / kThicknessQuantum_mm);

/// The thickness of a cell's solids, quanta, at most `thickness`.
std::int32_t solids(std::int32_t thickness, const PaintCell& paint);

/// Passes `time` quanta, fewer than the cell still needs. Returns the quanta of thickness that
/// evaporate.
std::int32_t dry_on(std::int32_t time, std::int32_t& thickness, PaintCell& paint);

/// Lets the lower stratum of a cell follow what dry_on() made of the whole: it keeps its share of the
/// thickness and of all that dries.
void follow(std::int32_t thickness_before, const PaintCell& before, std::int32_t thickness,
            const PaintCell& paint, LowerCell& lower);

/// What lies below one cell of wet paint.
struct StrataCell {
    float& support_mm;
    std::int32_t& soluble_thickness;
    PigmentCell& soluble_pigment;
    StrataOptics& optics;
    PigmentMixture& uppermost;
    DriedTotals& fixed;  ///< sums over cells
};

/// Makes the soluble stratum part of what is fixed.
void seal(const StrataCell& below);

/// Turns all wet paint of the cell into dry: soluble paint joins the soluble stratum; other paint covers
/// and seals it. The solids are rounded down to whole kSupportQuantum_mm, so that the support stays on
/// its grid. Returns the quanta of thickness that evaporate.
std::int32_t become_stratum(std::int32_t& thickness, PaintCell& paint, const StrataCell& below);

/// The same for paint in two strata, the lower first; whether it is soluble, all of it tells. Without
/// two, become_stratum().
std::int32_t become_strata(std::int32_t& thickness, PaintCell& paint, const LowerCell& lower,
                           const StrataCell& below);

}  // namespace pastoso::film
