// Dry paint below the wet film. What binds itself while it dries is fixed for ever: what it does to
// light is all that is kept of its pigments. Paint with hardly any binder stays as a layer that thinner
// dissolves.
#pragma once

#include "film/cell/paint_cell.hpp"
#include "grid/tiled_field.hpp"
#include "pigment/layer_optics.hpp"

#include <array>
#include <cstdint>

namespace pastoso::film {

/// Optical thicknesses K_k h and S_k h in quanta of kPaintQuantum.
using PigmentCell = std::array<std::int32_t, kPigmentChannels>;

/// What a paint is made of whatever its thickness: K_k and S_k per mm of it as 65535 sqrt(c /
/// kMostPerMm), which is true to 0.05 % at 1 per mm and to 0.5 % at a hundredth. All 0: nothing, or
/// paint without pigment.
using PigmentMixture = std::array<std::uint16_t, kPigmentChannels>;

/// The mixture of optical thicknesses in quanta. One denser than any paint is, for what has lost its
/// solvent, is thinned until it fits. All 0 without thickness.
PigmentMixture mixture_of(const std::int32_t* pigment, std::int32_t thickness);
pigment::Coefficients coefficients_of(const PigmentMixture& mixture);

/// What fixed paint does to light in every band (pigment/layer_optics.hpp), each share in 65535ths:
/// reflectances, then transmittances, then reverse reflectances.
using StrataOptics = std::array<std::uint16_t, 3 * pigment::kBands>;

inline constexpr float kOpticsCode = 65535.0F;
inline constexpr StrataOptics kClearStrata = [] {
    StrataOptics clear{};
    for (int band = 0; band < pigment::kBands; ++band)
        clear[pigment::kBands + band] = static_cast<std::uint16_t>(kOpticsCode);
    return clear;
}();

inline pigment::LayerOptics<float> optics_of(const StrataOptics& strata, int band) {
    return {static_cast<float>(strata[band]) / kOpticsCode,
            static_cast<float>(strata[pigment::kBands + band]) / kOpticsCode,
            static_cast<float>(strata[2 * pigment::kBands + band]) / kOpticsCode};
}

void set_optics(int band, const pigment::LayerOptics<float>& optics, StrataOptics& strata);

/// A layer of pigment, quanta of K h and S h, over others.
StrataOptics laid_over(const std::int32_t* pigment, const StrataOptics& lower);

/// What does that share, 0 to 1, of what the strata do to light (pigment/layer_optics.hpp).
StrataOptics faded(const StrataOptics& strata, float share);

/// Strata over others.
StrataOptics laid_over(const StrataOptics& upper, const StrataOptics& lower);

/// Sums over the canvas, exact. Thickness in quanta of kThicknessQuantum_mm.
struct DriedTotals {
    std::int64_t thickness = 0;
    std::array<std::int64_t, kPigmentChannels> pigment{};

    DriedTotals& operator+=(const DriedTotals& other);
    DriedTotals& operator-=(const DriedTotals& other);
    friend bool operator==(const DriedTotals&, const DriedTotals&) = default;
};

/// The thicknesses of all strata are part of FilmState::support_mm.
struct Strata {
    Strata() = default;
    explicit Strata(grid::Shape canvas)
        : soluble_thickness(canvas),
          soluble_pigment(canvas),
          optics(canvas, kClearStrata),
          uppermost(canvas) {}

    /// The uppermost stratum as long as it can be dissolved.
    grid::TiledField<std::int32_t> soluble_thickness;
    grid::TiledField<PigmentCell> soluble_pigment;

    /// What lies below that down to the support, apart from it.
    grid::TiledField<StrataOptics> optics;

    /// What the uppermost stratum of `optics` is made of, for a painter who wants that paint again.
    grid::TiledField<PigmentMixture> uppermost;

    DriedTotals fixed;            ///< all paint in `optics`
    std::int64_t evaporated = 0;  ///< thickness that left the film as vapour, summed over all cells
};

/// True when a cell of the soluble stratum holds nothing.
bool is_empty(const PigmentCell& pigment, std::int32_t thickness);

/// Sets a tile of the soluble stratum, to the background unless `any` of its cells holds something.
void replace_soluble(int tile, bool any, grid::TileBlock<std::int32_t> thickness,
                     grid::TileBlock<PigmentCell> pigment, Strata& strata);

/// What lies dry on the canvas.
DriedTotals dried_totals(const Strata& strata);

}  // namespace pastoso::film
