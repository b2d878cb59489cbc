// From a recipe to the coefficients of the paint.
#pragma once

#include "document/paint_recipe.hpp"
#include "film/cell/paint_cell.hpp"
#include "film/medium.hpp"

namespace pastoso::document {

/// The mean of the ingredients' coefficients by volume, times the recipe's strength (clear medium adds
/// volume and no colour), in a medium. The recipe passed check_paint(); one without ingredients is the
/// medium alone.
film::PaintCoefficients mixed_paint(const PaintRecipe& paint, const film::Medium& medium);

}  // namespace pastoso::document
