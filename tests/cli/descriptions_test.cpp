// What the programs tell of their command lines: to man(1), and to the shells that complete them.
#include "cli/help_page.hpp"
#include "cli/run_program.hpp"
#include "core/version.hpp"

#include <algorithm>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

using testing::HasSubstr;

std::string joined(const Words& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

/// From one line that has the heading to the next one that has `mark`.
std::string part_of(const std::string& text, const std::string& heading, const std::string& mark) {
    const std::size_t begin = text.find(heading);
    if (begin == std::string::npos) return "";
    return text.substr(begin, text.find(mark, begin + heading.size()) - begin);
}

/// As man(7) has it.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char letter : text)
        result += letter == '-' ? std::string("\\-") : std::string(1, letter);
    return result;
}

class CliDescriptions : public CliTest {
  protected:
    void expect_accepted(const std::string& program, const Words& arguments) const {
        const RunResult run = run_program(program, arguments);
        EXPECT_EQ(run.status, 0) << program << ": " << run.output << run.errors;
        EXPECT_EQ(run.errors, "") << program;
    }

    std::string described(const std::string& flag) const {
        const RunResult run = run_cli({flag});
        EXPECT_EQ(run.status, 0);
        EXPECT_EQ(run.errors, "");
        return run.output;
    }

    /// What bash offers for the last of these words.
    Words completed(const Words& line) const {
        std::string words;
        for (const std::string& word : line)
            words += " '" + word + "'";
        const std::string script = ". '" + write("completion", described("--bash-completion")) +
                                   "'; COMP_WORDS=(pastoso-cli" + words +
                                   "); COMP_CWORD=" + std::to_string(line.size()) +
                                   "; _pastoso_cli; printf '%s\\n' \"${COMPREPLY[@]}\"";
        std::istringstream output(run_program("/bin/bash", {"-c", script}).output);
        Words offered;
        for (std::string word; std::getline(output, word);)
            if (!word.empty()) offered.push_back(word);
        return offered;
    }
};

TEST_F(CliDescriptions, ThePageHasEveryCommandAndOption) {
    const std::string page = described("--man");
    for (const Words& command : commands()) {
        const std::string part = part_of(page, ".SS pastoso-cli " + joined(command) + "\n", ".SS ");
        EXPECT_NE(part, "") << joined(command);
        for (const Option& option : options_of(command))
            EXPECT_THAT(part, HasSubstr("\\fB" + escaped(option.name) + "\\fR")) << joined(command);
    }
}

TEST_F(CliDescriptions, ThePageTellsWhatItIsOf) {
    EXPECT_THAT(described("--man"),
                testing::StartsWith(".TH PASTOSO\\-CLI 1 \"" + std::string(core::version_date()) +
                                    "\" \"Pastoso " + core::version() + "\""));
}

TEST_F(CliDescriptions, ManReadsThePage) {
    const std::string page = write("pastoso-cli.1", described("--man"));
    expect_accepted("/usr/bin/mandoc", {"-T", "lint", "-W", "error", page});
    expect_accepted("/usr/bin/man", {"--warnings", "-l", page});
    EXPECT_THAT(run_program("/usr/bin/man", {"-l", page}).output, HasSubstr("tea render"));
}

TEST_F(CliDescriptions, ShellsReadTheirScripts) {
    expect_accepted("/bin/bash", {"-n", write("bash", described("--bash-completion"))});
    expect_accepted("/usr/bin/zsh", {"-n", write("zsh", described("--zsh-completion"))});
}

TEST_F(CliDescriptions, BashCompletesEveryCommandAndOption) {
    Words first_words;
    for (const Words& command : commands()) {
        if (command.size() == 1) first_words.push_back(command.front());
        Words line = command;
        line.emplace_back("--");
        Words options;
        for (const Option& option : options_of(command))
            options.push_back(option.name);
        EXPECT_THAT(completed(line), testing::UnorderedElementsAreArray(options)) << joined(command);
    }
    EXPECT_THAT(completed({""}), testing::UnorderedElementsAreArray(first_words));
}

TEST_F(CliDescriptions, BashCompletesValues) {
    EXPECT_THAT(completed({"tea", "--format", "p"}),
                testing::UnorderedElementsAre("png", "ply", "pbrt", "pbrt-scene"));
    EXPECT_THAT(completed({"tea", "render", "kept", "--milk", ""}),
                testing::UnorderedElementsAre("medium", "surface"));
    EXPECT_THAT(completed({"convert", "--support", "r"}), testing::ElementsAre("rough jute"));
    EXPECT_THAT(completed({"export", write("a b.pastoso", "")}),
                testing::ElementsAre(path("a b.pastoso")));
    EXPECT_THAT(completed({"replay", "--fps", ""}), testing::IsEmpty());
}

TEST_F(CliDescriptions, ZshKnowsEveryCommandAndOption) {
    const std::string script = described("--zsh-completion");
    EXPECT_THAT(script, testing::StartsWith("#compdef pastoso-cli\n"));
    for (const Words& command : commands()) {
        std::string name = "_pastoso_cli";
        for (const std::string& word : command)
            name += "_" + word;
        const std::string part = part_of(script, "\n" + name + "() {\n", "\n}\n");
        EXPECT_NE(part, "") << name;
        for (const Option& option : options_of(command))
            EXPECT_THAT(part, HasSubstr("'" + option.name + "[")) << name;
    }
}

}  // namespace
}  // namespace pastoso::cli
