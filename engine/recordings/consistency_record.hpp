// The consistencies of a surface's or a brush's paint as a project file tells them.
#pragma once

#include "brush/contents.hpp"
#include "files/json_place.hpp"
#include "film/cell/consistency.hpp"
#include "film/medium.hpp"

namespace pastoso::recordings {

/// "none", "several", or an object with the numbers of the only one.
files::Json consistencies_json(const film::Consistencies& consistencies);
film::Consistencies read_consistencies(const files::JsonPlace& place);

/// Formats before 5 tell of paint whether it is all of one medium, but not of which. It is that of the
/// medium in hand where all the paint together carries what such paint does, within a hundredth;
/// otherwise each cell is asked, several.
film::Consistencies told_by_paint(const brush::Contents& paint, const film::Medium& in_hand);

}  // namespace pastoso::recordings
