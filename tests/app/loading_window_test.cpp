// Paintings that are opened, recovered and made beside the window, which stays alive.
#include "app/window_fixture.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "journal/recovery.hpp"
#include "main/window_parts.hpp"

#include <condition_variable>
#include <mutex>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QMessageBox>
#include <QTimer>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

/// Holds the work up until it is opened.
class Gate {
  public:
    ~Gate() { open(); }

    void pass() {
        std::unique_lock lock(mutex_);
        reached_ = true;
        changed_.wait(lock, [this] { return open_; });
    }
    void open() {
        {
            const std::lock_guard lock(mutex_);
            open_ = true;
        }
        changed_.notify_all();
    }
    void shut() {
        const std::lock_guard lock(mutex_);
        open_ = reached_ = false;
    }
    bool reached() {
        const std::lock_guard lock(mutex_);
        return reached_;
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool open_ = true, reached_ = false;
};

class LoadingWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        watch();
        paint({12.0, 12.0});
        parts().files.save_painting(path("a.pastoso"));
        ASSERT_EQ(parts().files.saver().wait().toStdString(), "");
        QCoreApplication::processEvents();
        saved_ = state();
    }
    void TearDown() override {
        gate_.open();
        WindowTest::TearDown();
    }

    void watch() {
        studio().commands().action(Command::Pause)->trigger();
        parts().loading.watch([this](double) { gate_.pass(); });
    }
    QString path(const char* name) const {
        return QString::fromStdString((folder_.path() / name).string());
    }
    void paint(const glm::dvec2& from_mm) {
        mouse_stroke(line_mm(from_mm, {48.0, 30.0}));
        settle_paint();
    }
    void settle_paint() {
        session().wait_until_applied();
        QCoreApplication::processEvents();
    }
    std::uint64_t state() { return document::state_hash(session().capture().painting); }
    std::string title() { return window().windowTitle().toStdString(); }

    /// Begins to open a file, and is held up in it.
    void begin_to_open(const char* name) {
        gate_.shut();
        parts().files.open_painting(path(name));
        wait_for([this] { return gate_.reached(); });
    }
    void begin_to_resize(const document::ResizeCanvas& resize) {
        gate_.shut();
        parts().sizing.resize(resize);
        wait_for([this] { return gate_.reached(); });
    }
    void go_on() {
        gate_.open();
        loaded();
    }
    /// What is given up has come to its end when something else has.
    void wait_for_the_end() {
        gate_.open();
        bool ended = false;
        parts().loading.replace(QStringLiteral("Nothing"),
                                [&ended](const core::Progress&) { return [&ended] { ended = true; }; });
        wait_for([&] { return ended; });
        loaded();
    }
    /// Answers the question that comes, which has to.
    void answer(QMessageBox::ButtonRole role) {
        auto* looking = new QTimer(&window());
        QObject::connect(looking, &QTimer::timeout, &window(), [this, looking, role] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr) return;
            looking->deleteLater();
            ++asked_;
            for (QAbstractButton* button : box->buttons())
                if (box->buttonRole(button) == role) return button->click();
        });
        looking->start(10);
    }
    std::size_t journals() {
        std::size_t count = 0;
        for ([[maybe_unused]] const auto& each :
             std::filesystem::directory_iterator(journal::journals_path()))
            ++count;
        return count;
    }
    QWidget& progress() { return *window().findChild<QWidget*>(QStringLiteral("loading_progress")); }

    TemporaryFolder folder_;
    Gate gate_;
    std::uint64_t saved_ = 0;
    int asked_ = 0;
};

TEST_F(LoadingWindow, TheWindowLivesWhileAPaintingIsOpenedAndShowsHowFarItIs) {
    const auto shown = session().snapshot();
    begin_to_open("a.pastoso");
    EXPECT_TRUE(parts().loading.busy());
    wait_for([this] { return progress().isVisible(); });
    EXPECT_TRUE(action(Command::CancelLoading)->isEnabled());
    EXPECT_EQ(session().snapshot(), shown) << "the painting in hand stays";
    const double zoom = canvas().view_transform().zoom;
    action(Command::ZoomIn)->trigger();
    EXPECT_NE(canvas().view_transform().zoom, zoom);
    bool ticked = false;
    QTimer::singleShot(0, &window(), [&] { ticked = true; });
    wait_for([&] { return ticked; });
    go_on();
    EXPECT_FALSE(progress().isVisible());
    EXPECT_FALSE(action(Command::CancelLoading)->isEnabled());
    EXPECT_EQ(state(), saved_);
    EXPECT_THAT(title(), StartsWith("a.pastoso[*] "));
    EXPECT_EQ(asked_, 0);
}

