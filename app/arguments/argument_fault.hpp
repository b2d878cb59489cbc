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

/// The first option that stands with an equals sign and nothing after it, "--output="; empty where there
/// is none. CLI11 would take the next word for its value.
inline std::string option_without_value(int argc, const char* const* argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--") break;
        if (word.starts_with("--") && word.find('=') + 1 == word.size()) return word;
    }
    return {};
}

}  // namespace pastoso::arguments
