// Whether a stroke changes anything is not known before it does.
#pragma once

#include "document/painting.hpp"

namespace pastoso::tools {

/// Whether a stroke that begins at this place of the canvas may well change nothing: beside the canvas,
/// where nothing is selected, under masking fluid or tape, and where no wet paint lies, with a brush
/// that holds next to nothing or on a layer of which what is bare is locked. True says nothing for sure,
/// as the stroke goes on to elsewhere, and the painting may be further than its snapshot.
bool may_touch_nothing(const document::Snapshot& snapshot, double x_mm, double y_mm);

}  // namespace pastoso::tools
