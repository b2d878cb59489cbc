// What steadies, leads and multiplies the hand, in recordings (docs/stroke-format.md).
#pragma once

#include "document/events.hpp"
#include "files/json_place.hpp"

namespace pastoso::recordings {

/// The contents of set_stabiliser, set_guide and set_symmetry.
files::Json stabiliser_json(const brush::Stabiliser& stabiliser);
files::Json guide_json(const brush::PenGuide& guide);
files::Json symmetry_json(const brush::Symmetry& symmetry);

/// Read the same. Throw InputError with the place for what is missing, unknown or of the wrong kind;
/// ranges are left to document::check_action(), but for the count of copies.
document::Action read_stabiliser(const files::JsonPlace& place);
document::Action read_guide(const files::JsonPlace& place);
document::Action read_symmetry(const files::JsonPlace& place);

}  // namespace pastoso::recordings
