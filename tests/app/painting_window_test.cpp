// Strokes, undo, tilt: what the hand does in the window ends up as paint.
#include "app/window_fixture.hpp"

#include <QAction>
#include <QCoreApplication>
#include <QEvent>

namespace pastoso::tests {
namespace {

using commands::Command;

class PaintingWindow : public WindowTest {
  protected:
    static Pen pressed(double pressure) {
        Pen pen;
        pen.pressure = pressure;
        return pen;
    }
};

/// Paint that is not moved by gravity or yield while a test looks at it.
void hold_still(main::MainWindow& window) {
    window.studio().commands().action(Command::Pause)->trigger();
}

TEST_F(PaintingWindow, StandsReadyToPaint) {
    EXPECT_EQ(volume_mm3(), 0.0);
    const tools::Hand& hand = studio().easel().hand();
    EXPECT_EQ(hand.brush, "Flat bristle 20");
    EXPECT_EQ(hand.paint.ingredients.front().pigment, "PB29");
    EXPECT_EQ(hand.medium, document::UseMedium{"heavy-body oil"});
    EXPECT_EQ(hand.tilt.tilt_deg, 60.0);
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(PaintingWindow, AMouseStrokeEndsUpAsPaint) {
    hold_still(window());
    const QImage before = picture();
    mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    EXPECT_GT(volume_mm3(), 5.0);
    const QImage after = picture();
    EXPECT_GT(difference(before, after).largest, 100);
    // Ultramarine where the stroke went, bare canvas beside it.
    const double ratio = canvas().devicePixelRatioF();
    const QColor painted = after.pixelColor((ratio * canvas().widget_position({30.0, 20.0})).toPoint());
    EXPECT_GT(painted.blue(), painted.red() + 20);
    const QPoint beside = (ratio * canvas().widget_position({30.0, 37.0})).toPoint();
    EXPECT_EQ(after.pixel(beside), before.pixel(beside));
}

TEST_F(PaintingWindow, ARoundBrushPressedHarderPaintsAWiderLine) {
    hold_still(window());
    studio().easel().take_brush("Round sable 9", 9.0);
    const auto wet_cells = [this] {
        session().wait_until_applied();
        return film::wet_cell_count(session().snapshot()->film);
    };
    pen_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}), pressed(0.2));
    const std::int64_t light = wet_cells();
    EXPECT_GT(light, 100);
    studio().commands().action(Command::Undo)->trigger();
    ASSERT_EQ(wet_cells(), 0);
    pen_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}), pressed(0.9));
    EXPECT_GT(static_cast<double>(wet_cells()), 1.3 * static_cast<double>(light));
}

TEST_F(PaintingWindow, ThePensTiltAndPressureReachTheRecording) {
    Pen pen = pressed(0.625);
    pen.tilt_x_deg = 25;
    pen.tilt_y_deg = -40;
    pen_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}), pen);
    session().wait_until_applied();
    int samples = 0;
    double previous_s = -1.0;
    for (const document::Event& event : session().recording().events) {
        const auto* move = std::get_if<document::PenMove>(&event.action);
        if (move == nullptr) continue;
        ++samples;
        EXPECT_DOUBLE_EQ(move->sample.pressure, 0.625);
        EXPECT_DOUBLE_EQ(move->sample.tilt_x_deg, 25.0);
        EXPECT_DOUBLE_EQ(move->sample.tilt_y_deg, -40.0);
        EXPECT_GE(move->sample.time_s, previous_s);
        previous_s = move->sample.time_s;
    }
    EXPECT_GE(samples, 20);
    EXPECT_GT(previous_s, 0.1);
}

TEST_F(PaintingWindow, TheErasersEndDoesNoHarm) {
    Pen eraser;
    eraser.eraser_end = true;
    pen_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}), eraser);
    session().wait_until_applied();
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(PaintingWindow, UndoClearsTheStrokeFromTheScreenToo) {
    hold_still(window());
    const QImage before = picture();
    mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    settle();
    ASSERT_TRUE(studio().commands().action(Command::Undo)->isEnabled());
    studio().commands().action(Command::Undo)->trigger();
    EXPECT_EQ(volume_mm3(), 0.0);
    EXPECT_EQ(difference(picture(), before).largest, 0);
    EXPECT_TRUE(studio().commands().action(Command::Redo)->isEnabled());
}

TEST_F(PaintingWindow, LeavingInTheMiddleOfAStrokeIsNoHarm) {
    press({20.0, 20.0});
    move({30.0, 20.0});
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&canvas(), &leave);
    release({30.0, 20.0});
    session().wait_until_applied();
    EXPECT_FALSE(session().status().stroke_in_progress);
}

class RunnyPaint : public WindowTest {
  protected:
    document::CanvasSettings canvas_settings() const override {
        document::CanvasSettings canvas;
        canvas.width_mm = 60.0;
        canvas.height_mm = 40.0;
        canvas.px_per_mm = 2.0;
        canvas.support = "panel";
        return canvas;
    }

    double centroid_y_mm() {
        const auto snapshot = session().snapshot();
        const film::FilmState& film = snapshot->film;
        double sum = 0.0, moment = 0.0;
        for (int y = 0; y < film.shape.height; ++y) {
            for (int x = 0; x < film.shape.width; ++x) {
                const double thickness = film.thickness.at(x, y);
                sum += thickness;
                moment += thickness * (y + 0.5) * film.cell_mm;
            }
        }
        return moment / sum;
    }
};

TEST_F(RunnyPaint, TiltMakesHousePaintRunDownTheCanvas) {
    for (int i = 0; i < 3; ++i)
        action(Command::TimeFaster)->trigger();
    studio().easel().use_medium("house paint");
    studio().easel().tilt(0.0, 90.0);
    for (int i = 0; i < 8; ++i)  // thick paint runs fast
        mouse_stroke(line_mm({15.0, 12.0}, {45.0, 12.0}));
    session().wait_until_applied();
    const double start_mm = centroid_y_mm();
    studio().easel().tilt(85.0, 90.0);
    wait_for([&] { return centroid_y_mm() > start_mm + 0.5; });
    studio().easel().tilt(85.0, -90.0);  // the other way up
    session().wait_until_applied();
    const double turned_mm = centroid_y_mm();
    wait_for([&] { return centroid_y_mm() < turned_mm - 0.2; });
}

TEST_F(RunnyPaint, PauseHoldsIt) {
    studio().easel().use_medium("house paint");
    mouse_stroke(line_mm({15.0, 12.0}, {45.0, 12.0}));
    hold_still(window());
    session().post(document::PenUp{});
    session().wait_until_applied();
    const std::uint64_t held = film::state_hash(session().snapshot()->film);
    studio().easel().tilt(85.0, 0.0);
    session().wait_until_applied();
    EXPECT_EQ(film::state_hash(session().snapshot()->film), held);
}

}  // namespace
}  // namespace pastoso::tests
