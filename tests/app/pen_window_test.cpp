// Pens in the real window: curves, the other end, buttons, the dialog, and a mouse that presses by
// speed.
#include "app/window_fixture.hpp"
#include "core/text_file.hpp"
#include "panels/pen/curve_editor.hpp"
#include "panels/pen/pen_dialog.hpp"
#include "panels/pen/pen_pad.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPolygonF>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>

namespace pastoso::tests {
namespace {

using commands::Command;

class PenWindow : public WindowTest {
  protected:
    panels::PenDialog& open_dialog() {
        action(Command::PenSettings)->trigger();
        wait_until_shown(dialog());
        return dialog();
    }
    panels::PenDialog& dialog() {
        auto* found = window().findChild<panels::PenDialog*>();
        if (found == nullptr) throw std::runtime_error("the dialog of pens is not open");
        return *found;
    }
    template <class Widget>
    Widget& part(const char* name) {
        auto* found = dialog().findChild<Widget*>(QString::fromUtf8(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    void choose(const char* device) {
        auto& list = part<QListWidget>("devices");
        const auto found = list.findItems(QString::fromUtf8(device), Qt::MatchExactly);
        ASSERT_EQ(found.size(), 1) << device;
        list.setCurrentItem(found[0]);
    }
    void click(const char* button) { QTest::mouseClick(&part<QPushButton>(button), Qt::LeftButton); }

    static Pen pressed(double pressure, bool eraser_end = false) {
        Pen pen;
        pen.pressure = pressure;
        pen.eraser_end = eraser_end;
        return pen;
    }

    std::vector<double> recorded_pressures() {
        session().wait_until_applied();
        std::vector<double> pressures;
        for (const document::Event& event : session().recording().events)
            if (const auto* move = std::get_if<document::PenMove>(&event.action))
                pressures.push_back(move->sample.pressure);
        return pressures;
    }
    const std::string& tool() { return studio().easel().hand().brush; }
    std::filesystem::path pen_file() { return settings_file().parent_path() / "pen.json"; }
};

// ---- curves

TEST_F(PenWindow, TheCurveOfAPenIsInTheRecording) {
    open_dialog();
    choose("test stylus");
    click("soft");
    pen_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}), pressed(0.5));
    const std::vector<double> soft = recorded_pressures();
    ASSERT_GE(soft.size(), 20U);
    for (const double pressure : soft)
        EXPECT_DOUBLE_EQ(pressure, 0.72);
    click("linear");
    pen_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}), pressed(0.5));
    EXPECT_DOUBLE_EQ(recorded_pressures().back(), 0.5);
}

TEST_F(PenWindow, EveryPenHasItsOwnCurveAtTheNextStartToo) {
    open_dialog();
    choose("test eraser, eraser end");
    click("firm");
    start_again();
    open_dialog();
    choose("test stylus");
    EXPECT_EQ(part<panels::CurveEditor>("pressure_curve").points().size(), 2U);
    EXPECT_FALSE(part<QPushButton>("linear").isEnabled());
    choose("test eraser, eraser end");
    EXPECT_EQ(part<panels::CurveEditor>("pressure_curve").points().size(), 5U);
    pen_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}), pressed(0.5, true));
    EXPECT_DOUBLE_EQ(recorded_pressures().back(), 0.25);
}

TEST_F(PenWindow, DraggedPointsStayInTheirRise) {
    open_dialog();
    choose("test stylus");
    auto& editor = part<panels::CurveEditor>("pressure_curve");
    const auto at = [&](double input, double output) {
        return editor.position_of({input, output}).toPoint();
    };
    QTest::mouseClick(&editor, Qt::LeftButton, {}, at(0.4, 0.7));
    ASSERT_EQ(editor.points().size(), 3U);
    QTest::mousePress(&editor, Qt::LeftButton, {}, at(0.0, 0.0));
    QTest::mouseMove(&editor, at(0.3, 0.9));
    QTest::mouseRelease(&editor, Qt::LeftButton, {}, at(0.3, 0.9));
    EXPECT_EQ(editor.points()[0].input, 0.0);
    EXPECT_NEAR(editor.points()[0].output, 0.7, 0.02);
    EXPECT_TRUE(tools::is_pressure_curve(editor.points()));
    QTest::mouseClick(&editor, Qt::RightButton, {}, editor.position_of(editor.points()[0]).toPoint());
    EXPECT_EQ(editor.points().size(), 3U);  // the ends stay
    pen_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}), pressed(0.2));
    EXPECT_NEAR(recorded_pressures().back(), 0.7, 0.02);
}

