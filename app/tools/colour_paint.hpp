// Paints for colours that are picked rather than squeezed from a tube.
#pragma once

#include "document/events.hpp"
#include "pigment/hex_colour.hpp"
#include "pigment/recipe.hpp"

namespace pastoso::tools {

/// The free paint of a colour on the screen.
document::PaintRecipe colour_paint(const pigment::Srgb8& colour);

/// The recipe out of the box and the painter's own tubes whose thick paint comes nearest to it.
pigment::Recipe closest_in_box(const pigment::Srgb8& colour);

/// The same mixture as the brush is dipped in.
document::PaintRecipe recipe_paint(const pigment::Recipe& recipe);

/// The same paint from tubes alone: in the place of a colour of the screen stands its closest recipe, in
/// as many parts together. Paint of tubes stays as it is.
document::PaintRecipe from_tubes(const document::PaintRecipe& paint);

}  // namespace pastoso::tools
