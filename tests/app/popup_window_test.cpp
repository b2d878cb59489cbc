// The palette that a right click opens around the pointer.
#include "app/window_fixture.hpp"
#include "panels/popup/popup_palette.hpp"
#include "panels/popup/ring_places.hpp"
#include "panels/popup/round_button.hpp"

#include <algorithm>
#include <cmath>

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QScreen>
#include <QTest>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using panels::RoundButton;

class PopupWindow : public WindowTest {
  protected:
    panels::PopupPalette& palette() { return *window().findChild<panels::PopupPalette*>(); }
    bool is_open() {
        const auto* palette = window().findChild<panels::PopupPalette*>();
        return palette != nullptr && palette->isVisible();
    }
    void open() {
        press({30.0, 20.0}, Qt::RightButton);
        release({30.0, 20.0}, Qt::RightButton);
        ASSERT_TRUE(is_open());
        wait_until_shown(palette());
    }
    QList<RoundButton*> buttons(const char* name) {
        return palette().findChildren<RoundButton*>(QString::fromUtf8(name));
    }
    RoundButton& tool(const char* name) {
        for (RoundButton* button : buttons("popup_tool"))
            if (button->toolTip() == QLatin1String(name)) return *button;
        ADD_FAILURE() << "no " << name;
        return *buttons("popup_tool")[0];
    }
    std::string focused() {
        const QWidget* there = palette().focusWidget();
        return there == nullptr ? "" : there->objectName().toStdString();
    }
    void key(Qt::Key key) {
        QTest::keyClick(window().windowHandle(), key);
        QApplication::processEvents();
    }
    const tools::Hand& hand() { return studio().easel().hand(); }
};