TEST_F(PenWindow, AFileThatCannotBeReadIsToldAndLeft) {
    std::filesystem::create_directories(pen_file().parent_path());
    core::write_text_file(pen_file(), "{\"version\": 1}");
    open_another();
    EXPECT_NE(told().find("pen.json"), std::string::npos) << told();
    open_dialog();
    choose("test stylus");
    click("soft");
    EXPECT_EQ(core::read_text_file(pen_file()), "{\"version\": 1}");
}

// ---- the sheet

TEST_F(PenWindow, TheSheetShowsTheStrokeAndWhatThePenTells) {
    open_dialog();
    auto& pad = part<panels::PenPad>("pen_pad");
    choose("Mouse");
    const QPoint place = pad.mapToGlobal(QPoint(0, 0));
    QSignalSpy touched(&pad, &panels::PenPad::touched);
    Pen pen = pressed(0.5);
    pen.tilt_x_deg = 25;
    pen.tilt_y_deg = -40;
    const auto ink = [&] {
        const QImage& sheet = pad.sheet();
        int pixels = 0;
        for (int y = 0; y < sheet.height(); ++y)
            for (int x = 0; x < sheet.width(); ++x)
                pixels += qAlpha(sheet.pixel(x, y)) > 128 ? 1 : 0;
        return pixels;
    };
    const auto scribble = [&](int y) {
        for (int x = 20; x <= 200; x += 10)
            pen_over(pad, QPointF(x, y), Qt::LeftButton, pen);
    };
    scribble(40);
    EXPECT_EQ(touched.count(), 1);
    EXPECT_TRUE(part<QListWidget>("devices").currentItem()->text() == "test stylus");
    QApplication::processEvents();
    EXPECT_EQ(pad.mapToGlobal(QPoint(0, 0)), place);  // it stays below the pen
    const QString words = part<QLabel>("pen_readings").text();
    for (const char* word : {"test stylus", "50 % \u2192 50 %", "100 events", "25\u00b0 across",
                             "-40\u00b0 along", "not told", "tip"})
        EXPECT_TRUE(words.contains(QString::fromUtf8(word))) << word << " in " << words.toStdString();
    pen_over(pad, QPointF(200, 40), Qt::NoButton, pressed(0.0));
    const int linear = ink();
    EXPECT_GT(linear, 1000);
    click("wipe");
    EXPECT_EQ(ink(), 0);
    click("firm");
    scribble(40);
    EXPECT_LT(ink(), 0.7 * linear);
    EXPECT_TRUE(part<QLabel>("pen_readings").text().contains(QString::fromUtf8("50 % \u2192 25 %")));
    EXPECT_EQ(volume_mm3(), 0.0);
}

// ---- the eraser end

TEST_F(PenWindow, TheEraserEndTakesItsToolAndGivesBackTheOneBefore) {
    studio().easel().take_brush("Filbert 14", 11.0);
    pen_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}), pressed(0.6));
    const double painted_mm3 = volume_mm3();
    ASSERT_GT(painted_mm3, 2.0);
    pen_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}), pressed(0.9, true));
    EXPECT_EQ(tool(), "Eraser 15");
    EXPECT_LT(volume_mm3(), 0.7 * painted_mm3);
    pen_at({20.0, 20.0}, Qt::NoButton, pressed(0.0));
    EXPECT_EQ(tool(), "Filbert 14");
    EXPECT_EQ(studio().easel().hand().brush_width_mm, 11.0);
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(PenWindow, TheMouseGivesTheToolBackToo) {
    pen_at({20.0, 20.0}, Qt::NoButton, pressed(0.0, true));
    EXPECT_EQ(tool(), "Eraser 15");
    mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    EXPECT_EQ(tool(), "Flat bristle 20");
    EXPECT_GT(volume_mm3(), 5.0);
    pen_at({20.0, 20.0}, Qt::NoButton, pressed(0.0, true));
    EXPECT_EQ(tool(), "Eraser 15");
}

TEST_F(PenWindow, TheEraserEndDoesWhatItIsToldTo) {
    open_dialog();
    auto& choice = part<QComboBox>("eraser_tool");
    choice.setCurrentIndex(choice.findData(QStringLiteral("Rag 35")));
    Q_EMIT choice.activated(choice.currentIndex());
    pen_at({20.0, 20.0}, Qt::NoButton, pressed(0.0, true));
    EXPECT_EQ(tool(), "Rag 35");
    pen_at({20.0, 20.0}, Qt::NoButton, pressed(0.0));
    choice.setCurrentIndex(choice.findData(QString()));
    Q_EMIT choice.activated(choice.currentIndex());
    pen_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}), pressed(0.6, true));
    EXPECT_EQ(tool(), "Flat bristle 20");
    EXPECT_GT(volume_mm3(), 5.0);
}

// ---- buttons

