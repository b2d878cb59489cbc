// Which tool a name on the command line means.
#pragma once

#include "document/events.hpp"

#include <string>

namespace pastoso::cli {

/// A tool by the path of its preset file (NAME.json), by the name of one of the user's own, or by that
/// of one that comes with the program. A tool that does not come with the program is taken with its
/// whole definition. Throws InputError for a file that is none, and for an unknown name.
document::TakeBrush chosen_brush(const std::string& name);

}  // namespace pastoso::cli
