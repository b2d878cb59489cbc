// Unfinished paintings from the command line.
#include "cli/run_program.hpp"
#include "document/well_session.hpp"
#include "journal/journals.hpp"
#include "project/project.hpp"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::cli {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

class CliRecover : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        ::setenv("XDG_STATE_HOME", (folder / "state").c_str(), 1);
    }
    void TearDown() override {
        ::unsetenv("XDG_STATE_HOME");
        CliTest::TearDown();
    }

    /// The journal's name.
    std::string leave_unfinished() {
        return journal::left_behind(journal::journals_path(), session, {}, pool).filename().string();
    }

    core::ThreadPool pool{1};
    document::Recording session = document::mixing_session();
};

TEST_F(CliRecover, ListsAndBringsBack) {
    const std::string name = leave_unfinished();
    const RunResult list = run_cli({"recover", "--list"});
    ASSERT_EQ(list.status, 0) << list.errors;
    EXPECT_THAT(list.output, HasSubstr(name + ": "));
    EXPECT_THAT(list.output, ContainsRegex(", 40 x 30 mm, 6 changes not saved, without a file\n"));

    const RunResult run = run_cli({"recover", "-o", path("a.pastoso"), "-q"});
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(run.output, path("a.pastoso") + ": the painting\n");
    EXPECT_EQ(run.errors, "");
    const project::LoadedProject project = project::load_project(path("a.pastoso"), pool);
    EXPECT_EQ(project.strokes, session);
    EXPECT_EQ(document::state_hash(project.painting), journal::hash_of_replay(session, pool));
    EXPECT_EQ(run_cli({"recover", "--list"}).output, "");
}

TEST_F(CliRecover, KeepsOrForgetsWhenAsked) {
    const std::string name = leave_unfinished();
    ASSERT_EQ(run_cli({"recover", name, "-o", path("a.pastoso"), "--keep"}).status, 0);
    ASSERT_EQ(run_cli({"recover", name, "--discard"}).status, 0);
    EXPECT_EQ(run_cli({"recover", "--list"}).output, "");
}

TEST_F(CliRecover, WhatCannotBeDoneIsToldInASentence) {
    expect_refusal({"recover", "-o", path("a.pastoso")}, 1, "there is no unfinished painting.");
    expect_refusal({"recover"}, 2, "recover needs to know what to do");
    expect_refusal({"recover", "--discard"}, 2, "needs the NAME");
    expect_refusal({"recover", "-o", path("a.png")}, 1, "a painting is saved as .pastoso");
}

}  // namespace
}  // namespace pastoso::cli