TEST_F(PenWindow, TheLowerButtonPicksUpPaint) {
    mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    studio().easel().choose_paint({{{"PR101", 1.0}}, 1.0});
    settle();
    pen_at({30.0, 20.0}, Qt::NoButton, pressed(0.0));
    pen_at({30.0, 20.0}, Qt::MiddleButton, pressed(0.0));
    pen_at({30.0, 20.0}, Qt::NoButton, pressed(0.0));
    EXPECT_EQ(studio().easel().hand().paint.ingredients.front().pigment, "PB29");
    EXPECT_FALSE(studio().easel().painting());
}

TEST_F(PenWindow, AButtonMayMoveTheCanvasInstead) {
    open_dialog();
    auto& choice = part<QComboBox>("lower_button");
    choice.setCurrentText(QStringLiteral("moves the canvas"));
    Q_EMIT choice.activated(choice.currentIndex());
    const QPointF there = canvas().widget_position({20.0, 20.0});
    pen_at({20.0, 20.0}, Qt::NoButton, pressed(0.0));
    pen_over(canvas(), there, Qt::MiddleButton, pressed(0.0));
    pen_over(canvas(), there + QPointF(40, 10), Qt::MiddleButton, pressed(0.0));
    pen_over(canvas(), there + QPointF(40, 10), Qt::NoButton, pressed(0.0));
    EXPECT_NEAR((canvas().widget_position({20.0, 20.0}) - there).x(), 40.0, 1.0);
    pen_over(canvas(), there, Qt::NoButton, pressed(0.0));
    EXPECT_NEAR((canvas().widget_position({20.0, 20.0}) - there).x(), 40.0, 1.0);
    EXPECT_EQ(volume_mm3(), 0.0);
}

// ---- the mouse

TEST_F(PenWindow, TheMousePressesAsItIsSet) {
    open_dialog();
    choose("Mouse");
    EXPECT_FALSE(part<QCheckBox>("mouse_by_speed").isChecked());
    EXPECT_EQ(part<QDoubleSpinBox>("mouse_pressure").value(), 50.0);
    part<QDoubleSpinBox>("mouse_pressure").setValue(80.0);
    start_again();
    mouse_stroke(line_mm({15.0, 30.0}, {45.0, 30.0}));
    EXPECT_DOUBLE_EQ(recorded_pressures().back(), 0.8);
    open_dialog();
    choose("Mouse");
    part<QDoubleSpinBox>("mouse_pressure").setValue(50.0);
    mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    EXPECT_DOUBLE_EQ(recorded_pressures().back(), 0.5);
}

TEST_F(PenWindow, AFastMousePressesLess) {
    open_dialog();
    choose("Mouse");
    part<QCheckBox>("mouse_by_speed").setChecked(true);
    mouse_stroke(line_mm({15.0, 10.0}, {25.0, 10.0}, 80));
    const double slow = recorded_pressures().back();
    mouse_stroke(line_mm({10.0, 30.0}, {50.0, 30.0}, 10));
    const std::vector<double> pressures = recorded_pressures();
    EXPECT_LT(slow, 0.5);
    EXPECT_LT(*std::min_element(pressures.begin(), pressures.end()), 0.7 * slow);
}

// ---- the outline