TEST_F(LoadingWindow, WhatIsPaintedMeanwhileIsAskedAbout) {
    begin_to_open("a.pastoso");
    paint({12.0, 30.0});
    const std::uint64_t painted = state();
    EXPECT_NE(painted, saved_);
    answer(QMessageBox::RejectRole);
    go_on();
    EXPECT_EQ(asked_, 1);
    EXPECT_EQ(state(), painted) << "whoever thinks better of it keeps the painting";
    EXPECT_TRUE(window().isWindowModified());

    begin_to_open("a.pastoso");
    paint({12.0, 20.0});
    answer(QMessageBox::DestructiveRole);
    go_on();
    EXPECT_EQ(asked_, 2);
    EXPECT_EQ(state(), saved_);
    EXPECT_FALSE(window().isWindowModified());
}

TEST_F(LoadingWindow, WhatWasGivenUpBeforeIsNotAskedAboutAgain) {
    paint({12.0, 30.0});
    begin_to_open("a.pastoso");
    go_on();
    EXPECT_EQ(asked_, 0);
    EXPECT_EQ(state(), saved_);
}

TEST_F(LoadingWindow, AStrokeUnderWayIsPaintedToItsEnd) {
    begin_to_open("a.pastoso");
    press({12.0, 12.0});
    move({20.0, 20.0});
    settle_paint();
    ASSERT_TRUE(session().status().stroke_in_progress);
    const auto* before = &session();
    gate_.open();
    bool passed = false;
    QTimer::singleShot(300, &window(), [&] { passed = true; });
    wait_for([&] { return passed; });
    EXPECT_TRUE(parts().loading.busy());
    EXPECT_EQ(&session(), before);
    answer(QMessageBox::DestructiveRole);
    release({30.0, 20.0});
    loaded();
    EXPECT_EQ(asked_, 1);
    EXPECT_EQ(state(), saved_);
}

TEST_F(LoadingWindow, CancelLeavesAllAsItWas) {
    paint({12.0, 30.0});
    const std::uint64_t painted = state();
    const std::string titled = title();
    begin_to_open("a.pastoso");
    action(Command::CancelLoading)->trigger();
    EXPECT_FALSE(parts().loading.busy());
    EXPECT_FALSE(progress().isVisible());
    EXPECT_THAT(told(), HasSubstr("a.pastoso"));
    wait_for_the_end();
    EXPECT_EQ(state(), painted);
    EXPECT_EQ(title(), titled);
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_EQ(journals(), 1U) << "what never came to the easel has no journal";
}

TEST_F(LoadingWindow, AFileThatIsDamagedInItsMiddleIsOneSentence) {
    std::string file = core::read_text_file(path("a.pastoso").toStdString());
    file[file.size() / 2] = static_cast<char>(file[file.size() / 2] ^ 0x55);
    core::write_text_file(path("bad.pastoso").toStdString(), file);
    paint({12.0, 30.0});
    const std::uint64_t painted = state();
    begin_to_open("bad.pastoso");
    go_on();
    ASSERT_THAT(studio().messages().standing(), SizeIs(1));
    EXPECT_THAT(studio().messages().standing()[0].sentence.toStdString(), HasSubstr("bad.pastoso"));
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    EXPECT_EQ(state(), painted);
    begin_to_open("a.pastoso");
    go_on();
    EXPECT_THAT(studio().messages().standing(), IsEmpty()) << "it is solved by the next";
    EXPECT_EQ(state(), saved_);
}

TEST_F(LoadingWindow, TheLastWishCounts) {
    begin_to_open("a.pastoso");
    parts().files.new_canvas({.width_mm = 30.0, .height_mm = 20.0});
    go_on();
    EXPECT_EQ(session().canvas().width_mm, 30.0);
    EXPECT_THAT(title(), StartsWith("Canvas[*] "));
    wait_for([this] { return journals() == 1U; });
}

TEST_F(LoadingWindow, APictureForALayerWaitsForNothingAndOvertakesNothing) {
    begin_to_open("a.pastoso");
    parts().pictures.paint_pictures({path("none.png")});
    EXPECT_THAT(told(), HasSubstr("a.pastoso"));
    go_on();
    EXPECT_EQ(state(), saved_);
}

