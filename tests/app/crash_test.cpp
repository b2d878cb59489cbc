// What a run that failed leaves behind, and what the next one makes of it.
#include "core/check.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "crash/crash_guard.hpp"
#include "crash/crash_reports.hpp"

#include <csignal>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <gmock/gmock.h>

namespace pastoso::crash {
namespace {

using testing::HasSubstr;
using testing::Not;

class CrashTest : public ::testing::Test {
  protected:
    std::filesystem::path folder() const { return folder_.path() / "crashes"; }

    /// Fails in a process of its own; returns the signal that ended it.
    int ended_by(void (*fail)()) {
        const pid_t child = ::fork();
        if (child == 0) {
            const rlimit none{0, 0};
            ::setrlimit(RLIMIT_CORE, &none);
            ::close(STDERR_FILENO);
            guard(folder(), "Program: under test\n");
            fail();
            ::_exit(0);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    }
    std::string report() {
        const auto taken = take_report(folder());
        return taken ? taken->text : "";
    }

    tests::TemporaryFolder folder_;
};

TEST_F(CrashTest, ASignalLeavesAReportAndStillEndsTheProgram) {
    EXPECT_EQ(ended_by([] { ::raise(SIGSEGV); }), SIGSEGV);
    const std::string text = report();
    EXPECT_THAT(text, HasSubstr("Program: under test\n"));
    EXPECT_THAT(text, HasSubstr("SIGSEGV"));
    EXPECT_THAT(text, HasSubstr("Functions under way:\n"));
    EXPECT_THAT(text, Not(HasSubstr("Reason: ")));
}

TEST_F(CrashTest, TheReportHasTheFactsThatWereNotedLast) {
    ended_by([] {
        note_facts("Graphics: under test\n");
        ::raise(SIGSEGV);
    });
    const std::string text = report();
    EXPECT_THAT(text, HasSubstr("Graphics: under test\n"));
    EXPECT_THAT(text, Not(HasSubstr("Program: under test")));
}

TEST_F(CrashTest, ABrokenInvariantIsTheReason) {
    EXPECT_EQ(ended_by([] {
                  const int cells = 3;
                  PASTOSO_CHECK_OP(cells, >, 4);
              }),
              SIGABRT);
    EXPECT_THAT(report(), HasSubstr("broken invariant: cells > 4 (3 against 4)\n"));
}

TEST_F(CrashTest, AnExceptionThatNobodyCaughtIsTheReason) {
    EXPECT_EQ(ended_by([] { std::terminate(); }), SIGABRT);
    report();
    const auto throw_out = [] { std::thread([] { throw std::runtime_error("no more paint"); }).join(); };
    EXPECT_EQ(ended_by(throw_out), SIGABRT);
    EXPECT_THAT(report(), HasSubstr("Reason: no more paint\n"));
}

TEST_F(CrashTest, ARunThatEndsWellLeavesNone) {
    EXPECT_EQ(ended_by([] {}), 0);
    EXPECT_FALSE(take_report(folder()).has_value());
}

TEST_F(CrashTest, AReportIsTakenOnceTheLatestFirstAndFiveStay) {
    std::filesystem::create_directories(folder());
    for (int day = 1; day <= 8; ++day)
        core::write_text_file(folder() / ("2026-01-0" + std::to_string(day) + "-120000-7.txt"),
                              "day " + std::to_string(day));
    EXPECT_EQ(report(), "day 8");
    EXPECT_EQ(report(), "");
    const auto kept = core::files_in(folder(), ".seen");
    ASSERT_EQ(kept.size(), 5U);
    EXPECT_EQ(core::read_text_file(kept.front()), "day 4");
}

TEST_F(CrashTest, NamesOfFunctionsAreReadable) {
    std::filesystem::create_directories(folder());
    core::write_text_file(folder() / "a.txt", "./pastoso(_ZN7pastoso4main6StudioD1Ev+0x12)[0x5]\n");
    EXPECT_EQ(report(), "./pastoso(pastoso::main::Studio::~Studio()+0x12)[0x5]\n");
}

TEST_F(CrashTest, WhereNoFolderCanBeTheProgramGoesOn) {
    core::write_text_file(folder_.path() / "crashes", "a file");
    EXPECT_EQ(ended_by([] {}), 0);
}
}  // namespace
}  // namespace pastoso::crash