TEST_F(PenWindow, HoveringShowsTheOutlineAndHowThePenLeans) {
    action(Command::Pause)->trigger();
    studio().easel().take_brush("Round sable 9", 9.0);
    action(Command::SmallerBrush)->trigger();  // shows the hand
    const QImage bare = picture();
    const auto seen = [&](int tilt_x_deg) {
        Pen pen = pressed(0.0);
        pen.tilt_x_deg = tilt_x_deg;
        pen_at({30.0, 20.0}, Qt::NoButton, pen);
        return canvas().picture().convertToFormat(QImage::Format_RGB888);
    };
    const QImage upright = seen(0), leaning = seen(50), other_way = seen(-50);
    EXPECT_GT(difference(bare, upright).largest, 50);
    EXPECT_GT(difference(upright, leaning).largest, 50);
    // The handle's line, from the pen to the right; nothing of it to the left.
    const double ratio = canvas().devicePixelRatioF();
    const auto changed_at = [&](const QImage& image, double x_px) {
        const QPointF place = canvas().widget_position({30.0, 20.0}) + QPointF(x_px, 0.0);
        int most = 0;
        for (int row = -2; row <= 2; ++row) {
            const QPoint pixel = (ratio * place).toPoint() + QPoint(0, row);
            most = std::max(most,
                            std::abs(image.pixelColor(pixel).green() - bare.pixelColor(pixel).green()));
        }
        return most;
    };
    // The outline may cross there at one place of the two.
    const auto changed = [&](const QImage& image, double side) {
        return std::min(changed_at(image, 12.0 * side), changed_at(image, 30.0 * side));
    };
    EXPECT_GT(changed(leaning, 1.0), 30);
    EXPECT_LT(changed(leaning, -1.0), 10);
    EXPECT_GT(changed(other_way, -1.0), 30);
    EXPECT_LT(changed(other_way, 1.0), 10);
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(PenWindow, ThePenTakesItsOutlineAlongWhereItLeaves) {
    action(Command::Pause)->trigger();
    action(Command::SmallerBrush)->trigger();  // shows the hand
    const QImage bare = picture();
    const auto seen = [&] { return canvas().picture().convertToFormat(QImage::Format_RGB888); };
    QWidget& panel = *window().statusBar();
    const auto leave = {std::function([&] { pen_leaves(pressed(0.0)); }), std::function([&] {
                            pen_over(panel, panel.rect().center(), Qt::NoButton, pressed(0.0));
                        })};
    for (const auto& leaves : leave) {
        pen_at({30.0, 20.0}, Qt::NoButton, pressed(0.0));
        EXPECT_TRUE(canvas().pointer_mm());
        EXPECT_GT(difference(bare, seen()).largest, 50);
        QSignalSpy left(&canvas(), &view::CanvasView::pointer_left);
        leaves();
        EXPECT_FALSE(canvas().pointer_mm());
        EXPECT_GE(left.count(), 1);
        EXPECT_EQ(difference(bare, seen()).largest, 0);
    }
}

TEST_F(PenWindow, APenThatLeavesChangesNothingUnderTheMouse) {
    pen_at({30.0, 20.0}, Qt::NoButton, pressed(0.0));
    move({20.0, 10.0}, Qt::NoButton);
    pen_leaves(pressed(0.0));
    ASSERT_TRUE(canvas().pointer_mm());
    EXPECT_NEAR(canvas().pointer_mm()->x, 20.0, 1e-9);
}

TEST_F(PenWindow, AStrokeEndsWhereThePenLeavesBeforeItHasLifted) {
    pen_at({20.0, 20.0}, Qt::NoButton, pressed(0.0));
    for (const glm::dvec2& place_mm : line_mm({20.0, 20.0}, {40.0, 20.0}))
        pen_at(place_mm, Qt::LeftButton, pressed(0.6));
    EXPECT_TRUE(studio().easel().painting());
    pen_leaves(pressed(0.0));
    EXPECT_FALSE(studio().easel().painting());
    const std::size_t told = recorded_pressures().size();
    pen_at({10.0, 10.0}, Qt::NoButton, pressed(0.0));
    mouse_stroke(line_mm({20.0, 30.0}, {40.0, 30.0}));  // the pen has nothing any more
    EXPECT_GT(recorded_pressures().size(), told + 10);
    EXPECT_EQ(session().status().strokes, 2);
}

/// On a turned and mirrored view too, and on a screen of any number of pixels: the changed pixels are
/// those around the outline's own points. The line is a pixel wide, with a darker one beside it.
TEST_F(PenWindow, TheOutlineLiesWhereTheBrushWouldTouch) {
    action(Command::Pause)->trigger();
    action(Command::TurnWithStroke)->trigger();
    studio().easel().take_brush("Flat bristle 20", 14.0);
    action(Command::LargerBrush)->trigger();  // shows the hand
    canvas().turn_about_centre(27.0);
    canvas().mirror();
    const QImage bare = picture();
    const glm::dvec2 place_mm(30.0, 20.0);
    Pen pen = pressed(0.0);
    pen.tilt_x_deg = 3;
    pen_at(place_mm, Qt::NoButton, pen);
    const QImage hovering = canvas().picture().convertToFormat(QImage::Format_RGB888);
    QRect seen;
    for (int y = 0; y < bare.height(); ++y)
        for (int x = 0; x < bare.width(); ++x)
            if (std::abs(bare.pixelColor(x, y).green() - hovering.pixelColor(x, y).green()) > 12)
                seen |= QRect(x, y, 1, 1);
    const tools::Hand& hand = studio().easel().hand();
    const interactions::BrushOutline outline(
        brush::resized(tools::preset_in_hand(hand), hand.brush_width_mm));
    brush::PenSample held = studio().easel().held();
    held.pressure = 0.5;
    QPolygonF expected;
    for (const glm::vec2& point : outline.around_mm(held))
        expected << canvas().devicePixelRatioF() *
                        canvas().widget_position(place_mm + glm::dvec2(point));
    const QRectF box = expected.boundingRect();
    EXPECT_NEAR(seen.left(), box.left(), 2.5);
    EXPECT_NEAR(seen.top(), box.top(), 2.5);
    EXPECT_NEAR(seen.right() + 1, box.right(), 2.5);
    EXPECT_NEAR(seen.bottom() + 1, box.bottom(), 2.5);
    EXPECT_GT(box.width(), 20.0);
}

}  // namespace
}  // namespace pastoso::tests
