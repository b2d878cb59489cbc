// A program describes its own command line: as a manual page, and to the shells that complete it.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace pastoso::arguments {

struct CommandFacts;

/// Of the program that is described.
struct Edition {
    std::string version;  ///< "0.1.0"
    std::string date;     ///< "2026-11-29"
};

/// Adds --man, --bash-completion and --zsh-completion, which help does not show: they are for those who
/// package the program. `program` has all of its options by the time that it parses.
void add_descriptions(CLI::App& program, const Edition& edition);

/// A page for man(1), in the language of man(7).
std::string man_page(const CommandFacts& program, const Edition& edition);

/// Scripts that the shells read when the program's name is first typed.
std::string bash_completion(const CommandFacts& program);
std::string zsh_completion(const CommandFacts& program);

}  // namespace pastoso::arguments
