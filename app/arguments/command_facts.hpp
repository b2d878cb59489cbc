// A command line as plain data: what manual pages and completions are made of.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pastoso::arguments {

/// What an argument takes.
struct ValueFacts {
    enum class Kind { None, Text, File, Folder, Choice };
    Kind kind = Kind::None;
    std::vector<std::string> choices;  ///< of Kind::Choice
    std::string shown;                 ///< "FILE", or a range such as "N:0 to 256"; may be empty
    bool many = false;                 ///< several may follow one another
};

struct OptionFacts {
    std::vector<std::string> names;  ///< {"-o", "--output"}; of a positional argument {"STROKES"}
    std::string meaning, preset;     ///< preset: the value where none is given
    bool is_required = false;
    ValueFacts value;
};

struct CommandFacts {
    std::string name;  ///< its last word
    std::string line;  ///< all of its words, "pastoso-cli tea render"
    std::string meaning, footer;
    std::vector<OptionFacts> options, positionals;
    std::vector<CommandFacts> commands;
};

/// Of the program with all of its subcommands; options that help does not show are left out.
CommandFacts facts_of(const CLI::App& program);

/// What a shell can call the function of a command: "_pastoso_cli_tea_render" of its line.
std::string function_name(const std::string& line);

}  // namespace pastoso::arguments
