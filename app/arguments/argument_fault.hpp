// What is wrong with a command line, said the same way by both programs.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace pastoso::arguments {

/// One sentence for a command line that could not be parsed. An argument nobody knows is named before
/// whatever else is missing, since it is often the other one misspelt.
inline std::string argument_fault(const CLI::App& program, const CLI::ParseError& error) {
    const std::vector<std::string> unknown = program.remaining(true);
    const std::string fault = unknown.empty()
                                  ? std::string(error.what())
                                  : "there is no place for the argument \"" + unknown.front() + "\"";
    return fault + " (" + program.get_name() + " --help shows what there is).";
}

}  // namespace pastoso::arguments
