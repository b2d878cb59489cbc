// Mouse, pen and fingers beside one another in the real window.
#include "app/latest_stroke.hpp"
#include "app/window_fixture.hpp"
#include "document/actions/actions.hpp"

#include <algorithm>

#include <QAction>
#include <QApplication>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTest>

namespace pastoso::tests {
namespace {

using commands::Command;

class HandWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        static QPointingDevice* const screen = QTest::createTouchDevice();
        screen_ = screen;
        action(Command::Pause)->trigger();
    }

    auto touch() { return QTest::touchEvent(&canvas(), screen_); }
    QPoint at(double x_mm, double y_mm) { return canvas().widget_position({x_mm, y_mm}).toPoint(); }

    void drag_finger(const QPoint& from, const QPoint& way) {
        touch().press(0, from);
        for (int i = 1; i <= 10; ++i)
            touch().move(0, from + i * way / 10);
        touch().release(0, from + way);
    }
    void tap(int fingers) {
        const QPoint first = at(30.0, 20.0);
        auto down = touch();
        for (int i = 0; i < fingers; ++i)
            down.press(i, first + QPoint(40 * i, 5));
        down.commit();
        auto up = touch();
        for (int i = 0; i < fingers; ++i)
            up.release(i, first + QPoint(40 * i, 5));
        up.commit();
        settle();
    }
    void let_fingers_paint() {
        tools::PenSettings pen = canvas().pen();
        pen.fingers_paint = true;
        canvas().set_pen(pen);
    }
    void set_button(tools::PenButton button, const tools::PenAction& action) {
        tools::PenSettings pen = canvas().pen();
        pen.buttons[static_cast<std::size_t>(button)] = action;
        canvas().set_pen(pen);
    }

    std::int64_t strokes() {
        session().wait_until_applied();
        return session().status().strokes;
    }

    std::vector<brush::PenSample> latest_stroke() { return tests::latest_stroke(session()); }
    std::vector<glm::dvec2> latest_stroke_mm() {
        std::vector<glm::dvec2> places;
        for (const brush::PenSample& sample : latest_stroke())
            places.emplace_back(sample.x_mm, sample.y_mm);
        return places;
    }
    std::vector<double> latest_stroke_s() {
        std::vector<double> times_s;
        for (const brush::PenSample& sample : latest_stroke())
            times_s.push_back(sample.time_s);
        return times_s;
    }

    QPointingDevice* screen_ = nullptr;
};

TEST_F(HandWindow, APalmNeitherEndsNorBendsThePensStroke) {
    Pen pen;
    const QPoint palm = at(50.0, 35.0);
    const screen::ViewTransform view = canvas().view_transform();
    pen_at({15.0, 20.0}, Qt::LeftButton, pen);
    touch().press(0, palm).press(1, palm + QPoint(60, 10));
    for (int i = 1; i <= 20; ++i) {
        pen_at({15.0 + i, 20.0}, Qt::LeftButton, pen);
        touch().move(0, palm - QPoint(3 * i, 0)).move(1, palm + QPoint(60, 10 + 3 * i));
        if (i == 10) QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at(40.0, 10.0));
    }
    touch().release(0, palm).release(1, palm);
    EXPECT_TRUE(studio().easel().painting());
    pen_at({35.0, 20.0}, Qt::NoButton, pen);
    EXPECT_FALSE(studio().easel().painting());
    EXPECT_EQ(canvas().view_transform(), view);
    EXPECT_EQ(strokes(), 1);
    for (const glm::dvec2& place : latest_stroke_mm())
        EXPECT_NEAR(place.y, 20.0, 1e-6);
}

TEST_F(HandWindow, APenTakesOverFromAFingerThatMovesTheCanvas) {
    const QPoint from = at(30.0, 30.0);
    touch().press(0, from);
    touch().move(0, from + QPoint(30, 0));
    const screen::ViewTransform view = canvas().view_transform();
    Pen pen;
    pen_at({15.0, 20.0}, Qt::LeftButton, pen);
    touch().move(0, from + QPoint(90, 40));
    pen_at({25.0, 20.0}, Qt::LeftButton, pen);
    EXPECT_EQ(canvas().view_transform(), view);
    touch().release(0, from + QPoint(90, 40));
    pen_at({25.0, 20.0}, Qt::NoButton, pen);
    EXPECT_EQ(strokes(), 1);
    EXPECT_GT(volume_mm3(), 1.0);
}

