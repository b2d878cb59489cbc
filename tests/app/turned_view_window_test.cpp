// A canvas that is turned and mirrored on the screen, fingers, and the canvas alone in the window.
#include "app/window_fixture.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMenuBar>
#include <QPointingDevice>
#include <QStatusBar>
#include <QTest>
#include <QToolBar>
#include <QWheelEvent>

namespace pastoso::tests {
namespace {

using commands::Command;

class TurnedView : public WindowTest {
  protected:
    void give(Command command) { action(command)->trigger(); }

    /// Through the window, as a key on the keyboard is.
    void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        canvas().setFocus();
        QTest::keyClick(&canvas(), static_cast<Qt::Key>(key), modifiers);
    }

    void hold_space(bool down) {
        QKeyEvent event(down ? QEvent::KeyPress : QEvent::KeyRelease, Qt::Key_Space, Qt::ShiftModifier);
        QApplication::sendEvent(&canvas(), &event);
    }

    void drag(const QPointF& from, const QPointF& to, Qt::KeyboardModifiers modifiers) {
        const auto send = [&](QEvent::Type type, const QPointF& position, Qt::MouseButtons buttons) {
            const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
            QMouseEvent event(type, position, canvas().mapToGlobal(position), button, buttons,
                              modifiers);
            QApplication::sendEvent(&canvas(), &event);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton);
        send(QEvent::MouseMove, 0.5 * (from + to), Qt::LeftButton);
        send(QEvent::MouseMove, to, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, to, Qt::NoButton);
    }

    QPointF centre() { return {0.5 * canvas().width(), 0.5 * canvas().height()}; }

    /// Where the wet paint lies, in millimetres.
    glm::dvec2 paint_centre_mm() {
        session().wait_until_applied();
        const film::FilmState film = session().snapshot()->film;
        glm::dvec2 sum{};
        double volume = 0.0;
        for (int y = 0; y < film.shape.height; ++y) {
            for (int x = 0; x < film.shape.width; ++x) {
                const double thickness = film::thickness_mm(film.thickness.at(x, y));
                sum += thickness * film.cell_mm * glm::dvec2(x + 0.5, y + 0.5);
                volume += thickness;
            }
        }
        return sum / volume;
    }

    struct Seen {
        QImage image;
        screen::ViewTransform view;
    };
    Seen seen() {
        const QImage image = picture();
        return {image, canvas().view_transform()};
    }

