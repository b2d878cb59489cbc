// The tour: its steps, where they stand, and when it comes by itself.
#include "app/window_fixture.hpp"
#include "help/tour_bubble.hpp"
#include "main/program/language.hpp"
#include "main/window_parts.hpp"
#include "panels/paint/paint_panel.hpp"

#include <set>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTest>
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
    mouse_stroke(line_mm({12.0, 12.0}, {48.0, 30.0}));
    settle();
    EXPECT_GT(volume_mm3(), before_mm3);
    press("tour_next");
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
