// The mixtures that lie on the mixing well, to be squeezed out again.
#pragma once

#include "document/paint_recipe.hpp"
#include "film/state.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace pastoso::document {

inline constexpr std::size_t kMostPuddles = 12;

/// One mixture.
struct Puddle {
    PaintRecipe paint;
    double volume_mm3 = 0.0;  ///< of all of it, wherever it lies
    double x_mm = 0.0;        ///< the middle of where most of it lies, on the well
    double y_mm = 0.0;
    friend bool operator==(const Puddle&, const Puddle&) = default;
};

/// The mixtures of two of these paints or more, the largest first, at most kMostPuddles. Squares of 2 mm
/// of which K and S differ by less than a fifth count as one; less than 25 mm3 count as none, and so
/// does what is one paint but for a hundredth. A recipe is that of the mean paint, as recipe_of() has it
/// in a medium of this pigment share.
std::vector<Puddle> puddles_on(const film::FilmState& well, std::span<const std::string> names,
                               double pigment_share);

/// Whether no paint is by a fiftieth of the whole more in one than in the other.
bool are_alike(const PaintRecipe& a, const PaintRecipe& b);

}  // namespace pastoso::document
