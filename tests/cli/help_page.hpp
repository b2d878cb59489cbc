// What the help of pastoso-cli lists.
#pragma once

#include <string>
#include <vector>

namespace pastoso::cli {

using Words = std::vector<std::string>;

/// Every subcommand, by its words.
const std::vector<Words>& commands();

struct Option {
    std::string name;  ///< "--fps"
    std::string type;  ///< "N"; empty: a flag
};

std::vector<Option> options_of(const Words& command);

}  // namespace pastoso::cli
