#include "arguments/command_facts.hpp"
#include "arguments/descriptions.hpp"

#include <string>
#include <vector>

namespace pastoso::arguments {
namespace {

/// A list, one word a line, as bash quotes it: words may hold spaces.
std::string quoted(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : "\\n") + word;
    return "$'" + text + "'";
}

/// The words of a command without the program's: "tea render".
std::string words_after_program(const CommandFacts& command) {
    const std::size_t space = command.line.find(' ');
    return space == std::string::npos ? "" : command.line.substr(space + 1);
}

/// Cases that find out which command the words so far are of.
std::string command_cases(const CommandFacts& command) {
    std::string text;
    const std::string before = words_after_program(command);
    for (const CommandFacts& below : command.commands) {
        text += "            \"" + before + " " + below.name + "\") command=\"" +
                words_after_program(below) + "\" ;;\n" + command_cases(below);
    }
    return text;
}

std::string replies_for(const ValueFacts& value) {
    using Kind = ValueFacts::Kind;
    if (value.kind == Kind::Choice) return "compgen -W " + quoted(value.choices);
    if (value.kind == Kind::Folder) return "compgen -d";
    if (value.kind == Kind::File) return "compgen -f";
    return "";
}

std::string value_case(const std::string& command, const OptionFacts& option) {
    if (option.value.kind == ValueFacts::Kind::None) return "";
    std::string patterns;
    for (const std::string& name : option.names)
        patterns += (patterns.empty() ? "" : " | ") + ("\"" + command + " " + name + "\"");
    const std::string replies = replies_for(option.value);
    if (replies.empty()) return "        " + patterns + ") return ;;\n";
    return "        " + patterns + ")\n            mapfile -t COMPREPLY < <(" + replies +
           " -- \"$current\")\n            return ;;\n";
}

std::string value_cases(const CommandFacts& command) {
    std::string text;
    for (const OptionFacts& option : command.options)
        text += value_case(words_after_program(command), option);
    for (const CommandFacts& below : command.commands)
        text += value_cases(below);
    return text;
}

/// What may stand where no option takes a value.
std::string word_cases(const CommandFacts& command) {
    std::vector<std::string> options, commands;
    for (const OptionFacts& option : command.options)
        options.insert(options.end(), option.names.begin(), option.names.end());
    for (const CommandFacts& below : command.commands)
        commands.push_back(below.name);
    std::string text = "        \"" + words_after_program(command) + "\") options=" + quoted(options) +
                       " commands=" + quoted(commands) + " ;;\n";
    for (const CommandFacts& below : command.commands)
        text += word_cases(below);
    return text;
}

}  // namespace

std::string bash_completion(const CommandFacts& program) {
    const std::string function = function_name(program.line);
    return "# Completes " + program.name + " in bash.\n" + function +
           "() {\n"
           "    local current=\"${COMP_WORDS[COMP_CWORD]}\" previous=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
           "    local command=\"\" options=\"\" commands=\"\" word\n"
           "    for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
           "        case \"$command $word\" in\n" +
           command_cases(program) +
           "        esac\n"
           "    done\n"
           "    local IFS=$'\\n'\n"
           "    compopt -o filenames 2>/dev/null\n"
           "    case \"$command $previous\" in\n" +
           value_cases(program) +
           "    esac\n"
           "    case \"$command\" in\n" +
           word_cases(program) +
           "    esac\n"
           "    case \"$current\" in\n"
           "        -*) mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$current\") ;;\n"
           "        *)\n"
           "            mapfile -t COMPREPLY < <(compgen -W \"$commands\" -- \"$current\")\n"
           "            [[ -n $command || -z $commands ]] && mapfile -t -O \"${#COMPREPLY[@]}\" "
           "COMPREPLY < <(compgen -f -- \"$current\")\n"
           "            ;;\n"
           "    esac\n"
           "    return 0\n"
           "}\n"
           "complete -F " +
           function + " " + program.name + "\n";
}

}  // namespace pastoso::arguments
