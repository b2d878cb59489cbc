// The program from outside: what it says and how it ends.
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "locale_folder.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <sys/wait.h>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using pastoso::tests::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

struct Outcome {
    int exit_status = -1;
    std::string output;  ///< both streams
};

Outcome run_command(const std::string& command) {
    FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    Outcome outcome;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
        outcome.output.append(buffer.data(), count);
    }
    const int status = ::pclose(pipe);
    outcome.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
}

Outcome run(const std::string& environment, const std::string& arguments) {
    return run_command("env " + environment + " '" PASTOSO_PROGRAM "' " + arguments);
}

void expect_one_sentence(const std::string& text) {
    EXPECT_THAT(text, StartsWith("pastoso: "));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
}

TEST(Program, TellsItsVersionAndHelpWithoutADisplay) {
    const std::string no_display = "-u DISPLAY -u WAYLAND_DISPLAY";
    const Outcome version = run(no_display, "--version");
    EXPECT_EQ(version.exit_status, 0);
    EXPECT_THAT(version.output, StartsWith("pastoso "));
    const Outcome help = run(no_display, "--help");
    EXPECT_EQ(help.exit_status, 0);
    EXPECT_THAT(help.output, HasSubstr("--screenshot"));
}

TEST(Program, SaysInOneSentenceThatThereIsNoDisplay) {
    const Outcome outcome = run("-u DISPLAY -u WAYLAND_DISPLAY", "");
    EXPECT_EQ(outcome.exit_status, 1);
    expect_one_sentence(outcome.output);
    EXPECT_THAT(outcome.output, HasSubstr("no display"));
}

TEST(Program, SaysTheSameOfADisplayThatIsDead) {
    const Outcome outcome = run("-u WAYLAND_DISPLAY DISPLAY=:4711", "");
    EXPECT_EQ(outcome.exit_status, 1);
    expect_one_sentence(outcome.output);
    EXPECT_THAT(outcome.output, HasSubstr(":4711"));
}

TEST(Program, RefusesUnknownArguments) {
    for (const auto& [arguments, unknown] :
         {std::pair{"--no-such-option", "--no-such-option"}, std::pair{"a.json b.json", "b.json"}}) {
        const Outcome outcome = run("", arguments);
        EXPECT_EQ(outcome.exit_status, 2);
        expect_one_sentence(outcome.output);
        EXPECT_THAT(outcome.output, HasSubstr(unknown));
    }
}

class ProgramWithDisplay : public ::testing::Test {
  protected:
    void SetUp() override {
        if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) {
            GTEST_FAIL() << "no display: run under packaging/test.sh or xvfb-run";
        }
    }
};

TEST_F(ProgramWithDisplay, TakesNoPictureOfARecordingThatItCannotRead) {
    const Outcome missing = run("", "--screenshot /nowhere/window.png /nowhere/strokes.json");
    EXPECT_EQ(missing.exit_status, 1);
    expect_one_sentence(missing.output);
    EXPECT_THAT(missing.output, HasSubstr("/nowhere/strokes.json"));

    const TemporaryFolder folder;
    const auto broken = folder.path() / "broken.json";
    pastoso::core::write_text_file(broken, "{\"version\": 1, ");
    const Outcome malformed = run("", "--screenshot /nowhere/window.png " + broken.string());
    EXPECT_EQ(malformed.exit_status, 1);
    expect_one_sentence(malformed.output);
    EXPECT_THAT(malformed.output, HasSubstr("broken.json"));
}

TEST_F(ProgramWithDisplay, DrawsWithoutOpenGl) {
    const TemporaryFolder folder;
    const std::string picture = (folder.path() / "window.png").string();
    const Outcome outcome =
        run("XDG_CONFIG_HOME=" + folder.path().string() + " QT_XCB_GL_INTEGRATION=none",
            "--after 0.1 --screenshot " + picture);
    EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
    EXPECT_TRUE(std::filesystem::exists(picture));
}

