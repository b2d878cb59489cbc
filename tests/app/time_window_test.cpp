// Time as it passes for the paint, in the window: faster, and as it is told where the machine does not
// keep up.
#include "app/window_fixture.hpp"
#include "document/actions/actions.hpp"
#include "panels/messages/pace_notice.hpp"

#include <algorithm>
#include <functional>
#include <vector>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>

namespace pastoso::tests {
namespace {

using commands::Command;

class TimeWindow : public WindowTest {
  protected:
    QComboBox& box() { return *window().findChild<QComboBox*>(QStringLiteral("time")); }
    bool speed_comes_to(double speed) {
        wait_for([&] { return session().status().speed == speed; });
        return session().status().speed == speed;
    }
    bool note_is_shown() {
        QApplication::processEvents();
        const auto notes = canvas().findChildren<QLabel*>(QStringLiteral("canvas_note"));
        return std::any_of(notes.begin(), notes.end(), [](const QLabel* note) {
            return note->isVisible() && note->text() == QStringLiteral("10 × time");
        });
    }
};

TEST_F(TimeWindow, CommandsAndTheBoxBesidePauseSayHowFastItPasses) {
    EXPECT_EQ(box().currentText(), QStringLiteral("1 ×"));
    EXPECT_TRUE(box().isVisible());
    EXPECT_FALSE(action(Command::TimeSlower)->isEnabled());
    for (const char* shown : {"2 ×", "5 ×", "10 ×", "20 ×"}) {
        action(Command::TimeFaster)->trigger();
        EXPECT_EQ(box().currentText(), QString::fromUtf8(shown));
    }
    EXPECT_FALSE(action(Command::TimeFaster)->isEnabled());
    EXPECT_TRUE(speed_comes_to(20.0));
    action(Command::TimeSlower)->trigger();
    EXPECT_TRUE(speed_comes_to(10.0));
    action(Command::TimeReal)->trigger();
    EXPECT_TRUE(speed_comes_to(1.0));
    EXPECT_EQ(box().currentText(), QStringLiteral("1 ×"));
    box().setFocus();
    QTest::keyClick(&box(), Qt::Key_Down);
    EXPECT_TRUE(speed_comes_to(2.0));
    EXPECT_TRUE(action(Command::TimeSlower)->isEnabled());
}

TEST_F(TimeWindow, AnotherPaintingGoesOnAtTheSameSpeed) {
    action(Command::TimeFaster)->trigger();
    document::Recording recording{canvas_settings(), {{0, document::TiltCanvas{30.0, 90.0}}}, 1};
    window().replay(recording);
    EXPECT_TRUE(speed_comes_to(2.0));
}

TEST_F(TimeWindow, FasterTimeIsSeenWhereThePanelsAreHidden) {
    EXPECT_FALSE(note_is_shown());
    for (int i = 0; i < 3; ++i)
        action(Command::TimeFaster)->trigger();
    EXPECT_FALSE(note_is_shown());
    action(Command::CanvasOnly)->trigger();
    EXPECT_TRUE(note_is_shown());
    action(Command::CanvasOnly)->trigger();
    EXPECT_FALSE(note_is_shown());
}

session::Status running(double paint_per_wall, double speed = 1.0) {
    session::Status status;
    status.paint_per_wall = paint_per_wall;
    status.speed = speed;
    return status;
}

/// The window's own, told of a session that is as slow as a test wants it.
class SlowWindow : public WindowTest {
  protected:
    panels::PaceNotice& notice() { return *window().findChild<panels::PaceNotice*>(); }

    /// As if this had lasted; at once undone by what the real session tells, once events are handled.
    void tell(const session::Status& status) {
        now_s_ += 100.0;
        notice().look(status, now_s_);
        notice().look(status, now_s_ + 10.0);
    }
    std::string told() { return notice().sentence().toStdString(); }
    QPushButton* button(const char* words) {
        for (QPushButton* one : notice().findChildren<QPushButton*>())
            if (one->text() == QLatin1String(words) && !one->isHidden()) return one;
        return nullptr;
    }

