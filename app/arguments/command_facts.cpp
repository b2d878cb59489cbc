#include "arguments/command_facts.hpp"

#include <sstream>

#include <CLI/CLI.hpp>

namespace pastoso::arguments {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream words(text);
    for (std::string part; std::getline(words, part, separator);)
        parts.push_back(part);
    return parts;
}

/// The words between braces, as in "NAME:{png,exr}".
std::vector<std::string> choices_in(const std::string& type) {
    const std::size_t open = type.rfind('{'), close = type.rfind('}');
    if (open == std::string::npos || close == std::string::npos || close < open) return {};
    return split(type.substr(open + 1, close - open - 1), ',');
}

/// "DIR" of "DIR|FILE" is a folder that comes about, so that both are names of files.
ValueFacts::Kind kind_of(const std::string& type) {
    if (type == "DIR") return ValueFacts::Kind::Folder;
    if (type == "FILE" || type == "DIR|FILE") return ValueFacts::Kind::File;
    return ValueFacts::Kind::Text;
}

/// Choices and "TEXT", which CLI11 calls whatever has no name of its own, tell less than what is meant.
std::string shown_type(const std::string& type) {
    if (type == "TEXT") return "";
    return type.substr(0, type.find(":{"));
}

ValueFacts value_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    ValueFacts value;
    value.many = option.get_items_expected_max() > 1;
    if (option.get_items_expected_max() == 0) return value;
    value.shown = shown_type(type);
    value.choices = choices_in(type);
    value.kind = value.choices.empty() ? kind_of(type) : ValueFacts::Kind::Choice;
    return value;
}

OptionFacts facts_of(const CLI::Option& option) {
    return {
        {}, option.get_description(), option.get_default_str(), option.get_required(), value_of(option)};
}

/// Whatever stands without an option is more often a file than not.
OptionFacts positional_facts(const CLI::Option& option) {
    OptionFacts facts = facts_of(option);
    facts.names = {option.get_name(true)};
    facts.value.kind = ValueFacts::Kind::File;
    return facts;
}

/// Without names where it can only stand by itself. What may stand by itself instead is not required.
OptionFacts option_facts(const CLI::Option& option) {
    OptionFacts facts = facts_of(option);
    for (const std::string& name : option.get_snames())
        facts.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames())
        facts.names.push_back("--" + name);
    facts.is_required = facts.is_required && !option.get_positional();
    return facts;
}

void add_options(const CLI::App& command, CommandFacts& facts) {
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_group().empty()) continue;
        if (option->get_positional()) facts.positionals.push_back(positional_facts(*option));
        const OptionFacts named = option_facts(*option);
        if (!named.names.empty()) facts.options.push_back(named);
    }
}

CommandFacts facts_below(const CLI::App& command, const std::string& before) {
    CommandFacts facts;
    facts.name = command.get_name();
    facts.line = before + facts.name;
    facts.meaning = command.get_description();
    facts.footer = command.get_footer();
    add_options(command, facts);
    for (const CLI::App* below : command.get_subcommands({}))
        facts.commands.push_back(facts_below(*below, facts.line + " "));
    return facts;
}

}  // namespace

CommandFacts facts_of(const CLI::App& program) {
    return facts_below(program, "");
}

std::string function_name(const std::string& line) {
    std::string name = "_" + line;
    for (char& letter : name)
        if (letter == '-' || letter == ' ') letter = '_';
    return name;
}

}  // namespace pastoso::arguments