TEST_F(HandWindow, AFingerMovesTheCanvasAndPaintsOnlyWhereThatIsWanted) {
    const glm::dvec2 below = canvas().canvas_mm(at(20.0, 20.0));
    const QPoint from = at(20.0, 20.0), way(60, 30);
    drag_finger(from, way);
    EXPECT_EQ(volume_mm3(), 0.0);
    EXPECT_LT(glm::distance(canvas().canvas_mm(from + way), below), 0.2);
    let_fingers_paint();
    const screen::ViewTransform view = canvas().view_transform();
    drag_finger(from, way);
    EXPECT_GT(volume_mm3(), 1.0);
    EXPECT_EQ(canvas().view_transform(), view);
    EXPECT_FALSE(session().status().stroke_in_progress);
}

TEST_F(HandWindow, ASecondFingerDoesNotEndWhatOnePaints) {
    let_fingers_paint();
    const screen::ViewTransform view = canvas().view_transform();
    const QPoint from = at(15.0, 20.0);
    touch().press(0, from);
    for (int x = 10; x <= 120; x += 10)
        touch().move(0, from + QPoint(x, 0));
    touch().stationary(0).press(1, from + QPoint(0, 90));
    touch().stationary(0).move(1, from + QPoint(50, 120));
    touch().release(0, from + QPoint(120, 0)).release(1, from);
    EXPECT_EQ(canvas().view_transform(), view);
    EXPECT_GT(volume_mm3(), 2.0);
    EXPECT_FALSE(session().status().stroke_in_progress);
}

