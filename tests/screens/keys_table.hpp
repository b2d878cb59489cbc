// The table of all commands and their keys, for the manual.
#pragma once

#include <string>

namespace pastoso::screens {

/// A page in Markdown, as the list of commands and the sets of keys have them.
std::string keys_page();

}  // namespace pastoso::screens
