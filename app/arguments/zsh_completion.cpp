#include "arguments/command_facts.hpp"
#include "arguments/descriptions.hpp"

#include <string>

namespace pastoso::arguments {
namespace {

/// A word between single quotes, in which _arguments takes nothing for its own signs.
std::string quoted(const std::string& text) {
    std::string result;
    for (const char letter : text) {
        if (letter == '\'')
            result += "'\\''";
        else if (letter == '[' || letter == ']' || letter == ':' || letter == '\\')
            result += std::string("\\") + letter;
        else
            result += letter;
    }
    return result;
}

/// One word of a list.
std::string with_spaces_escaped(const std::string& text) {
    std::string result;
    for (const char letter : text)
        result += letter == ' ' ? std::string("\\ ") : std::string(1, letter);
    return result;
}

/// ":FILE:_files" and the like.
std::string value_words(const ValueFacts& value) {
    using Kind = ValueFacts::Kind;
    const std::string name = ":" + quoted(value.shown.empty() ? "value" : value.shown) + ":";
    if (value.kind == Kind::None) return "";
    if (value.kind == Kind::Folder) return name + "_files -/";
    if (value.kind == Kind::File) return name + "_files";
    if (value.kind == Kind::Text) return name + " ";
    std::string choices;
    for (const std::string& choice : value.choices)
        choices += (choices.empty() ? "" : " ") + with_spaces_escaped(quoted(choice));
    return name + "(" + choices + ")";
}

std::string option_words(const OptionFacts& option) {
    std::string text;
    for (const std::string& name : option.names)
        text += " \\\n        '" + name + "[" + quoted(option.meaning) + "]" +
                value_words(option.value) + "'";
    return text;
}

/// The commands below and what each is for, as _arguments and _alternative take them.
std::string command_choices(const CommandFacts& command) {
    std::string choices;
    for (const CommandFacts& below : command.commands)
        choices += (choices.empty() ? "" : " ") + below.name + "\\:\"" + quoted(below.meaning) + "\"";
    return "((" + choices + "))";
}

bool has_file_or_command_first(const CommandFacts& command) {
    return !command.positionals.empty() && !command.commands.empty();
}

std::string first_function_name(const CommandFacts& command) {
    return function_name(command.line) + "__first";
}

/// _arguments takes one thing for the first place: a function, where that may be of two kinds.
std::string first_function(const CommandFacts& command) {
    if (!has_file_or_command_first(command)) return "";
    return first_function_name(command) +
           "() {\n    _alternative 'commands:command:" + command_choices(command) +
           "' 'files:" + quoted(command.positionals.front().names[0]) + ":_files'\n}\n\n";
}

std::string positional_words(const CommandFacts& command) {
    if (has_file_or_command_first(command))
        return " \\\n        '1:first:" + first_function_name(command) + "'";
    if (!command.commands.empty()) return " \\\n        '1:command:" + command_choices(command) + "'";
    std::string text;
    for (const OptionFacts& positional : command.positionals)
        text += " \\\n        '" + std::string(positional.value.many ? "*" : "") + ":" +
                quoted(positional.names[0]) + ":_files'";
    return text;
}

/// Goes on to the command that the second word names, as if that were the first one.
std::string hand_over(const CommandFacts& command) {
    if (command.commands.empty()) return "";
    std::string text = "    if (( CURRENT > 2 )); then\n        case \"$words[2]\" in\n";
    for (const CommandFacts& below : command.commands)
        text += "            " + below.name + ") shift words; (( CURRENT-- )); " +
                function_name(below.line) + "; return ;;\n";
    return text + "        esac\n    fi\n";
}

std::string functions_of(const CommandFacts& command) {
    std::string text = first_function(command) + function_name(command.line) + "() {\n" +
                       hand_over(command) + "    _arguments";
    for (const OptionFacts& option : command.options)
        text += option_words(option);
    text += positional_words(command) + "\n}\n\n";
    for (const CommandFacts& below : command.commands)
        text += functions_of(below);
    return text;
}

}  // namespace

std::string zsh_completion(const CommandFacts& program) {
    return "#compdef " + program.name + "\n\n" + functions_of(program) + function_name(program.line) +
           " \"$@\"\n";
}

}  // namespace pastoso::arguments
