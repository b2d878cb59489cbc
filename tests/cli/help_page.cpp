#include "cli/help_page.hpp"

#include "cli/run_program.hpp"

#include <sstream>

namespace pastoso::cli {
namespace {

/// Of lines such as "  -o,--output FILE          The picture".
std::vector<Option> options_in(const std::string& help) {
    std::vector<Option> options;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("  -")) continue;
        std::istringstream words(line);
        std::string names, type;
        words >> names;
        const std::size_t end = line.find("  ", line.find(names));
        const std::string said = line.substr(2, end == std::string::npos ? end : end - 2);
        if (said.size() > names.size()) type = said.substr(names.size() + 1);
        type = type.substr(0, type.find_first_of(":= "));
        const std::size_t longest = names.find("--");
        if (longest != std::string::npos) options.push_back({names.substr(longest), type});
    }
    return options;
}

}  // namespace

const std::vector<Words>& commands() {
    static const std::vector<Words> commands = {
        {"replay"},        {"sheet"},     {"export"},   {"convert"},  {"timelapse"},
        {"recover"},       {"thumbnail"}, {"simulate"}, {"validate"}, {"tea"},
        {"tea", "render"}, {"tank"},      {"info"}};
    return commands;
}

std::vector<Option> options_of(const Words& command) {
    Words words = command;
    words.emplace_back("--help");
    return options_in(run_cli(words).output);
}

}  // namespace pastoso::cli
