// The wet paint on a support: what the solver steps, the brush changes and the renderer shows.
#pragma once

#include "core/hash.hpp"
#include "film/cell/consistency.hpp"
#include "film/cell/lower_stratum.hpp"
#include "film/cell/paint_cell.hpp"
#include "film/cell/strata.hpp"
#include "film/cell/structure.hpp"
#include "film/cell/wet_media.hpp"
#include "film/support/support_heights.hpp"
#include "grid/tiled_field.hpp"

#include <array>
#include <cstdint>

namespace pastoso::film {

/// Thickness is counted in whole quanta, so that paint is moved and never lost to rounding: what leaves
/// one place and arrives at another is the same integer (docs/decisions/0001-fixed-point-paint.md). 30
/// pm a quantum.
inline constexpr double kThicknessQuantum_mm = 0x1p-25;

/// The thickest wet paint that a cell may hold: neither tools nor flow fill it further. Keeps the
/// strongest pigment of the palette (1043 per mm) and the hardest paint (1000 Pa) within the range of
/// their channels, 16384 units, and thickness far from its own, 64 mm.
inline constexpr double kMaxThickness_mm = 15.0;
inline constexpr auto kMaxThickness_quanta =
    static_cast<std::int32_t>(kMaxThickness_mm / kThicknessQuantum_mm);

/// Thickness quanta that a cell can still take.
inline constexpr std::int32_t capacity_left_quanta(std::int32_t thickness_quanta) {
    return thickness_quanta < kMaxThickness_quanta ? kMaxThickness_quanta - thickness_quanta : 0;
}

inline constexpr float thickness_mm(std::int32_t quanta) {
    return static_cast<float>(quanta) * static_cast<float>(kThicknessQuantum_mm);
}

/// All fields have the shape of the canvas. Copying a state is cheap and gives a snapshot.
struct FilmState {
    FilmState() = default;
    FilmState(grid::Shape canvas, double cell_size_mm)
        : shape(canvas),
          cell_mm(cell_size_mm),
          thickness(canvas),
          paint(canvas),
          lower(canvas),
          worked(canvas),
          media(canvas),
          velocity_x(canvas),
          velocity_y(canvas),
          support_mm(canvas),
          strata(canvas) {}

    grid::Shape shape;
    double cell_mm = 0.25;

    grid::TiledField<std::int32_t>
        thickness;                       ///< h, mean over the cell, quanta, 0..kMaxThickness_quanta
    grid::TiledField<PaintCell> paint;   ///< what the wet paint of the cell carries
    LowerStratum lower;                  ///< the part of them that lies below other wet paint
    WorkedPaint worked;                  ///< the part of them that tools and flow have loosened
    WetMedia media;                      ///< which media they are of
    grid::TiledField<float> velocity_x;  ///< depth mean at the face between (x, y) and (x+1, y), mm/s
    grid::TiledField<float> velocity_y;  ///< depth mean at the face between (x, y) and (x, y+1), mm/s
    SupportHeights support_mm;           ///< c, height of the dry surface below the paint

    Strata strata;  ///< dried paint on the bare support

    /// Those of the wet paint. Paint in cells that carry nothing is of the solver's medium, and is not
    /// named.
    Consistencies consistencies;
};

/// Sums over the canvas, exact: sum over the cells of the integers.
struct Totals {
    std::int64_t thickness = 0;
    std::array<std::int64_t, kPaintChannels> paint{};
};
Totals totals(const FilmState& state);

/// Volume in mm3 of a total of thickness quanta.
double volume_mm3(std::int64_t thickness_quanta, double cell_mm);

/// Those of the film's paint, of which one that has all dried is no longer any.
Consistencies wet_consistencies(const FilmState& state);

/// False when no cell can hold wet paint (nothing was painted, or all of it has dried).
bool has_wet_paint(const FilmState& state);

/// The number of cells that hold wet paint thicker than 1e-4 cell sizes; less is negligible.
std::int64_t wet_cell_count(const FilmState& state);

/// A hash of every field; equal states give equal hashes on every machine.
std::uint64_t state_hash(const FilmState& state);

}  // namespace pastoso::film