    /// The pixels of the canvas in one picture with those in another that lie there.
    PictureDifference compared(const Seen& a, const Seen& b) {
        PictureDifference result;
        int pixels = 0;
        for (int y = 0; y < a.image.height(); ++y) {
            for (int x = 0; x < a.image.width(); ++x) {
                const glm::dvec2 cell = a.view.cell_from_device({x + 0.5, y + 0.5});
                if (cell.x < 1.0 || cell.y < 1.0 || cell.x > 239.0 || cell.y > 159.0) continue;
                const glm::dvec2 there = b.view.device_from_cell(cell);
                const QPoint px(static_cast<int>(std::floor(there.x)),
                                static_cast<int>(std::floor(there.y)));
                if (!b.image.rect().contains(px)) continue;
                const QColor one = a.image.pixelColor(x, y), other = b.image.pixelColor(px);
                const int apart =
                    std::max({std::abs(one.red() - other.red()), std::abs(one.green() - other.green()),
                              std::abs(one.blue() - other.blue())});
                result.largest = std::max(result.largest, apart);
                result.mean += apart;
                ++pixels;
            }
        }
        EXPECT_GT(pixels, 10000);
        result.mean /= pixels;
        return result;
    }
};

TEST_F(TurnedView, KeysTurnStepByStepAndPutUpright) {
    const screen::ViewTransform fitted = canvas().view_transform();
    key(Qt::Key_6);
    EXPECT_EQ(canvas().view_transform().angle_deg, 15.0);
    key(Qt::Key_4);
    key(Qt::Key_4);
    EXPECT_EQ(canvas().view_transform().angle_deg, -15.0);
    key(Qt::Key_5);
    EXPECT_EQ(canvas().view_transform(), fitted);
    key(Qt::Key_M);
    EXPECT_TRUE(canvas().view_transform().mirrored);
    EXPECT_TRUE(action(Command::MirrorView)->isChecked());
    key(Qt::Key_M);
    EXPECT_EQ(canvas().view_transform(), fitted);
    EXPECT_FALSE(action(Command::MirrorView)->isChecked());
}

TEST_F(TurnedView, ShiftSpaceAndADragTurnTheCanvasUnderTheHand) {
    const glm::dvec2 held = canvas().canvas_mm(centre() + QPointF(150.0, 0.0));
    hold_space(true);
    drag(centre() + QPointF(150.0, 0.0), centre() + QPointF(90.0, 120.0), Qt::ShiftModifier);
    hold_space(false);
    const glm::dvec2 there = canvas().canvas_mm(centre() + QPointF(90.0, 120.0));
    EXPECT_NEAR(there.x, held.x, 1e-6);
    EXPECT_NEAR(there.y, held.y, 1e-6);
    EXPECT_NEAR(canvas().view_transform().angle_deg, 53.130102, 1e-5);  // atan(4/3)
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(TurnedView, TheWheelKeepsThePointUnderTheCursorThere) {
    give(Command::TurnRight);
    give(Command::MirrorView);
    const QPointF cursor(301.0, 155.0);
    const glm::dvec2 before = canvas().canvas_mm(cursor);
    QWheelEvent event(cursor, canvas().mapToGlobal(cursor), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&canvas(), &event);
    EXPECT_NEAR(canvas().canvas_mm(cursor).x, before.x, 1e-6);
    EXPECT_NEAR(canvas().canvas_mm(cursor).y, before.y, 1e-6);
}

TEST_F(TurnedView, AStrokeLandsWhereThePointerWas) {
    window().resize(1180, 755);
    canvas().fit();
    give(Command::Pause);
    for (int i = 0; i < 3; ++i)
        give(Command::TurnRight);
    give(Command::MirrorView);
    studio().easel().take_brush("Round sable 9", 5.0);
    // Along a level line of the screen.
    const QPointF from = centre() + QPointF(-110.0, 20.0), to = centre() + QPointF(90.0, 20.0);
    const QImage before = picture();
    mouse_stroke(line_mm(canvas().canvas_mm(from), canvas().canvas_mm(to)));
    EXPECT_GT(volume_mm3(), 1.0);
    const QImage after = picture();
    const glm::dvec2 middle = canvas().canvas_mm(0.5 * (from + to)), paint = paint_centre_mm();
    // Half the brush's width: more paint may lie on one side, and where the stroke starts.
    EXPECT_NEAR(paint.x, middle.x, 2.5);
    EXPECT_NEAR(paint.y, middle.y, 2.5);
    const double ratio = canvas().devicePixelRatioF();
    const QColor painted = after.pixelColor((ratio * 0.5 * (from + to)).toPoint());
    EXPECT_GT(painted.blue(), painted.red() + 20);
    const QPoint beside = (ratio * (0.5 * (from + to) + QPointF(0.0, 90.0))).toPoint();
    EXPECT_EQ(after.pixel(beside), before.pixel(beside));
}

TEST_F(TurnedView, AStrokeOnATurnedCanvasIsThatOfTheSamePlaces) {
    give(Command::Pause);
    give(Command::TurnWithStroke);  // stands as the hand holds it
    give(Command::TurnRight);
    const std::vector<glm::dvec2> path = line_mm({15.0, 20.0}, {45.0, 22.0});
    pen_stroke(path, {.pressure = 0.5, .tilt_x_deg = 30});
    session().wait_until_applied();
    int samples = 0;
    for (const document::Event& event : session().recording().events) {
        const auto* move = std::get_if<document::PenMove>(&event.action);
        if (move == nullptr) continue;
        ++samples;
        EXPECT_NEAR(move->sample.rotation_deg, -15.0, 1e-9);
        const double lean = std::tan(std::acos(-1.0) / 6.0);
        EXPECT_NEAR(std::tan(core::radians(move->sample.tilt_x_deg)),
                    lean * std::cos(core::radians(15.0)), 1e-9);
        EXPECT_NEAR(std::tan(core::radians(move->sample.tilt_y_deg)),
                    -lean * std::sin(core::radians(15.0)), 1e-9);
        EXPECT_NEAR(move->sample.y_mm, 20.0 + (move->sample.x_mm - 15.0) / 15.0, 0.1);
    }
    EXPECT_GE(samples, 20);
}

/// Every pixel takes the same samples of the surface, in another order: rounding in single precision may
/// move a value across the border of two levels.
TEST_F(TurnedView, AQuarterTurnAndAMirrorShowTheSamePixels) {
    give(Command::Pause);
    mouse_stroke(line_mm({15.0, 12.0}, {45.0, 27.0}));
    const Seen upright = seen();
    give(Command::MirrorView);
    EXPECT_LE(difference(picture(), upright.image.mirrored(true, false)).largest, 1);
    give(Command::MirrorView);
    canvas().turn_about_centre(180.0);
    EXPECT_LE(compared(seen(), upright).largest, 1);
    canvas().turn_about_centre(-90.0);
    EXPECT_LE(compared(seen(), upright).largest, 1);
    canvas().mirror();
    EXPECT_LE(compared(seen(), upright).largest, 1);
}

/// Pixels askew lie up to 0.7 of one, less than a fifth of a cell, beside those upright, over which the
/// smooth surface changes little but where paint ends.
TEST_F(TurnedView, AnyAngleShowsTheSamePicture) {
    give(Command::Pause);
    mouse_stroke(line_mm({15.0, 12.0}, {45.0, 27.0}));
    canvas().zoom_about_centre(4.0 / canvas().view_transform().zoom);
    const Seen upright = seen();
    canvas().turn_about_centre(37.0);
    canvas().mirror();
    const Seen askew = seen();
    const double apart = compared(askew, upright).mean;
    Seen elsewhere = upright;
    elsewhere.view.origin_px += 8.0;  // half a millimetre
    EXPECT_LT(apart, 0.3 * compared(askew, elsewhere).mean);
    EXPECT_LT(apart, 2.0);
}

/// What is moved along on the screen, and refined, is what is shaded anew.
class MovedPicture : public TurnedView {
  protected:
    void SetUp() override {
        TurnedView::SetUp();
        give(Command::Pause);
        mouse_stroke(line_mm({10.0, 10.0}, {45.0, 30.0}));
        picture();
    }
    void expect_as_shaded_anew(const char* after) {
        const QImage moved = picture();
        canvas().set_lighting(canvas().lighting());
        const PictureDifference apart = difference(picture(), moved);
        EXPECT_EQ(apart.largest, 0) << after;
    }
};

TEST_F(MovedPicture, IsTheOneShadedAnew) {
    canvas().pan({37.0, -21.0});
    expect_as_shaded_anew("a way of whole pixels");
    canvas().pan({-250.0, 130.0});
    canvas().pan({3.0, 4.0});
    expect_as_shaded_anew("two ways in a frame");
    canvas().pan({0.4, -7.3});
    expect_as_shaded_anew("a way of parts of pixels");
    canvas().zoom_about_centre(1.7);
    expect_as_shaded_anew("zooming in");
    canvas().zoom_about_centre(0.4);
    canvas().pan({20.0, 11.0});
    expect_as_shaded_anew("zooming out, and a way");
    canvas().turn_about_centre(33.0);
    expect_as_shaded_anew("turning");
    canvas().mirror();
    expect_as_shaded_anew("mirroring");
}

TEST_F(MovedPicture, PaintThatComesInTheSameFrameLiesWhereItIs) {
    give(Command::Pause);
    press({10.0, 35.0});
    for (int i = 1; i <= 60; ++i) {
        move({10.0 + 0.6 * i, 35.0 - 0.4 * i});
        canvas().pan(i % 2 == 0 ? glm::dvec2(120.0, -90.0) : glm::dvec2(-120.0, 90.0));
        QTest::qWait(5);
    }
    release({46.0, 11.0});
    give(Command::Pause);
    expect_as_shaded_anew("painting and panning at once");
}

TEST_F(MovedPicture, PaintThatComesMeanwhileLiesWhereItIs) {
    canvas().pan({60.0, 0.0});
    mouse_stroke(line_mm({10.0, 30.0}, {45.0, 12.0}));
    canvas().pan({-35.0, 18.0});
    expect_as_shaded_anew("paint between two ways");
}

class CanvasAlone : public TurnedView {
  protected:
    /// By name: raising a panel changes its place among the window's children.
    std::map<QString, bool> shown() {
        std::map<QString, bool> shown{{QStringLiteral("menus"), window().menuBar()->isVisible()},
                                      {QStringLiteral("status"), window().statusBar()->isVisible()}};
        for (const QWidget* widget : window().findChildren<QDockWidget*>())
            shown[widget->objectName()] = widget->isVisible();
        for (const QWidget* widget : window().findChildren<QToolBar*>())
            shown[widget->objectName()] = widget->isVisible();
        return shown;
    }
};

TEST_F(CanvasAlone, TabHidesAllElseAndBringsItBackAsItWas) {
    give(Command::MixingWell);
    give(Command::TracingPanel);
    canvas().zoom_about_centre(1.5);
    const auto& well = studio().well();
    wait_for([&] { return well.height() >= well.heightForWidth(well.width()); });
    QApplication::processEvents();
    const auto before = shown();
    auto none = before;
    for (auto& [name, visible] : none)
        visible = false;
    const QByteArray state = window().saveState();
    const QRect place = canvas().geometry();
    const QPoint mark = canvas().mapToGlobal(canvas().widget_position({30.0, 20.0}).toPoint());
    for (const int back : {Qt::Key_Tab, Qt::Key_Escape}) {
        key(Qt::Key_Tab);
        QApplication::processEvents();
        EXPECT_EQ(canvas().size(), window().size());
        EXPECT_EQ(shown(), none);
        EXPECT_LE((canvas().mapToGlobal(canvas().widget_position({30.0, 20.0}).toPoint()) - mark)
                      .manhattanLength(),
                  2);
        key(back);
        QApplication::processEvents();
        EXPECT_EQ(shown(), before);
        EXPECT_EQ(canvas().geometry(), place);
        EXPECT_EQ(window().saveState(), state);
        EXPECT_LE((canvas().mapToGlobal(canvas().widget_position({30.0, 20.0}).toPoint()) - mark)
                      .manhattanLength(),
                  2);
        EXPECT_FALSE(action(Command::CanvasOnly)->isChecked());
    }
}

TEST_F(CanvasAlone, CommandsHoldWithoutTheirMenus) {
    key(Qt::Key_Tab);
    key(Qt::Key_6);
    EXPECT_EQ(canvas().view_transform().angle_deg, 15.0);
    key(Qt::Key_F);
    EXPECT_TRUE(action(Command::Pause)->isChecked());
}

TEST_F(CanvasAlone, AWindowClosedSoOpensWithItsPanels) {
    const auto before = shown();
    key(Qt::Key_Tab);
    start_again();
    EXPECT_EQ(shown(), before);
}

}  // namespace
}  // namespace pastoso::tests
