// Paintings that were left unfinished, offered and brought back by the window.
#include "app/window_fixture.hpp"
#include "core/temporary_folder.hpp"
#include "dialogs/recovery_dialog.hpp"
#include "journal/recovery.hpp"
#include "main/window_parts.hpp"

#include <QAction>
#include <QCoreApplication>
#include <QPushButton>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

class RecoveryWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (!HasFatalFailure()) pause();
    }
    void pause() { studio().commands().action(commands::Command::Pause)->trigger(); }

    std::vector<journal::Unfinished> unfinished() {
        return journal::unfinished_paintings(journal::journals_path());
    }
    std::uint64_t state() { return document::state_hash(session().capture().painting); }
    void paint() {
        mouse_stroke(line_mm({12.0, 12.0}, {48.0, 30.0}));
        settle();
    }
};

TEST_F(RecoveryWindow, APaintingThatWasNotClosedComesBack) {
    paint();
    const std::uint64_t painted = state();
    open_another();
    pause();
    ASSERT_THAT(unfinished(), SizeIs(1));
    parts().files.recover_painting(unfinished()[0].folder);
    settle();
    EXPECT_EQ(state(), painted);
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_THAT(unfinished(), IsEmpty());

    open_another();
    ASSERT_THAT(unfinished(), SizeIs(1)) << "it is kept until it is saved";
    EXPECT_THAT(unfinished()[0].thumbnail, testing::StartsWith("\x89PNG"));
}

TEST_F(RecoveryWindow, ASavedPaintingIsNotOffered) {
    const TemporaryFolder folder;
    paint();
    parts().files.save_painting(QString::fromStdString((folder.path() / "a.pastoso").string()));
    ASSERT_EQ(parts().files.saver().wait().toStdString(), "");
    QCoreApplication::processEvents();
    window().close();
    open_another();
    EXPECT_THAT(unfinished(), IsEmpty());
}

TEST_F(RecoveryWindow, TheDialogShowsAndDiscards) {
    paint();
    open_another();
    int asked = 0;
    bool agreed = false;
    dialogs::RecoveryDialog dialog(unfinished(), &window(), [&](const QString&) {
        ++asked;
        return agreed;
    });
    EXPECT_TRUE(dialog.recover_button()->isEnabled());
    dialog.discard_button()->click();
    EXPECT_EQ(dialog.count(), 1);
    agreed = true;
    dialog.discard_button()->click();
    EXPECT_EQ(dialog.count(), 0);
    EXPECT_EQ(asked, 2);
    EXPECT_THAT(unfinished(), IsEmpty());
}

}  // namespace
}  // namespace pastoso::tests
