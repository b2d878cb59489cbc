// Moving over the canvas, and the commands.
#include "app/window_fixture.hpp"
#include "core/error.hpp"
#include "main/window_parts.hpp"

#include <cmath>
#include <optional>
#include <set>

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QWheelEvent>

namespace pastoso::tests {
namespace {

using commands::Command;

class Navigation : public WindowTest {
  protected:
    void turn_wheel(const QPointF& position, int notches) {
        QWheelEvent event(position, canvas().mapToGlobal(position), {}, {0, 120 * notches}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&canvas(), &event);
    }

    void hold_space(bool down) {
        QKeyEvent event(down ? QEvent::KeyPress : QEvent::KeyRelease, Qt::Key_Space, Qt::NoModifier);
        QApplication::sendEvent(&canvas(), &event);
    }
};

TEST_F(Navigation, TheWheelKeepsThePointUnderTheCursor) {
    const QPointF cursor(301.0, 155.0);
    const glm::dvec2 before = canvas().canvas_mm(cursor);
    for (const int notches : {1, 3, -2, -1, 4}) {
        turn_wheel(cursor, notches);
        const glm::dvec2 after = canvas().canvas_mm(cursor);
        EXPECT_NEAR(after.x, before.x, 1e-6);
        EXPECT_NEAR(after.y, before.y, 1e-6);
    }
    EXPECT_GT(canvas().view_transform().zoom, 1.0);
}

TEST_F(Navigation, AFittedCanvasIsDrawnWhereItLiesInTheWindowThatBecameLarger) {
    canvas().set_drawn_by(screen::DrawnBy::OpenGl);
    settle();
    const screen::ViewTransform before = canvas().view_transform();
    std::optional<screen::ViewTransform> drawn;
    // Comes between the new size and the frame that is drawn at once.
    QObject::connect(canvas().opengl(), &QOpenGLWidget::resized, &canvas(),
                     [&] { drawn = canvas().view_transform(); });
    window().resize(window().size() + QSize(60, 40));
    wait_for([&] { return drawn.has_value(); });
    EXPECT_FALSE(*drawn == before);
    EXPECT_TRUE(*drawn == canvas().view_transform());
}

TEST_F(Navigation, SpaceAndDragMoveTheCanvasAndPaintNothing) {
    const glm::dvec2 origin = canvas().view_transform().origin_px;
    hold_space(true);
    press({20.0, 20.0});
    const QPointF start = canvas().widget_position({20.0, 20.0});
    QMouseEvent drag(QEvent::MouseMove, start + QPointF(31.0, -17.0), canvas().mapToGlobal(start),
                     Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&canvas(), &drag);
    release({20.0, 20.0});
    hold_space(false);
    // Positions of the press are rounded to whole pixels.
    EXPECT_NEAR(canvas().view_transform().origin_px.x - origin.x, 31.0, 1.0);
    EXPECT_NEAR(canvas().view_transform().origin_px.y - origin.y, -17.0, 1.0);
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(Navigation, TheMiddleButtonPansToo) {
    const glm::dvec2 origin = canvas().view_transform().origin_px;
    press({20.0, 20.0}, Qt::MiddleButton);
    move({25.0, 20.0}, Qt::MiddleButton);
    release({25.0, 20.0}, Qt::MiddleButton);
    EXPECT_GT(canvas().view_transform().origin_px.x, origin.x + 5.0);
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(Navigation, FitAndActualPixels) {
    studio().commands().action(Command::ActualPixels)->trigger();
    EXPECT_DOUBLE_EQ(canvas().view_transform().zoom, 1.0);
    const glm::dvec2 origin = canvas().view_transform().origin_px;
    EXPECT_DOUBLE_EQ(origin.x, std::round(origin.x));
    studio().commands().action(Command::FitCanvas)->trigger();
    const QPointF first = canvas().widget_position({0.0, 0.0});
    const QPointF last = canvas().widget_position({60.0, 40.0});
    EXPECT_GE(first.x(), 0.0);
    EXPECT_GE(first.y(), 0.0);
    EXPECT_LE(last.x(), canvas().width());
    EXPECT_LE(last.y(), canvas().height());
}

TEST_F(Navigation, NoTwoCommandsOfAModeShareAKey) {
    for (const commands::Mode mode :
         {commands::Mode::Painting, commands::Mode::Tea, commands::Mode::Tank}) {
        std::set<QString> keys;
        for (const commands::CommandText& text : commands::command_list()) {
            if (!commands::meet(text.mode, mode)) continue;
            const QAction* action = studio().commands().action(text.command);
            for (const QKeySequence& key : action->shortcuts()) {
                EXPECT_TRUE(keys.insert(key.toString()).second) << key.toString().toStdString();
            }
        }
        EXPECT_GT(keys.size(), 10U);
    }
}

TEST_F(Navigation, BracketsChangeTheBrush) {
    const double width_mm = studio().easel().hand().brush_width_mm;
    studio().commands().action(Command::LargerBrush)->trigger();
    EXPECT_GT(studio().easel().hand().brush_width_mm, width_mm);
    studio().commands().action(Command::SmallerBrush)->trigger();
    studio().commands().action(Command::SmallerBrush)->trigger();
    EXPECT_LT(studio().easel().hand().brush_width_mm, width_mm);
    const std::string brush = studio().easel().hand().brush;
    studio().commands().action(Command::NextBrush)->trigger();
    EXPECT_NE(studio().easel().hand().brush, brush);
    session().wait_until_applied();
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(Navigation, ANewCanvasKeepsTheToolsAndCanBePainted) {
    mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    document::CanvasSettings other;
    other.width_mm = 30.0;
    other.height_mm = 50.0;
    other.px_per_mm = 3.0;
    other.support = "cotton duck";
    parts().files.new_canvas(other);
    loaded();
    settle();
    EXPECT_EQ(volume_mm3(), 0.0);
    mouse_stroke(line_mm({10.0, 10.0}, {20.0, 40.0}));
    EXPECT_GT(volume_mm3(), 1.0);
}

TEST_F(Navigation, ACanvasTooLargeForMemoryIsRefusedAndTheOldOneStays) {
    mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    document::CanvasSettings huge;
    huge.width_mm = 5000.0;
    huge.height_mm = 5000.0;
    huge.px_per_mm = 6.0;
    parts().files.new_canvas(huge);
    loaded();
    EXPECT_GT(volume_mm3(), 1.0);
}

}  // namespace
}  // namespace pastoso::tests
