// What is in hand and how the canvas is set up, as the actions that put it there again: what a project
// file keeps of it.
#pragma once

#include "document/events.hpp"
#include "document/painting_value.hpp"

namespace pastoso::document {

/// A recording of one tick on a canvas of the painting's settings.
Recording set_up_of(const PaintingValue& painting);

/// Puts what a recording of set_up_of() tells into a painting; other actions are left out. Throws
/// InputError for an unknown brush or medium.
void set_up(const Recording& recording, PaintingValue& painting);

}  // namespace pastoso::document
