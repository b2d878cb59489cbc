// Actions in recordings (docs/stroke-format.md), by their tables.
#pragma once

#include "document/actions/actions.hpp"
#include "files/json_place.hpp"
#include "recordings/value_json.hpp"

#include <optional>
#include <string>

namespace pastoso::recordings {

/// What an entry holds under the action's key: its fields, in the order of the table. Not of the pen's,
/// which a recording tells as strokes.
files::Json action_json(const document::Action& action);

struct FoundAction {
    document::Action action;
    files::JsonPlace content;  ///< what was read
};

/// The action that an entry tells beside its tick. Throws InputError with the place where there is none,
/// for what is missing, unknown or of the wrong kind, and for whole numbers out of range; what else is
/// out of range is left to document::check_action().
FoundAction read_action(const files::JsonPlace& entry, ValueReader& values);

/// Where a picture lies and how strongly it shows, as fields of an object.
files::Json set_tracing_json(const document::SetTracing& set);
document::SetTracing read_set_tracing(const files::JsonPlace& object);

/// The number of a reference, how it lies and how it shows, as fields of an object.
files::Json set_reference_json(const document::SetReference& set);
document::SetReference read_set_reference(const files::JsonPlace& object);

/// The look of a layer or group, among other entries of an object.
files::Json look_json(const document::LayerLook& look);
document::LayerLook read_look(const files::JsonPlace& object);

}  // namespace pastoso::recordings
