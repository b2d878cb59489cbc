// Time as it passes for the paint, in the window: faster, and as it is told where the machine does not
// keep up.
#include "app/window_fixture.hpp"
#include "document/actions/actions.hpp"

#include <algorithm>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
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

}  // namespace
}  // namespace pastoso::tests
