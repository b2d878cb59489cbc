// The table of actions on docs/stroke-format.md and the words that a fuzzer of recordings tries, both
// made of the tables of the actions.
#pragma once

#include <string>

namespace pastoso::recordings {

/// A row for every action that has an entry of its own, and one for each of its fields.
std::string action_table();

/// All keys of actions and fields, as libFuzzer reads a dictionary.
std::string action_dictionary();

}  // namespace pastoso::recordings
