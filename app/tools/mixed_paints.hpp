// Mixtures that are asked for again and again while the light moves.
#pragma once

#include "document/events.hpp"
#include "film/cell/paint_cell.hpp"
#include "film/medium.hpp"

namespace pastoso::tools {

/// document::mixed_paint(), remembered for up to kMostMixtures of the latest medium: the paint of a
/// colour takes 20 us to find, and a window shows hundreds. Each thread remembers its own; what is
/// returned stays until its next call.
const film::PaintCoefficients& remembered_paint(const document::PaintRecipe& paint,
                                                const film::Medium& medium);

inline constexpr std::size_t kMostMixtures = 1024;

}  // namespace pastoso::tools
