// What steadies, leads and multiplies the hand, in recordings (docs/stroke-format.md).
#pragma once

#include "document/events.hpp"
#include "io/json_place.hpp"

namespace pastoso::io {

/// The contents of set_stabiliser, set_guide and set_symmetry.
Json stabiliser_json(const brush::Stabiliser& stabiliser);
Json guide_json(const brush::PenGuide& guide);
Json symmetry_json(const brush::Symmetry& symmetry);

/// Read the same. Throw InputError with the place for what is missing, unknown or of the wrong kind;
/// ranges are left to document::check_action(), but for the count of copies.
document::Action read_stabiliser(const JsonPlace& place);
document::Action read_guide(const JsonPlace& place);
document::Action read_symmetry(const JsonPlace& place);

}  // namespace pastoso::io
