// What a flat spot of wet paint looks like: the colour of every swatch.
#pragma once

#include "film/cell/paint_cell.hpp"
#include "pigment/hex_colour.hpp"
#include "shade/render.hpp"
#include "shade/tile_colour.hpp"

namespace pastoso::shade {

/// An even film far from any edge and relief: how thick it is, what it lies on, and how it is looked at.
struct Spot {
    double film_mm = 0.2;     ///< wet, 0 to film::kMaxThickness_mm
    pigment::Bands ground{};  ///< internal reflectance of what lies below; black where nothing is said
    Lighting lighting;
    pigment::Viewing viewing;
    friend bool operator==(const Spot&, const Spot&) = default;
};

/// The colour that canvas view and pictures show there, encoded in the space of the viewing: from the
/// kernel that colours the canvas's cells (tile_colour.hpp) and the shading equation of
/// shading_model.hpp, highlight included, on a level surface that sees the whole sky and lies in no
/// shadow. `paint` is per mm of film, as a brush holds it. Throws InputError for a light that
/// shading_constants() refuses. About a microsecond.
pigment::Srgb8 spot_colour(const film::PaintCoefficients& paint, const Spot& spot);

/// The same of cells of that colour (tile_colour.hpp), in the spot's light.
pigment::Srgb8 lit_colour(const CellColour& colour, const Spot& spot);

}  // namespace pastoso::shade
