// From a recipe to the coefficients of the paint.
#pragma once

#include "document/events.hpp"
#include "pigment/bands.hpp"

namespace pastoso::document {

/// The mean of the ingredients' coefficients by volume, times the recipe's strength: clear medium adds
/// volume and no colour. The recipe passed check_paint().
pigment::Coefficients coefficients_of(const PaintRecipe& paint);

}  // namespace pastoso::document
