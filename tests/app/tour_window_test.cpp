// The tour: its steps, where they stand, and when it comes by itself.
#include "app/window_fixture.hpp"
#include "help/tour_bubble.hpp"
#include "help/tour_frame.hpp"
#include "main/program/language.hpp"
#include "main/window_parts.hpp"
#include "panels/paint/paint_panel.hpp"
#include "panels/parts/tool_bar.hpp"

#include <set>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QRegion>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;

class TourWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (!HasFatalFailure()) action(Command::Pause)->trigger();
    }
    void TearDown() override {
        main::speak(QStringLiteral("en"));
        WindowTest::TearDown();
    }
    help::TourBubble* bubble() {
        for (auto* one : window().findChildren<help::TourBubble*>())
            if (one->isVisible()) return one;
        return nullptr;
    }
    void press(const char* button) {
        bubble()->findChild<QPushButton*>(QString::fromLatin1(button))->click();
        QApplication::processEvents();
    }
    /// What is framed now.
    QRegion frames() {
        for (const auto* one : window().findChildren<help::TourFrame*>())
            if (one->isVisible()) return one->mask();
        return {};
    }
    QRect in_window(const QWidget& widget) {
        return {widget.mapTo(&window(), QPoint(0, 0)), widget.size()};
    }
    void begin() {
        action(Command::Tour)->trigger();
        QApplication::processEvents();
    }
};

TEST_F(TourWindow, HasThreeStepsAndThenLeavesTheKeysToTheCanvas) {
    EXPECT_EQ(bubble(), nullptr);
    begin();
    std::set<QString> headings;
    for (int step = 0; step < 3; ++step) {
        ASSERT_NE(bubble(), nullptr);
        headings.insert(bubble()->accessibleName());
        EXPECT_FALSE(bubble()->accessibleDescription().isEmpty());
        EXPECT_TRUE(bubble()->isAncestorOf(QApplication::focusWidget()));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    }
    EXPECT_EQ(headings.size(), 3U);
    EXPECT_EQ(bubble(), nullptr);
    EXPECT_TRUE(canvas().hasFocus());
}

TEST_F(TourWindow, IsLeftByEscapeAndByItsButton) {
    begin();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    EXPECT_EQ(bubble(), nullptr);
    EXPECT_TRUE(canvas().hasFocus());
    begin();
    press("tour_next");
    press("tour_leave");
    EXPECT_EQ(bubble(), nullptr);
    begin();
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    EXPECT_EQ(bubble(), nullptr) << "also from the canvas";
    begin();
    action(Command::MilkTea)->trigger();
    EXPECT_EQ(bubble(), nullptr) << "the canvas is gone";
}