TEST_F(ProgramWithDisplay, OpensItsWindowWhateverItIsToBeginWith) {
    const TemporaryFolder folder;
    const auto loop = folder.path() / "loop.pastoso";
    std::filesystem::create_symlink(loop, loop);
    // What is painted is kept there as soon as the window stands; only a signal ends it then.
    const std::string kept = (folder.path() / "pastoso" / "journals").string();
    const Outcome outcome =
        run_command("env XDG_STATE_HOME=" + folder.path().string() + " timeout 600 sh -c '\"" +
                    PASTOSO_PROGRAM + "\" " + loop.string() + " & until ls " + kept +
                    "/*/strokes.journal || ! kill -0 $!; do sleep 0.2; done 2>/dev/null; sleep 1; "
                    "kill -TERM $!; wait $!'");
    EXPECT_EQ(outcome.exit_status, 128 + 15) << outcome.output;
}

TEST_F(ProgramWithDisplay, ShowsItsWindowAndSavesAPictureOfIt) {
    const TemporaryFolder folder;
    const auto picture = folder.path() / "window.png";
    const Outcome outcome = run("", "--screenshot " + picture.string() + " --after 0.5");
    EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
    EXPECT_GT(std::filesystem::file_size(picture), 10000U);
}

TEST_F(ProgramWithDisplay, TellsHowLongThePainterWaitedWhereAsked) {
    const TemporaryFolder folder;
    const Outcome outcome =
        run("", "--profile --screenshot " + (folder.path() / "window.png").string() + " --after 0.5");
    EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("event to snapshot"));
    EXPECT_THAT(outcome.output, HasSubstr("tick without paint"));
}

TEST_F(ProgramWithDisplay, KeepsTheNumbersOfCInEveryLocale) {
    const TemporaryFolder folder;
    const pastoso::tests::LocaleFolder locales;
    ASSERT_TRUE(locales.is_whole()) << "needs the package locales";
    for (const char* name : pastoso::tests::LocaleFolder::kNames) {
        const Outcome outcome =
            run("LC_ALL=" + std::string(name),
                "--profile --screenshot " + (folder.path() / "window.png").string() + " --after 0.5");
        EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
        EXPECT_THAT(outcome.output, HasSubstr("."));
        EXPECT_THAT(outcome.output, Not(HasSubstr(","))) << name;
    }
}

TEST_F(ProgramWithDisplay, RefusesNumbersThatAreNoneAndSetsOfInstructionsThatAreNot) {
    for (const char* value : {"nan", "inf", "-1", "1e400", "x"}) {
        const Outcome outcome = run("", "--screenshot a.png --after " + std::string(value));
        EXPECT_EQ(outcome.exit_status, 2);
        expect_one_sentence(outcome.output);
        EXPECT_THAT(outcome.output, HasSubstr("--after: \"" + std::string(value) + "\""));
    }
    EXPECT_EQ(run("", "--screenshot= a.json").exit_status, 2);
    const Outcome outcome = run("PASTOSO_ISA=avx1024", "");
    EXPECT_EQ(outcome.exit_status, 1);
    expect_one_sentence(outcome.output);
    EXPECT_THAT(outcome.output, HasSubstr("PASTOSO_ISA is \"avx1024\""));
}

TEST_F(ProgramWithDisplay, LeavesAReportWhereItFails) {
    const TemporaryFolder folder;
    const std::string state = "XDG_STATE_HOME=" + folder.path().string();
    // Its window stands as soon as what is painted can be kept.
    const std::string kept = (folder.path() / "pastoso").string();
    const std::string killed = "sh -c '\"" PASTOSO_PROGRAM
                               "\" & "
                               "until ls " +
                               kept +
                               " | grep -qv crashes; do sleep 0.2; done; "
                               "kill -SEGV $!; wait $!'";
    const Outcome outcome = run_command("env " + state + " timeout 600 " + killed);
    EXPECT_NE(outcome.exit_status, 0);
    const auto reports = pastoso::core::files_in(folder.path() / "pastoso" / "crashes", ".txt");
    ASSERT_EQ(reports.size(), 1U) << outcome.output;
    const std::string text = pastoso::core::read_text_file(reports.front());
    EXPECT_THAT(text, HasSubstr("SIGSEGV"));
    EXPECT_THAT(text, HasSubstr("Processor: "));
    EXPECT_THAT(text, HasSubstr("(main+")) << "the functions under way, by name";
}

}  // namespace
