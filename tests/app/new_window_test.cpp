// Another window beside this one: what it starts, and that neither touches what the other keeps.
#include "app/window_fixture.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "journal/recovery.hpp"
#include "main/window_parts.hpp"

#include <QAction>
#include <QStatusBar>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

namespace fs = std::filesystem;
using commands::Command;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class OtherWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (!HasFatalFailure()) action(Command::Pause)->trigger();
    }
    void paint() {
        mouse_stroke(line_mm({12.0, 12.0}, {48.0, 30.0}));
        settle();
    }
    std::uint64_t state() { return document::state_hash(session().capture().painting); }
    std::vector<journal::Unfinished> unfinished() {
        return journal::unfinished_paintings(journal::journals_path());
    }
    /// Those of all windows.
    std::size_t journals() {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(journal::journals_path()), {}));
    }

    TemporaryFolder folder_;
};

TEST_F(OtherWindow, IsTheProgramOnceMore) {
    const fs::path started = folder_.path() / "started";
    const fs::path program = folder_.path() / "program";
    core::write_text_file(program, "#!/bin/sh\necho \"$# arguments\" > '" + started.string() +
                                       ".new'\nmv '" + started.string() + ".new' '" + started.string() +
                                       "'\n");
    fs::permissions(program, fs::perms::owner_all);
    parts().new_window.start_with(QString::fromStdString(program.string()));
    action(Command::NewWindow)->trigger();
    wait_for([&] { return fs::exists(started); });
    EXPECT_EQ(core::read_text_file(started), "0 arguments\n");
}

TEST_F(OtherWindow, IsToldWhereThereCanBeNone) {
    parts().new_window.start_with(QStringLiteral("/nowhere/pastoso"));
    action(Command::NewWindow)->trigger();
    EXPECT_THAT(told(), HasSubstr("/nowhere/pastoso cannot be started"));
}

TEST_F(OtherWindow, EachHasAJournalThatTheOtherLeavesAlone) {
    paint();
    auto other = std::make_unique<main::MainWindow>(canvas_settings());
    EXPECT_EQ(journals(), 2U);
    EXPECT_THAT(unfinished(), IsEmpty()) << "both are being painted on";
    EXPECT_EQ(journals(), 2U) << "to look for paintings takes none of them away";

    other->close();
    other.reset();
    EXPECT_EQ(journals(), 1U);
    const std::uint64_t painted = state();
    open_another();
    action(Command::Pause)->trigger();
    ASSERT_THAT(unfinished(), SizeIs(1)) << "the first window did not close";
    parts().files.recover_painting(unfinished()[0].folder);
    loaded();
    settle();
    EXPECT_EQ(state(), painted);
}

TEST_F(OtherWindow, RecoversWhatTheOtherLeftWhileThatIsGone) {
    auto other = std::make_unique<main::MainWindow>(canvas_settings());
    other->studio().easel().squeeze(10.0, 10.0);
    other->studio().session().wait_until_applied();
    EXPECT_THAT(unfinished(), IsEmpty());
    other.reset();
    EXPECT_THAT(unfinished(), SizeIs(1));
    EXPECT_EQ(journals(), 2U) << "that of the window that is open, too";
}

}  // namespace
}  // namespace pastoso::tests
