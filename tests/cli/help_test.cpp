#include "cli/help_page.hpp"
#include "cli/run_program.hpp"

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(CliHelp, EverySubcommandHasHelpWithAnExample) {
    EXPECT_THAT(run_cli({"--help"}).output, HasSubstr("Example:\n  pastoso-cli "));
    for (const Words& command : commands()) {
        Words arguments = command;
        arguments.emplace_back("--help");
        const RunResult run = run_cli(arguments);
        EXPECT_EQ(run.status, 0);
        EXPECT_EQ(run.errors, "");
        // Its own, not another one's.
        std::string example = "Example:\n  pastoso-cli";
        for (const std::string& word : command)
            example += " " + word;
        EXPECT_THAT(run.output, HasSubstr(example + " "));
        EXPECT_EQ(run.output.find("Example:"), run.output.rfind("Example:"));
    }
}

TEST(CliHelp, ReplayNamesAllItsOptions) {
    const std::string help = run_cli({"replay", "--help"}).output;
    for (const char* option :
         {"--brush",     "--size-mm", "--paint",          "--palette", "--medium",  "--canvas",
          "--px-per-mm", "--tilt",    "--tilt-direction", "--seconds", "--support", "--relief-mm",
          "--threads",   "--fit",     "--output",         "--stats",   "--frames",  "--fps",
          "--scale",     "--light",   "--profile",        "--depth"}) {
        EXPECT_THAT(help, HasSubstr(option));
    }
}

TEST(CliHelp, SimulateNamesTheScenesThatComeWithTheProgram) {
    EXPECT_THAT(
        run_cli({"simulate", "--help"}).output,
        HasSubstr("glaze, paper-fig2, paper-fig3, paper-fig4, paper-fig5, paper-fig6, ridges, run-off, "
                  "two-schemes."));
}

TEST(CliHelp, TellsItsVersion) {
    const RunResult run = run_cli({"--version"});
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.output, testing::MatchesRegex("pastoso-cli [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(CliHelp, InfoListsWhatThereIs) {
    const RunResult run = run_cli({"info"});
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.output, StartsWith("pastoso-cli "));
    for (const char* name : {"instruction set", "Flat bristle 20", "Palette knife 17", "PB29", "PW6",
                             "heavy-body oil", "house paint", "cotton duck", "panel"}) {
        EXPECT_THAT(run.output, HasSubstr(name));
    }
}

}  // namespace
}  // namespace pastoso::cli