TEST_F(TourWindow, TheTabKeyGoesBetweenItsButtons) {
    begin();
    const QWidget* next = QApplication::focusWidget();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    EXPECT_EQ(QApplication::focusWidget()->objectName(), QStringLiteral("tour_leave"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    EXPECT_EQ(QApplication::focusWidget(), next);
}

TEST_F(TourWindow, StandsBesideThePaintsAndPaintingGoesOn) {
    begin();
    const double before_mm3 = volume_mm3();
    const QString first = bubble()->accessibleName();
    mouse_stroke(line_mm({12.0, 12.0}, {48.0, 30.0}));
    settle();
    EXPECT_GT(volume_mm3(), before_mm3);
    wait_for([&] { return bubble()->accessibleName() != first; });
    press("tour_next");
    auto* paints = window().findChild<panels::PaintPanel*>();
    EXPECT_FALSE(bubble()->geometry().intersects(in_window(*paints)));
    EXPECT_LE(bubble()->geometry().left() - in_window(*paints).right(), 20) << "right beside it";
    EXPECT_THAT(bubble()->accessibleDescription().toStdString(), HasSubstr("Ctrl+Z"));

    action(Command::LeftHanded)->trigger();
    QApplication::processEvents();
    EXPECT_FALSE(bubble()->geometry().intersects(in_window(*paints)));
    EXPECT_LE(in_window(*paints).left() - bubble()->geometry().right(), 20) << "it follows";
    action(Command::WorkspaceExport)->trigger();
    QApplication::processEvents();
    EXPECT_TRUE(in_window(canvas()).intersects(bubble()->geometry()));
}

TEST_F(TourWindow, GoesOnAsThePainterDoesWhatItSays) {
    const auto heading = [this] { return bubble()->accessibleName(); };
    auto* paints = window().findChild<panels::PaintPanel*>();
    const QToolButton* undo = nullptr;
    for (const auto* button : window().findChild<panels::ToolBar*>()->findChildren<QToolButton*>())
        if (button->defaultAction() == action(Command::Undo)) undo = button;
    ASSERT_NE(undo, nullptr);
    begin();
    const QString paint = heading();
    EXPECT_TRUE(frames().intersects(in_window(canvas())));
    EXPECT_FALSE(frames().contains(in_window(canvas()).center())) << "a frame, and no veil";
    EXPECT_FALSE(frames().intersects(in_window(*undo)));
    canvas().setFocus();
    mouse_stroke(line_mm({12.0, 12.0}, {48.0, 30.0}));
    wait_for([&] { return heading() != paint; });
    EXPECT_TRUE(canvas().hasFocus()) << "the keys stay where they are";

    const QString move = heading();
    const QPointF place = canvas().rect().center();
    QWheelEvent wheel(place, canvas().mapToGlobal(place), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&canvas(), &wheel);
    EXPECT_EQ(heading(), move) << "paint has to be picked as well";
    action(Command::PickPaint)->trigger();
    WindowTest::press({30.0, 21.0});
    release({30.0, 21.0});
    EXPECT_NE(heading(), move);

    EXPECT_TRUE(frames().intersects(in_window(*paints)));
    EXPECT_TRUE(frames().intersects(in_window(*undo)));
    paints->choose(paints->tubes().front());
    EXPECT_FALSE(frames().intersects(in_window(*paints))) << "that is done";
    EXPECT_TRUE(frames().intersects(in_window(*undo)));
    wait_for([&] { return action(Command::Undo)->isEnabled(); });
    action(Command::Undo)->trigger();
    EXPECT_EQ(bubble(), nullptr);
    EXPECT_TRUE(frames().isEmpty());
}

TEST_F(TourWindow, FitsTheWindowInEveryLanguage) {
    for (const char* language : {"en", "ja", "sv", "zh_TW"}) {
        SCOPED_TRACE(language);
        main::speak(QString::fromLatin1(language));
        open_another();
        for (const QSize& size : {QSize(1024, 640), QSize(1920, 1080)}) {
            window().resize(size);
            wait_for([&] { return window().size() == size; });
            begin();
            for (int step = 0; step < 3; ++step) {
                EXPECT_TRUE(window().rect().contains(bubble()->geometry()));
                for (const auto* label : bubble()->findChildren<QLabel*>()) {
                    EXPECT_TRUE(bubble()->rect().contains(label->geometry()));
                    if (label->wordWrap()) {
                        EXPECT_GE(label->height(), label->heightForWidth(label->width()));
                    }
                }
                press("tour_next");
            }
        }
    }
}

TEST_F(TourWindow, ComesOnceByItselfWhenTheStartPageIsPutAway) {
    parts().start.welcome();
    parts().tour.begin_at_first_start(!parts().start.page_is_shown());
    QApplication::processEvents();
    EXPECT_EQ(bubble(), nullptr) << "the page lies over the canvas";
    Q_EMIT canvas().escaped();
    QApplication::processEvents();
    ASSERT_NE(bubble(), nullptr);
    press("tour_leave");
    start_again();
    parts().start.welcome();
    parts().tour.begin_at_first_start(!parts().start.page_is_shown());
    Q_EMIT canvas().escaped();
    QApplication::processEvents();
    EXPECT_EQ(bubble(), nullptr) << "it was seen";
}

}  // namespace
}  // namespace pastoso::tests