TEST_F(HandWindow, TwoFingersMoveTurnAndZoomTheCanvas) {
    const QPoint a = at(20.0, 20.0), b = a + QPoint(120, 10);
    const QPoint a2 = a + QPoint(20, -15), b2 = b + QPoint(30, 60);
    const glm::dvec2 below_a = canvas().canvas_mm(a), below_b = canvas().canvas_mm(b);
    touch().press(0, a).press(1, b);
    touch().move(0, (a + a2) / 2).move(1, (b + b2) / 2);
    touch().move(0, a2).move(1, b2);
    touch().release(0, a2).release(1, b2);
    EXPECT_LT(glm::distance(canvas().canvas_mm(a2), below_a), 1e-6);
    EXPECT_LT(glm::distance(canvas().canvas_mm(b2), below_b), 1e-6);
    EXPECT_GT(canvas().view_transform().angle_deg, 10.0);
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(HandWindow, TwoFingersTapToUndoAndThreeToRedo) {
    mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    const double painted_mm3 = volume_mm3();
    ASSERT_GT(painted_mm3, 1.0);
    tap(2);
    EXPECT_EQ(volume_mm3(), 0.0);
    tap(4);
    EXPECT_EQ(volume_mm3(), 0.0) << "four mean nothing";
    tap(3);
    EXPECT_EQ(volume_mm3(), painted_mm3);
}

TEST_F(HandWindow, AFingerThatIsHeldPicksPaint) {
    mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    studio().easel().choose_paint({{{"PR101", 1.0}}, 1.0});
    settle();
    touch().press(0, at(30.0, 20.0));
    wait_for([&] { return studio().easel().hand().paint.ingredients.front().pigment == "PB29"; });
    touch().move(0, at(45.0, 30.0));
    touch().release(0, at(45.0, 30.0));
    EXPECT_EQ(strokes(), 1);
}

TEST_F(HandWindow, AFingerDragsHandlesEvenWhereItDoesNotPaint) {
    action(Command::Ruler)->trigger();
    settle();
    const brush::Ruler before = *studio().easel().hand().ruler();
    drag_finger(canvas().widget_position({before.x1_mm, before.y1_mm}).toPoint(), {0, 40});
    EXPECT_GT(studio().easel().hand().ruler()->y1_mm, before.y1_mm + 1.0);
}

TEST_F(HandWindow, AnyCommandIsOnAnyButtonOfThePen) {
    mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    ASSERT_GT(volume_mm3(), 1.0);
    set_button(tools::PenButton::Third, {tools::PenButtonDoes::Command, "undo"});
    Pen air;
    air.pressure = 0.0;
    pen_at({20.0, 30.0}, Qt::NoButton, air);
    pen_at({20.0, 30.0}, Qt::ExtraButton1, air);
    pen_at({20.0, 30.0}, Qt::NoButton, air);
    EXPECT_EQ(volume_mm3(), 0.0);
    set_button(tools::PenButton::Lower, {tools::PenButtonDoes::Command, "redo"});
    pen_at({20.0, 30.0}, Qt::MiddleButton, air);
    pen_at({20.0, 30.0}, Qt::NoButton, air);
    EXPECT_GT(volume_mm3(), 1.0);
}

TEST_F(HandWindow, AButtonHeldByAccidentDoesNotKeepTheTipFromPainting) {
    set_button(tools::PenButton::Lower, {});
    Pen pen;
    pen_at({15.0, 20.0}, Qt::MiddleButton, pen);
    pen_at({15.0, 20.0}, Qt::MiddleButton | Qt::LeftButton, pen);
    for (int i = 1; i <= 20; ++i)
        pen_at({15.0 + i, 20.0}, Qt::MiddleButton | Qt::LeftButton, pen);
    pen_at({35.0, 20.0}, Qt::NoButton, pen);
    EXPECT_GT(volume_mm3(), 1.0);
    EXPECT_FALSE(studio().easel().painting());
}

TEST_F(HandWindow, APenOfAThousandSamplesASecondLosesNoneThatWaited) {
    const std::vector<glm::dvec2> path = line_mm({10.0, 10.0}, {50.0, 30.0}, 1000);
    pen_stroke_at_once(path, {}, 1);
    const std::vector<glm::dvec2> told = latest_stroke_mm();
    ASSERT_EQ(told.size(), path.size() + 1);  // the place where it lifts
    for (std::size_t i = 0; i < path.size(); ++i) {
        EXPECT_NEAR(told[i].x, path[i].x, 1e-6);
        EXPECT_NEAR(told[i].y, path[i].y, 1e-6);
    }
    const std::vector<double> times_s = latest_stroke_s();
    for (std::size_t i = 1; i < path.size(); ++i)
        EXPECT_NEAR(times_s[i] - times_s[i - 1], 0.001, 1e-9);
}

TEST_F(HandWindow, TheWheelOfAnAirbrushMakesTheBrushWider) {
    const double before_mm = studio().easel().hand().brush_width_mm;
    Q_EMIT canvas().wheel_turned(2);
    const double wide_mm = studio().easel().hand().brush_width_mm;
    EXPECT_GT(wide_mm, before_mm);
    Q_EMIT canvas().wheel_turned(-2);
    EXPECT_LT(studio().easel().hand().brush_width_mm, wide_mm);
}

/// A pen that lifts elsewhere than where it was last seen ends its stroke there, as a mouse does.
TEST_F(HandWindow, PenMouseAndFingerEndWhereTheyLift) {
    let_fingers_paint();
    const auto ends_at = [&](const char* device) {
        EXPECT_LT(glm::distance(latest_stroke_mm().back(), {40.0, 25.0}), 0.3) << device;
    };
    press({15.0, 20.0});
    move({25.0, 20.0});
    release({40.0, 25.0});
    ends_at("mouse");
    Pen pen, lifted;
    lifted.pressure = 0.0;
    pen_at({15.0, 20.0}, Qt::LeftButton, pen);
    pen_at({25.0, 20.0}, Qt::LeftButton, pen);
    pen_at({40.0, 25.0}, Qt::NoButton, lifted);
    ends_at("pen");
    touch().press(0, at(15.0, 20.0));
    touch().move(0, at(25.0, 20.0));
    touch().move(0, at(40.0, 25.0));
    touch().release(0, at(40.0, 25.0));
    ends_at("finger");
}

// The fixture's tip tells its tilt, its eraser end does not.
TEST_F(HandWindow, APenWithoutTiltIsHeldAsTheHandHoldsATool) {
    tools::PenSettings pen = canvas().pen();
    pen.eraser_tool = "";
    canvas().set_pen(pen);
    studio().easel().set_tilted(true);
    pen_stroke(line_mm({10.0, 20.0}, {40.0, 20.0}), {.tilt_x_deg = 10, .eraser_end = false});
    for (const brush::PenSample& sample : latest_stroke())
        EXPECT_EQ(sample.tilt_x_deg, 10.0);
    pen_stroke(line_mm({10.0, 10.0}, {40.0, 10.0}), {.eraser_end = true});
    const std::vector<brush::PenSample> aslant = latest_stroke();
    ASSERT_FALSE(aslant.empty());
    for (const brush::PenSample& sample : aslant) {
        EXPECT_GT(sample.tilt_x_deg, 20.0);
        EXPECT_EQ(sample.tilt_x_deg, aslant.front().tilt_x_deg);
        EXPECT_EQ(sample.tilt_y_deg, sample.tilt_x_deg);
    }
    studio().easel().set_tilted(false);
    pen_stroke(line_mm({10.0, 30.0}, {40.0, 30.0}), {.eraser_end = true});
    for (const brush::PenSample& sample : latest_stroke())
        EXPECT_EQ(sample.tilt_x_deg, 0.0) << "upright";
}

}  // namespace
}  // namespace pastoso::tests
