#include "arguments/descriptions.hpp"

#include "arguments/command_facts.hpp"

#include <functional>

#include <CLI/CLI.hpp>

namespace pastoso::arguments {
namespace {

/// CLI11 prints what is thrown so, as it prints the version.
void add_description(CLI::App& program, const std::string& flag,
                     const std::function<std::string(const CommandFacts&)>& describe) {
    const auto tell = [&program, describe] {
        throw CLI::CallForVersion(describe(facts_of(program)),
                                  static_cast<int>(CLI::ExitCodes::Success));
    };
    program.add_flag_callback(flag, tell)->group("");
}

}  // namespace

void add_descriptions(CLI::App& program, const Edition& edition) {
    add_description(program, "--man",
                    [edition](const CommandFacts& facts) { return man_page(facts, edition); });
    add_description(program, "--bash-completion", bash_completion);
    add_description(program, "--zsh-completion", zsh_completion);
}

}  // namespace pastoso::arguments