TEST_F(LoadingWindow, WhatIsPaintedWhileTheCanvasIsMadeLargerLiesOnIt) {
    const document::ResizeCanvas larger{-10.0, -5.0, 80.0, 50.0};
    begin_to_resize(larger);
    EXPECT_TRUE(progress().isVisible());
    EXPECT_EQ(session().canvas().width_mm, 60.0);
    paint({12.0, 30.0});
    document::PaintingState expected = session().capture().painting;
    go_on();
    EXPECT_EQ(asked_, 0);
    EXPECT_EQ(session().canvas().width_mm, 80.0);
    EXPECT_THAT(told(), HasSubstr("80 × 50 mm"));
    core::ThreadPool pool;
    document::Painting other(expected, pool);
    other.apply(larger);
    EXPECT_EQ(state(), document::state_hash(other.state()));
    action(Command::Undo)->trigger();
    settle_paint();
    EXPECT_EQ(session().canvas().width_mm, 60.0);
    EXPECT_EQ(state(), document::state_hash(expected));
    action(Command::Undo)->trigger();
    settle_paint();
    EXPECT_EQ(state(), saved_);
}

TEST_F(LoadingWindow, AnotherSizeOfTheCanvasCanBeGivenUp) {
    begin_to_resize({-10.0, -5.0, 80.0, 50.0});
    action(Command::CancelLoading)->trigger();
    EXPECT_FALSE(parts().loading.busy());
    wait_for_the_end();
    EXPECT_EQ(session().canvas().width_mm, 60.0);
    EXPECT_EQ(state(), saved_);
}

TEST_F(LoadingWindow, ASizeIsOfTheCanvasThatItWasWishedForOn) {
    parts().sizing.resize({0.0, 0.0, 30.0, 20.0});
    loaded();
    ASSERT_EQ(session().canvas().width_mm, 30.0);
    begin_to_resize({-10.0, -5.0, 80.0, 50.0});
    action(Command::Undo)->trigger();
    settle_paint();
    go_on();
    EXPECT_EQ(session().canvas().width_mm, 60.0);
    EXPECT_THAT(told(), HasSubstr("keeps its size"));
}

TEST_F(LoadingWindow, ACanvasThatCannotBeIsOneSentence) {
    begin_to_resize({0.0, 0.0, 60.0, 9000.0});
    go_on();
    ASSERT_THAT(studio().messages().standing(), SizeIs(1));
    EXPECT_THAT(studio().messages().standing()[0].sentence.toStdString(), HasSubstr("9000 mm"));
    EXPECT_EQ(session().canvas().height_mm, 40.0);
}

TEST_F(LoadingWindow, ClosingTheWindowGivesUpWhatIsOpened) {
    begin_to_open("a.pastoso");
    window().close();
    EXPECT_FALSE(window().isVisible());
    EXPECT_FALSE(parts().loading.busy());
    gate_.open();
    open_another();
    EXPECT_THAT(journal::unfinished_paintings(journal::journals_path()), IsEmpty());
}

TEST_F(LoadingWindow, ThatARecoveryIsGivenUpLosesNothing) {
    paint({12.0, 30.0});
    const std::uint64_t painted = state();
    open_another();
    watch();
    const auto left = journal::unfinished_paintings(journal::journals_path());
    ASSERT_THAT(left, SizeIs(1));
    gate_.shut();
    parts().files.recover_painting(left[0].folder);
    wait_for([this] { return gate_.reached(); });
    action(Command::CancelLoading)->trigger();
    wait_for_the_end();
    ASSERT_THAT(journal::unfinished_paintings(journal::journals_path()), SizeIs(1));
    parts().files.recover_painting(left[0].folder);
    loaded();
    EXPECT_EQ(state(), painted);
}

TEST_F(LoadingWindow, ARecoveryThatIsWishedForTwiceComes) {
    paint({12.0, 30.0});
    const std::uint64_t painted = state();
    open_another();
    watch();
    const auto left = journal::unfinished_paintings(journal::journals_path());
    ASSERT_THAT(left, SizeIs(1));
    parts().files.recover_painting(left[0].folder);
    parts().files.recover_painting(left[0].folder);
    loaded();
    EXPECT_THAT(studio().messages().standing(), IsEmpty());
    EXPECT_EQ(state(), painted);
}

}  // namespace
}  // namespace pastoso::tests
