// Dry paint below the wet film. What binds itself while it dries is fixed for ever: it shows as a ground
// of its own colour. Paint with hardly any binder stays as a layer that thinner dissolves.
#pragma once

#include "film/paint_cell.hpp"
#include "grid/tiled_field.hpp"

#include <array>
#include <cstdint>

namespace pastoso::film {

/// Optical thicknesses K_k h and S_k h in quanta of kPaintQuantum.
using PigmentCell = std::array<std::int32_t, kPigmentChannels>;

/// Sums over the canvas, exact. Thickness in quanta of kThicknessQuantum_mm.
struct DriedTotals {
    std::int64_t thickness = 0;
    std::array<std::int64_t, kPigmentChannels> pigment{};

    DriedTotals& operator+=(const DriedTotals& other);
    friend bool operator==(const DriedTotals&, const DriedTotals&) = default;
};

/// The thicknesses of all strata are part of FilmState::support_mm.
struct Strata {
    Strata() = default;
    explicit Strata(grid::Shape canvas)
        : soluble_thickness(canvas), soluble_pigment(canvas), ground(canvas) {}

    /// The uppermost stratum as long as it can be dissolved.
    grid::TiledField<std::int32_t> soluble_thickness;
    grid::TiledField<PigmentCell> soluble_pigment;

    /// Internal reflectance of what lies below that; in tiles that are background, the bare support's.
    grid::TiledField<pigment::Bands> ground;

    DriedTotals fixed;            ///< all paint in and below `ground`
    std::int64_t evaporated = 0;  ///< thickness that left the film as vapour, summed over all cells
};

/// True when a cell of the soluble stratum holds nothing.
bool is_empty(const PigmentCell& pigment, std::int32_t thickness);

/// Sets a tile of the soluble stratum, to the background unless `any` of its cells holds something.
void replace_soluble(int tile, bool any, grid::TileBlock<std::int32_t> thickness,
                     grid::TileBlock<PigmentCell> pigment, Strata& strata);

/// What lies dry on the canvas.
DriedTotals dried_totals(const Strata& strata);

/// The reflectance of a layer of pigment over a ground, band by band (Kubelka-Munk, all inside the
/// binder).
pigment::Bands layer_over(const std::int32_t* pigment, const pigment::Bands& ground);

}  // namespace pastoso::film
