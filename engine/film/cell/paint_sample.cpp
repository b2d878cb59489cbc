#include "film/cell/paint_sample.hpp"

#include "film/cell/cell_drying.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film {
namespace {

using pigment::Coefficients;

/// Of wet paint: how much there is, and of what.
struct WetSums {
    std::int64_t thickness = 0;
    std::array<std::int64_t, kPigmentChannels> pigment{};

    void add(std::int64_t cell_thickness, const PaintCell& paint) {
        thickness += cell_thickness;
        for (int k = 0; k < kPigmentChannels; ++k)
            pigment[k] += paint[k];
    }
    /// Whether it is a film over so many cells, and no trace.
    bool is_film(int cells) const {
        return thickness > 0 &&
               static_cast<double>(thickness) * kThicknessQuantum_mm >= kBindingFilm_mm * cells;
    }
};

struct Sums {
    int cells = 0;
    WetSums wet, uppermost;  ///< all of it, and without what lies below other wet paint
    int dry_cells = 0;
    std::array<double, kPigmentChannels> dry_per_mm{};
};

/// What lies uppermost below the wet paint of a cell, all 0 for nothing.
PigmentMixture dry_mixture(const Strata& strata, int x, int y) {
    const std::int32_t thickness = strata.soluble_thickness.at(x, y);
    if (thickness == 0) return strata.uppermost.at(x, y);
    return mixture_of(strata.soluble_pigment.at(x, y).data(), thickness);
}

void add_cell(const FilmState& state, int x, int y, Sums& sums) {
    ++sums.cells;
    const std::int32_t thickness = state.thickness.at(x, y);
    const PaintCell& wet = state.paint.at(x, y);
    sums.wet.add(thickness, wet);
    sums.uppermost.add(thickness - state.lower.thickness.at(x, y),
                       upper_paint(state.lower.paint.at(x, y), wet));
    const PigmentMixture dry = dry_mixture(state.strata, x, y);
    if (dry == PigmentMixture{}) return;
    ++sums.dry_cells;
    const Coefficients per_mm = coefficients_of(dry);
    for (int k = 0; k < kPigmentChannels; ++k)
        sums.dry_per_mm[k] += per_mm[k];
}

Sums sums_in_disc(const FilmState& state, double x_mm, double y_mm, double radius_mm) {
    const double x = x_mm / state.cell_mm, y = y_mm / state.cell_mm, radius = radius_mm / state.cell_mm;
    const int middle_x = static_cast<int>(std::floor(x)), middle_y = static_cast<int>(std::floor(y));
    const int reach = static_cast<int>(std::ceil(radius));
    Sums sums;
    for (int j = middle_y - reach; j <= middle_y + reach; ++j) {
        for (int i = middle_x - reach; i <= middle_x + reach; ++i) {
            const bool inside = std::hypot(i + 0.5 - x, j + 0.5 - y) <= radius;
            const bool here = i == middle_x && j == middle_y;
            if ((inside || here) && state.shape.contains(i, j)) add_cell(state, i, j, sums);
        }
    }
    return sums;
}

Coefficients wet_coefficients(const WetSums& wet) {
    const double per_quantum =
        kPaintQuantum / (static_cast<double>(wet.thickness) * kThicknessQuantum_mm);
    Coefficients per_mm{};
    for (int k = 0; k < kPigmentChannels; ++k)
        per_mm[k] = static_cast<float>(static_cast<double>(wet.pigment[k]) * per_quantum);
    return per_mm;
}

Coefficients dry_coefficients(const Sums& sums) {
    Coefficients per_mm{};
    for (int k = 0; k < kPigmentChannels; ++k)
        per_mm[k] = static_cast<float>(sums.dry_per_mm[k] / sums.dry_cells);
    return per_mm;
}

}  // namespace

PaintSample sample_paint(const FilmState& state, double x_mm, double y_mm, double radius_mm) {
    const Sums sums = sums_in_disc(state, x_mm, y_mm, radius_mm);
    if (sums.uppermost.is_film(sums.cells)) return {PaintLayer::Wet, wet_coefficients(sums.uppermost)};
    const bool counts = sums.wet.is_film(sums.cells) || sums.dry_cells == 0;
    if (sums.wet.thickness > 0 && counts) return {PaintLayer::Wet, wet_coefficients(sums.wet)};
    if (sums.dry_cells > 0) return {PaintLayer::Dry, dry_coefficients(sums)};
    return {};
}

}  // namespace pastoso::film
