// The colour of every cell: its wet paint over what lies dry over the ground, seen under even light.
#pragma once

#include "film/state.hpp"
#include "pigment/colour.hpp"

namespace pastoso::shade {

/// Paint of this thickness shines as a wet surface; thinner paint takes on the support's gloss smoothly.
inline constexpr double kGlossyThickness_mm = 0.02;

/// Linear RGB of the working space (before any mapping into the gamut) and wetness (0 to 1, for the
/// gloss).
struct CellColour {
    float red = 0.0F, green = 0.0F, blue = 0.0F, wetness = 0.0F;
};

/// The colours of a tile's 64 x 64 cells, those beyond the canvas included. `ground` is the internal
/// reflectance of the bare support. Kubelka-Munk per band and layer, Saunderson once at the air side,
/// then the matrix of the light they are seen in (pigment/viewing.hpp). The same bits with every
/// instruction set.
void tile_colours(const film::FilmState& film, int tile, const pigment::Bands& ground, CellColour* out,
                  const pigment::BandsToRgb& to_rgb = pigment::kBandsToLinearSrgb);

/// The same for a rectangle of cells; `stride` colours from row to row.
void cell_colours(const film::FilmState& film, const grid::Rect& cells, const pigment::Bands& ground,
                  CellColour* out, int stride,
                  const pigment::BandsToRgb& to_rgb = pigment::kBandsToLinearSrgb);

/// Those of what lies dry, as if no wet paint lay on it, the same way.
void dry_colours(const film::FilmState& film, const grid::Rect& cells, const pigment::Bands& ground,
                 CellColour* out, int stride,
                 const pigment::BandsToRgb& to_rgb = pigment::kBandsToLinearSrgb);

}  // namespace pastoso::shade