TEST_F(PopupWindow, ARightClickOpensItAroundThePointerAndPaintsNothing) {
    open();
    const QPoint middle = palette().geometry().center();
    const QPoint pointer = canvas().mapToGlobal(canvas().widget_position({30.0, 20.0})).toPoint();
    EXPECT_LE((middle - pointer).manhattanLength(), 2);
    EXPECT_TRUE(tool("Flat bristle 20").isChecked());
    EXPECT_EQ(palette().findChild<QLabel*>("popup_width")->text(), "20 mm");
    EXPECT_FALSE(studio().easel().painting());
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(PopupWindow, AToolIsTakenAtAClick) {
    open();
    QTest::mouseClick(&tool("Round sable 9"), Qt::LeftButton);
    EXPECT_FALSE(is_open());
    EXPECT_EQ(hand().brush, "Round sable 9");
    EXPECT_EQ(hand().brush_width_mm, 9.0);
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(PopupWindow, APaintIsTakenAtAClick) {
    studio().easel().choose_paint({{{"PR101", 1.0}}, 1.0});
    open();
    RoundButton* other = nullptr;
    for (RoundButton* button : buttons("popup_paint"))
        if (button->colour().isValid() && button->colour() != buttons("popup_first_paint")[0]->colour())
            other = button;
    ASSERT_NE(other, nullptr);
    const QString words = other->toolTip();
    QTest::mouseClick(other, Qt::LeftButton);
    EXPECT_FALSE(is_open());
    open();
    EXPECT_EQ(buttons("popup_first_paint")[0]->toolTip(), words);
    EXPECT_NE(hand().paint.ingredients.front().pigment, "PR101");
}

TEST_F(PopupWindow, SwapsPaintsAndStepsTheWidth) {
    const auto first = hand().paint, second = hand().second_paint;
    open();
    QTest::mouseClick(buttons("popup_wider")[0], Qt::LeftButton);
    EXPECT_TRUE(is_open());
    EXPECT_GT(hand().brush_width_mm, 20.0);
    const QString width = palette().findChild<QLabel*>("popup_width")->text();
    EXPECT_TRUE(width.startsWith(QString::number(hand().brush_width_mm, 'g', 3)));
    QTest::mouseClick(buttons("popup_second_paint")[0], Qt::LeftButton);
    EXPECT_FALSE(is_open());
    EXPECT_EQ(hand().paint, second);
    EXPECT_EQ(hand().second_paint, first);
}

TEST_F(PopupWindow, GivesCommands) {
    action(Command::Pause)->trigger();
    open();
    EXPECT_EQ(buttons("popup_command").size(), 4);
    EXPECT_FALSE(buttons("popup_command")[0]->isEnabled());  // nothing to take back
    key(Qt::Key_Escape);
    mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    settle();
    open();
    ASSERT_TRUE(buttons("popup_command")[0]->isEnabled());
    QTest::mouseClick(buttons("popup_command")[0], Qt::LeftButton);
    QApplication::processEvents();
    EXPECT_FALSE(is_open());
    EXPECT_EQ(volume_mm3(), 0.0);
    open();
    QTest::mouseClick(buttons("popup_command")[2], Qt::LeftButton);
    QApplication::processEvents();
    EXPECT_TRUE(canvas().view_transform().mirrored);
}

TEST_F(PopupWindow, EscapeClosesItAndKeysGoToTheCanvasAgain) {
    open();
    key(Qt::Key_Escape);
    EXPECT_FALSE(is_open());
    const double width_mm = hand().brush_width_mm;
    canvas().setFocus();
    key(Qt::Key_BracketRight);
    EXPECT_GT(hand().brush_width_mm, width_mm);
    EXPECT_EQ(hand().brush, "Flat bristle 20");
}

TEST_F(PopupWindow, KeysGoThroughItsRings) {
    canvas().setFocus();
    key(Qt::Key_Menu);
    ASSERT_TRUE(is_open());
    wait_until_shown(palette());
    EXPECT_EQ(focused(), "popup_tool");
    key(Qt::Key_Down);
    EXPECT_EQ(focused(), "popup_paint");
    key(Qt::Key_Down);
    EXPECT_EQ(focused(), "popup_second_paint");
    key(Qt::Key_Right);
    EXPECT_EQ(focused(), "popup_narrower");
    key(Qt::Key_Tab);
    EXPECT_EQ(focused(), "popup_command");
    key(Qt::Key_Down);
    EXPECT_EQ(focused(), "popup_tool");
    key(Qt::Key_Right);
    const QString wanted = static_cast<RoundButton*>(palette().focusWidget())->toolTip();
    key(Qt::Key_Return);
    EXPECT_FALSE(is_open());
    EXPECT_EQ(QString::fromStdString(hand().brush), wanted);
}

TEST_F(PopupWindow, APenBesideItClosesItAndPaintsNothing) {
    Pen pen;
    pen.pressure = 0.0;
    pen_at({30.0, 20.0}, Qt::NoButton, pen);
    pen_at({30.0, 20.0}, Qt::RightButton, pen);
    pen_at({30.0, 20.0}, Qt::NoButton, pen);
    ASSERT_TRUE(is_open());
    pen_stroke(line_mm({5.0, 35.0}, {55.0, 35.0}), {.pressure = 0.6});
    EXPECT_FALSE(is_open());
    EXPECT_EQ(volume_mm3(), 0.0);
    pen_stroke(line_mm({5.0, 35.0}, {55.0, 35.0}), {.pressure = 0.6});
    EXPECT_GT(volume_mm3(), 5.0);
}

TEST_F(PopupWindow, TheToolsOfTheLastTimeAreThereAgain) {
    studio().easel().take_brush("Straw 8", 8.0);
    action(Command::LargerBrush)->trigger();  // shows the hand
    start_again();
    open();
    EXPECT_EQ(tool("Straw 8").toolTip(), "Straw 8");
}

TEST_F(PopupWindow, ThumbnailsArePainted) {
    open();
    const auto shades = [&] {
        const QImage face = tool("Round sable 9").grab().toImage();
        int least = 255, most = 0;
        // A stroke of the tool lies across the middle, where its hairs may leave a gap.
        for (int y = 2 * face.height() / 5; y < 3 * face.height() / 5; ++y) {
            for (int x = 12; x < face.width() - 12; ++x) {
                const int grey = qGray(face.pixel(x, y));
                least = std::min(least, grey);
                most = std::max(most, grey);
            }
        }
        return most - least;
    };
    wait_for([&] { return shades() > 60; });
}

TEST(RingPlaces, LieOnTheirArc) {
    const auto places = panels::ring_places(5, 10.0, 0.0, 180.0);
    ASSERT_EQ(places.size(), 5U);
    EXPECT_NEAR(places[0].x(), 10.0, 1e-9);
    EXPECT_NEAR(places[2].y(), 10.0, 1e-9);
    EXPECT_NEAR(places[4].x(), -10.0, 1e-9);
    const auto around = panels::ring_places(4, 1.0, -90.0, 270.0);
    EXPECT_NEAR(around[0].y(), -1.0, 1e-9);
    EXPECT_NEAR(around[1].x(), 1.0, 1e-9);
    EXPECT_NEAR(around[3].x(), -1.0, 1e-9);
    EXPECT_EQ(panels::ring_places(1, 1.0, 0.0, 90.0).size(), 1U);
}

TEST(RingPlaces, AWindowStaysOnTheScreen) {
    const QRect screen(100, 0, 800, 600);
    const QSize size(200, 200);
    EXPECT_EQ(panels::corner_on_screen({500, 300}, size, screen), QPoint(400, 200));
    EXPECT_EQ(panels::corner_on_screen({110, 5}, size, screen), QPoint(100, 0));
    EXPECT_EQ(panels::corner_on_screen({899, 599}, size, screen), QPoint(700, 400));
    EXPECT_EQ(panels::corner_on_screen({500, 300}, {2000, 2000}, screen), QPoint(100, 0));
}

}  // namespace
}  // namespace pastoso::tests
