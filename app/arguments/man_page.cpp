#include "arguments/command_facts.hpp"
#include "arguments/descriptions.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace pastoso::arguments {
namespace {

/// Text as man(7) takes it: its own signs escaped, and hyphens that can be copied into a shell.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char letter : text) {
        if (letter == '\\')
            result += "\\e";
        else if (letter == '-')
            result += "\\-";
        else
            result += letter;
    }
    return result;
}

/// A line that man(7) cannot take for a request.
std::string line_of(const std::string& text) {
    const bool is_request = text.starts_with('.') || text.starts_with('\'');
    return (is_request ? "\\&" : "") + escaped(text) + "\n";
}

std::string bold(const std::string& text) {
    return "\\fB" + escaped(text) + "\\fR";
}

std::string italic(const std::string& text) {
    return "\\fI" + escaped(text) + "\\fR";
}

std::string upper_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
    return text;
}

/// "N" of "N:0 to 256".
std::string value_name(const ValueFacts& value) {
    const std::string name = value.shown.substr(0, value.shown.find_first_of(": "));
    return name.empty() ? "VALUE" : name;
}

/// "0 to 256" of "N:0 to 256".
std::string range_of(const ValueFacts& value) {
    const std::size_t colon = value.shown.find(':');
    const std::size_t end = value.shown.find(" Needs:");
    if (colon == std::string::npos || end < colon || !value.choices.empty()) return "";
    return value.shown.substr(colon + 1, end - colon - 1);
}

std::string positional_word(const OptionFacts& positional) {
    const std::string word = italic(positional.names.front()) + (positional.value.many ? " ..." : "");
    return positional.is_required ? word : "[" + word + "]";
}

std::string synopsis(const CommandFacts& command) {
    std::string text = bold(command.line) + " [" + italic("OPTION") + "]...";
    for (const OptionFacts& option : command.options)
        if (option.is_required)
            text += " " + bold(option.names.back()) + " " + italic(value_name(option.value));
    for (const OptionFacts& positional : command.positionals)
        text += " " + positional_word(positional);
    return text + "\n";
}

std::string heading(const OptionFacts& option) {
    std::string text;
    for (const std::string& name : option.names)
        text += (text.empty() ? "" : ", ") + (name.starts_with('-') ? bold(name) : italic(name));
    const bool takes_value =
        option.value.kind != ValueFacts::Kind::None && option.names[0].starts_with('-');
    if (takes_value) text += " " + italic(value_name(option.value)) + (option.value.many ? " ..." : "");
    return text + "\n";
}

std::string choices_words(const ValueFacts& value) {
    std::string words;
    for (const std::string& choice : value.choices)
        words += (words.empty() ? "one of " : ", ") + choice;
    return words;
}

/// What the meaning leaves to the program: range or choices, and what holds where nothing is given.
std::string limits(const OptionFacts& option) {
    std::string words = choices_words(option.value) + range_of(option.value);
    if (!option.preset.empty()) words += (words.empty() ? "" : "; ") + ("default: " + option.preset);
    if (option.is_required && option.names[0].starts_with('-'))
        words += words.empty() ? "required" : "; required";
    return words.empty() ? "" : " (" + words + ")";
}

std::string list_of(const std::vector<OptionFacts>& options) {
    std::string text;
    for (const OptionFacts& option : options)
        text += ".TP\n" + heading(option) + line_of(option.meaning + limits(option));
    return text;
}

/// Its lines as they are.
std::string verbatim(const std::string& text) {
    std::string result = ".nf\n";
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        result += line.empty() ? ".sp\n" : line_of(line);
    return result + ".fi\n";
}

std::string notes(const std::string& footer) {
    const std::size_t example = footer.find("Example:");
    std::string text;
    if (example != 0 && !footer.empty()) {
        std::istringstream lines(footer.substr(0, example));
        text = ".PP\n";
        for (std::string line; std::getline(lines, line);)
            if (!line.empty()) text += line_of(line);
    }
    return example == std::string::npos ? text : text + ".PP\n" + verbatim(footer.substr(example));
}

std::string section_of(const CommandFacts& command) {
    std::string text = ".SS " + command.line + "\n" + synopsis(command) + ".PP\n" +
                       line_of(command.meaning + ".") + list_of(command.positionals) +
                       list_of(command.options) + notes(command.footer);
    for (const CommandFacts& below : command.commands)
        text += section_of(below);
    return text;
}

std::string commands_of(const CommandFacts& program) {
    if (program.commands.empty()) return "";
    std::string text = ".SH COMMANDS\n";
    for (const CommandFacts& command : program.commands)
        text += section_of(command);
    return text;
}

std::string first_sentence(const std::string& text) {
    std::string sentence = text.substr(0, text.find('.'));
    if (!sentence.empty())
        sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
    return sentence;
}

}  // namespace

std::string man_page(const CommandFacts& program, const Edition& edition) {
    const std::string usage = program.commands.empty()
                                  ? synopsis(program)
                                  : bold(program.name) + " " + italic("COMMAND") + " [" +
                                        italic("OPTION") + "]... [" + italic("ARGUMENT") + "]...\n";
    return ".TH " + upper_case(escaped(program.name)) + " 1 \"" + edition.date + "\" \"Pastoso " +
           edition.version + "\" \"User Commands\"\n" + ".SH NAME\n" + escaped(program.name) + " \\- " +
           line_of(first_sentence(program.meaning)) + ".SH SYNOPSIS\n" + usage + ".SH DESCRIPTION\n" +
           line_of(program.meaning) + ".SH OPTIONS\n" + list_of(program.positionals) +
           list_of(program.options) + commands_of(program) +
           (program.footer.empty() ? "" : ".SH EXAMPLES\n" + verbatim(program.footer)) +
           ".SH EXIT STATUS\n.TP\n0\nDone.\n.TP\n1\nSomething that was given could not be used; one "
           "sentence says what.\n"
           ".TP\n2\nThe command line could not be understood.\n";
}

}  // namespace pastoso::arguments
