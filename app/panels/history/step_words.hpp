// What Undo takes back, in painters' words.
#pragma once

#include "document/undo_step.hpp"

#include <QString>

namespace pastoso::panels {

/// What was done, "Stroke" or "New layer"; and with what or to which layer, "Flat bristle 20".
QString step_words(const document::UndoStep& step);
QString step_detail(const document::UndoStep& step);

}  // namespace pastoso::panels