  private:
    double now_s_ = 1e6;  ///< ahead of the window's own clock
};

TEST_F(SlowWindow, WordsSayHowSlowThePaintRuns) {
    EXPECT_FALSE(notice().isVisible());
    tell(running(0.1));
    EXPECT_EQ(told(), "The paint runs at a tenth of its pace.");
    EXPECT_TRUE(notice().isVisible());
    tell(running(0.5));
    EXPECT_EQ(told(), "The paint runs at half of its pace.");
    tell(running(2.5, 10.0));
    EXPECT_EQ(told(), "Time runs at a quarter of 10 ×.");
    tell(running(10.0, 10.0));
    EXPECT_EQ(told(), "");
    EXPECT_FALSE(notice().isVisible());
}

TEST_F(SlowWindow, PausedPaintIsNotSlow) {
    tell(running(0.1));
    session::Status paused = running(0.1);
    paused.paused = true;
    tell(paused);
    EXPECT_FALSE(notice().isVisible());
}

TEST_F(SlowWindow, ItsButtonsDoWhatHelps) {
    tell(running(0.1));
    EXPECT_EQ(button("Real time"), nullptr) << "it runs in real time already";
    EXPECT_EQ(button("Thin less"), nullptr) << "it is not thinned";
    action(Command::ThinWash)->trigger();
    QSignalSpy dried(action(Command::DryNow), &QAction::triggered);
    for (const char* words : {"Pause", "Dry", "Thin less"}) {
        ASSERT_NE(button(words), nullptr) << words;
        button(words)->click();
    }
    EXPECT_TRUE(action(Command::Pause)->isChecked());
    EXPECT_EQ(dried.count(), 1);
    EXPECT_EQ(studio().easel().hand().medium.paint_share, 0.11);

    action(Command::TimeFaster)->trigger();
    tell(running(0.5, 2.0));
    EXPECT_EQ(button("Thin less"), nullptr);
    ASSERT_NE(button("Real time"), nullptr);
    button("Real time")->click();
    EXPECT_FALSE(action(Command::TimeSlower)->isEnabled());
}

TEST_F(SlowWindow, TheNoticeMovesNothingAndLeavesTheCanvasFree) {
    const QRect canvas_before = canvas().geometry();
    const int bar_before = window().statusBar()->height();
    const int least_before = window().minimumSizeHint().width();
    tell(running(0.01));
    ASSERT_TRUE(notice().isVisible());
    QApplication::sendPostedEvents();
    EXPECT_EQ(canvas().geometry(), canvas_before);
    EXPECT_EQ(window().statusBar()->height(), bar_before);
    EXPECT_EQ(window().minimumSizeHint().width(), least_before);
    EXPECT_TRUE(window().statusBar()->isAncestorOf(&notice()));
}

TEST_F(SlowWindow, ANarrowWindowKeepsAllThatHelpsInOneMenu) {
    action(Command::ThinWash)->trigger();
    for (const int width : {1600, 1250, 900, 760}) {
        window().resize(width, 700);
        tell(running(0.1));
        QApplication::sendPostedEvents();
        tell(running(0.1));
        QStringList offered;
        for (QPushButton* button : notice().findChildren<QPushButton*>()) {
            if (button->isHidden()) continue;
            EXPECT_TRUE(notice().rect().contains(button->geometry())) << width;
            if (button->menu() == nullptr) {
                offered << button->text();
                continue;
            }
            Q_EMIT button->menu()->aboutToShow();
            for (const QAction* action : button->menu()->actions())
                offered << action->text();
        }
        EXPECT_EQ(offered, QStringList({"Pause", "Dry", "Thin less"})) << width;
    }
    window().resize(1600, 700);
    QApplication::sendPostedEvents();
    EXPECT_EQ(notice().findChild<QLabel*>()->text().toStdString(), told());
}

TEST_F(SlowWindow, MessagesPassBeforeIt) {
    tell(running(0.1));
    ASSERT_TRUE(notice().isVisible());
    studio().report(QStringLiteral("Saved."));
    EXPECT_FALSE(notice().isVisible());
    window().statusBar()->clearMessage();
    EXPECT_TRUE(notice().isVisible());
}

}  // namespace
}  // namespace pastoso::tests
