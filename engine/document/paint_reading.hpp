// From the paint at a place back to the tubes that it came from.
#pragma once

#include "document/events.hpp"
#include "film/cell/paint_sample.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pastoso::document {

/// Adds the names of the paints that the action brings out of their tubes, each once.
void note_paints(const Action& action, std::vector<std::string>& names);

/// The mixture as a recipe of the paints that may be in it, the largest part first: parts are
/// percentages of the pigmented paint, in tenths, the strength is its share of the volume in that of a
/// medium of this pigment share, in hundredths (1 at most: paint that has lost solvent is as strong as
/// it comes from the tube). So paint of a glaze, mixed in the same glaze, is what it was. Medium without
/// pigment is a recipe without ingredients. Nothing where these paints do not mix to it: where the
/// channels' relative errors are beyond 5 % in the root mean square.
std::optional<PaintRecipe> recipe_of(const pigment::Coefficients& mixture,
                                     std::span<const std::string> names, double pigment_share = 1.0);

}  // namespace pastoso::document
