// Selections in the real window: drawn by rectangle and lasso, chosen by height and wetness, seen, told,
// undone and saved.
#include "app/selection_fixture.hpp"
#include "dialogs/select_range_dialog.hpp"
#include "main/window_parts.hpp"

#include <cmath>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMouseEvent>
#include <QStatusBar>
#include <QTest>
#include <QWheelEvent>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;

class SelectionWindow : public SelectionFixture {
  protected:
    dialogs::SelectRangeDialog* dialog() { return window().findChild<dialogs::SelectRangeDialog*>(); }
    QDoubleSpinBox& box(const char* name) {
        return *dialog()->findChild<QDoubleSpinBox*>(QLatin1String(name));
    }
    std::string outcome() {
        return dialog()->findChild<QLabel*>(QStringLiteral("outcome"))->text().toStdString();
    }
};

TEST_F(SelectionWindow, ARectangleIsSelectedAndToolsKeepToIt) {
    give(Command::SelectRectangle);
    EXPECT_EQ(reading(), "rectangle");
    drag({{10.0, 10.0}, {25.0, 20.0}, {40.0, 30.0}});
    EXPECT_NEAR(selected_mm2(), 30.0 * 20.0, 2.0 * (30.0 + 20.0) * kSide_mm);
    EXPECT_TRUE(selected(11.0, 11.0) && selected(39.0, 29.0));
    EXPECT_FALSE(selected(9.0, 20.0) || selected(41.0, 20.0) || selected(20.0, 31.0));
    EXPECT_EQ(volume_mm3(), 0.0) << "drawing an outline does not paint";
    EXPECT_EQ(reading(), "rectangle, 25 % selected");
    key(Qt::Key_Escape);
    EXPECT_FALSE(action(Command::SelectRectangle)->isChecked());
    EXPECT_EQ(reading(), "25 % selected");
    mouse_stroke(line_mm({5.0, 20.0}, {55.0, 20.0}));
    EXPECT_GT(volume_mm3(), 1.0);
    const auto painted = session().snapshot();
    for (int y = 0; y < painted->film.shape.height; ++y) {
        for (int x = 0; x < painted->film.shape.width; ++x) {
            const bool free = painted->selection->at(x, y) != 0;
            ASSERT_TRUE(free || film::thickness_mm(painted->film.thickness.at(x, y)) == 0.0F)
                << x << ", " << y;
        }
    }
}

TEST_F(SelectionWindow, ARectangleMayBeDrawnTowardsAnyCorner) {
    give(Command::SelectRectangle);
    drag({{40.0, 30.0}, {10.0, 10.0}});
    EXPECT_TRUE(selected(11.0, 11.0) && selected(39.0, 29.0));
    EXPECT_FALSE(selected(41.0, 31.0) || selected(9.0, 9.0));
}

TEST_F(SelectionWindow, ControlKeepsASquareAndPicksNoPaint) {
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {30.0, 14.0}}, Qt::ControlModifier);
    EXPECT_NEAR(selected_mm2(), 20.0 * 20.0, 4.0 * 20.0 * kSide_mm);
    EXPECT_TRUE(selected(12.0, 28.0));
    EXPECT_THAT(told(), HasSubstr("keep to the outline"));
}

TEST_F(SelectionWindow, ALassoSelectsWhatItGoesAround) {
    give(Command::SelectLasso);
    std::vector<glm::dvec2> circle;
    for (int i = 0; i <= 100; ++i)
        circle.emplace_back(30.0 + 12.0 * std::cos(0.06283 * i), 20.0 + 12.0 * std::sin(0.06283 * i));
    drag(circle);
    EXPECT_NEAR(selected_mm2(), 3.1416 * 12.0 * 12.0, 2.0 * 3.1416 * 12.0 * 0.5 * kSide_mm);
    EXPECT_TRUE(selected(30.0, 20.0));
    EXPECT_FALSE(selected(19.0, 9.0));
}

TEST_F(SelectionWindow, ALassoIsThinnedToTheScreensPixels) {
    give(Command::SelectLasso);
    drag(line_mm({10.0, 10.0}, {50.0, 10.0}, 4000));
    drag(line_mm({50.0, 10.0}, {30.0, 30.0}, 4000));
    session().wait_until_applied();
    const auto events = session().recording().events;
    const auto& area = std::get<document::SelectArea>(events.back().action);
    EXPECT_LT(area.outline.size(), 400U);
    EXPECT_GT(area.outline.size(), 50U);
}

TEST_F(SelectionWindow, ShiftAddsAltTakesAwayBothKeepWhatIsCommon) {
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {20.0, 30.0}});
    send(QEvent::MouseButtonPress, {30.0, 10.0}, Qt::ShiftModifier);
    EXPECT_THAT(told(), HasSubstr("Adds"));
    send(QEvent::MouseMove, {40.0, 30.0}, Qt::ShiftModifier);
    send(QEvent::MouseButtonRelease, {40.0, 30.0}, Qt::ShiftModifier);
    EXPECT_TRUE(selected(15.0, 20.0) && selected(35.0, 20.0));
    EXPECT_FALSE(selected(25.0, 20.0));
    drag({{5.0, 5.0}, {55.0, 15.0}}, Qt::AltModifier);
    EXPECT_FALSE(selected(15.0, 12.0));
    EXPECT_TRUE(selected(15.0, 20.0));
    drag({{12.0, 5.0}, {25.0, 35.0}}, Qt::ShiftModifier | Qt::AltModifier);
    EXPECT_TRUE(selected(15.0, 20.0));
    EXPECT_FALSE(selected(11.0, 20.0) || selected(35.0, 20.0));
}

TEST_F(SelectionWindow, AClickEndsTheSelectionAndAnAddedClickDoesNot) {
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {20.0, 30.0}});
    drag({{30.0, 20.0}}, Qt::ShiftModifier);
    EXPECT_NE(selection(), nullptr);
    drag({{30.0, 20.0}});
    EXPECT_EQ(selection(), nullptr);
    EXPECT_EQ(reading(), "rectangle");
    EXPECT_THAT(told(), HasSubstr("all of the canvas"));
    const auto events = events_posted();
    drag({{30.0, 20.0}});
    EXPECT_EQ(events_posted(), events) << "nothing is there to be ended";
}

TEST_F(SelectionWindow, EscapeGivesUpTheOutlineAndThenTheTool) {
    give(Command::SelectLasso);
    const auto events = events_posted();
    send(QEvent::MouseButtonPress, {10.0, 10.0}, {});
    for (const glm::dvec2 place : {glm::dvec2{30.0, 10.0}, {30.0, 30.0}})
        send(QEvent::MouseMove, place, {});
    key(Qt::Key_Escape);
    EXPECT_TRUE(action(Command::SelectLasso)->isChecked());
    send(QEvent::MouseMove, {10.0, 30.0}, {});
    send(QEvent::MouseButtonRelease, {10.0, 30.0}, {});
    EXPECT_EQ(events_posted(), events);
    key(Qt::Key_Escape);
    EXPECT_FALSE(action(Command::SelectLasso)->isChecked());
    mouse_stroke(line_mm({10.0, 20.0}, {50.0, 20.0}));
    EXPECT_GT(volume_mm3(), 1.0);
}

TEST_F(SelectionWindow, RectangleAndLassoTakeTurnsAndATakenBrushPaints) {
    QTest::keyClick(&canvas(), Qt::Key_A);
    EXPECT_TRUE(action(Command::SelectRectangle)->isChecked());
    QTest::keyClick(&canvas(), Qt::Key_L);
    EXPECT_FALSE(action(Command::SelectRectangle)->isChecked());
    EXPECT_TRUE(action(Command::SelectLasso)->isChecked());
    QTest::keyClick(&canvas(), Qt::Key_L);
    EXPECT_FALSE(action(Command::SelectLasso)->isChecked());
    give(Command::SelectLasso);
    give(Command::NextBrush);
    EXPECT_FALSE(action(Command::SelectLasso)->isChecked());
    mouse_stroke(line_mm({10.0, 20.0}, {50.0, 20.0}));
    EXPECT_EQ(selection(), nullptr);
}

TEST_F(SelectionWindow, ThePenDrawsOutlinesToo) {
    give(Command::SelectRectangle);
    pen_stroke({{10.0, 10.0}, {30.0, 20.0}, {40.0, 30.0}}, {.pressure = 0.7});
    settle();
    EXPECT_TRUE(selected(11.0, 11.0) && selected(39.0, 29.0));
    EXPECT_FALSE(selected(41.0, 31.0));
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(SelectionWindow, ZoomAndPanGoOnWhileAnOutlineIsDrawn) {
    give(Command::SelectRectangle);
    send(QEvent::MouseButtonPress, {10.0, 10.0}, {});
    send(QEvent::MouseMove, {20.0, 20.0}, {});
    const QPointF middle = canvas().widget_position({20.0, 20.0});
    QWheelEvent wheel(middle, canvas().mapToGlobal(middle), {}, {0, 360}, Qt::LeftButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&canvas(), &wheel);
    send(QEvent::MouseMove, {25.0, 22.0}, {});
    send(QEvent::MouseButtonRelease, {25.0, 22.0}, {});
    EXPECT_TRUE(selected(10.5, 10.5) && selected(24.5, 21.5));
    EXPECT_FALSE(selected(9.5, 15.0) || selected(25.5, 15.0));
    const auto events = events_posted();
    const glm::dvec2 origin = canvas().view_transform().origin_px;
    QTest::keyPress(&canvas(), Qt::Key_Space);
    drag({{20.0, 20.0}, {22.0, 20.0}});
    QTest::keyRelease(&canvas(), Qt::Key_Space);
    EXPECT_NE(canvas().view_transform().origin_px, origin);
    EXPECT_EQ(events_posted(), events);
}

TEST_F(SelectionWindow, TheWellIsPaintedOnMeanwhile) {
    give(Command::MixingWell);
    wait_for([this] { return studio().well().isVisible(); });
    give(Command::SelectRectangle);
    mouse_stroke_on(studio().well(), line_mm({20.0, 20.0}, {60.0, 20.0}));
    session().wait_until_applied();
    EXPECT_TRUE(session().snapshot()->well.has_value());
    EXPECT_EQ(selection(), nullptr);
}

TEST_F(SelectionWindow, TheOutlineIsSeenWhereTheSelectionEnds) {
    const QImage before = picture();
    give(Command::SelectRectangle);
    send(QEvent::MouseButtonPress, {10.0, 10.0}, {});
    send(QEvent::MouseMove, {40.0, 30.0}, {});
    EXPECT_GT(difference(before, picture()).largest, 60) << "while it is drawn";
    send(QEvent::MouseButtonRelease, {40.0, 30.0}, {});
    key(Qt::Key_Escape);
    const QImage after = picture();
    const double ratio = canvas().devicePixelRatioF();
    const QPointF low = ratio * canvas().widget_position({10.0, 10.0});
    const QPointF high = ratio * canvas().widget_position({40.0, 30.0});
    // A cell is about two pixels wide.
    const double near_px = 4.0;
    int changed = 0;
    for (int y = 0; y < after.height(); ++y) {
        for (int x = 0; x < after.width(); ++x) {
            if (after.pixel(x, y) == before.pixel(x, y)) continue;
            ++changed;
            const double off_x = std::min(std::abs(x - low.x()), std::abs(x - high.x()));
            const double off_y = std::min(std::abs(y - low.y()), std::abs(y - high.y()));
            ASSERT_LT(std::min(off_x, off_y), near_px) << x << ", " << y;
        }
    }
    EXPECT_GT(changed, 1.8 * (high.x() - low.x() + high.y() - low.y()));
    give(Command::ShowOutline);
    EXPECT_EQ(difference(before, picture()).largest, 0);
    EXPECT_NE(selection(), nullptr) << "it is hidden, not ended";
    give(Command::ShowOutline);
    EXPECT_EQ(difference(after, picture()).largest, 0);
    give(Command::SelectEverything);
    EXPECT_EQ(difference(before, picture()).largest, 0);
}

TEST_F(SelectionWindow, UndoAndRedoChangeTheSelectionToo) {
    EXPECT_FALSE(action(Command::InvertSelection)->isEnabled());
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {40.0, 30.0}});
    give(Command::InvertSelection);
    EXPECT_FALSE(selected(20.0, 20.0));
    EXPECT_TRUE(selected(5.0, 5.0));
    give(Command::Undo);
    EXPECT_TRUE(selected(20.0, 20.0));
    EXPECT_FALSE(selected(5.0, 5.0));
    EXPECT_EQ(reading(), "rectangle, 25 % selected");
    give(Command::Undo);
    EXPECT_EQ(selection(), nullptr);
    EXPECT_EQ(reading(), "rectangle");
    give(Command::Redo);
    EXPECT_TRUE(selected(20.0, 20.0));
    EXPECT_EQ(reading(), "rectangle, 25 % selected");
    give(Command::SelectEverything);
    EXPECT_EQ(selection(), nullptr);
    give(Command::Undo);
    EXPECT_NE(selection(), nullptr);
}

TEST_F(SelectionWindow, AStrokeOutsideSaysWhyItPaintsNothing) {
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {20.0, 30.0}});
    key(Qt::Key_Escape);
    mouse_stroke(line_mm({40.0, 10.0}, {50.0, 30.0}));
    EXPECT_EQ(volume_mm3(), 0.0);
    EXPECT_THAT(told(), HasSubstr("Outside the selection"));
    mouse_stroke(line_mm({45.0, 20.0}, {15.0, 20.0}));
    EXPECT_EQ(told(), "") << "it has come to the selection";
    EXPECT_GT(volume_mm3(), 0.0);
    // Its edge is inside.
    mouse_stroke(line_mm({21.5, 20.0}, {15.0, 20.0}));
    EXPECT_EQ(told(), "");
    give(Command::MirrorSymmetry);
    mouse_stroke(line_mm({45.0, 14.0}, {45.0, 26.0}));
    EXPECT_EQ(told(), "") << "its mirror image paints";
}

TEST_F(SelectionWindow, ASavedSelectionIsThereAgain) {
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {40.0, 30.0}});
    key(Qt::Key_Escape);
    const QImage before = picture();
    const TemporaryFolder folder;
    const QString path = QString::fromStdString((folder.path() / "selected.pastoso").string());
    parts().files.save_painting(path);
    EXPECT_EQ(parts().files.saver().wait(), "");
    parts().files.new_canvas(canvas_settings());
    loaded();
    settle();
    EXPECT_EQ(reading(), "");
    parts().files.open_painting(path);
    loaded();
    settle();
    EXPECT_EQ(reading(), "25 % selected");
    EXPECT_TRUE(selected(20.0, 20.0));
    EXPECT_EQ(difference(before, picture()).largest, 0);
}

TEST_F(SelectionWindow, ByHeightTakesWhatStandsHigherThanMost) {
    mouse_stroke(line_mm({10.0, 12.0}, {50.0, 12.0}));
    give(Command::DryNow);
    for (int i = 0; i < 3; ++i)
        mouse_stroke(line_mm({10.0, 28.0}, {50.0, 28.0}));
    settle();
    const QImage before = picture();
    give(Command::SelectHeight);
    ASSERT_NE(dialog(), nullptr);
    const double least_mm = box("least_mm").value(), most_mm = box("most_mm").value();
    EXPECT_GT(least_mm, 0.0);
    EXPECT_GT(most_mm, least_mm);
    EXPECT_THAT(outcome(), HasSubstr("% of the canvas"));
    EXPECT_GT(difference(before, picture()).largest, 60) << "it is outlined";
    EXPECT_EQ(selection(), nullptr) << "but not selected yet";
    const std::string first = outcome();
    box("most_mm").selectAll();
    QTest::keyClicks(&box("most_mm"), QStringLiteral("2 cm"));
    EXPECT_EQ(box("most_mm").value(), 20.0);
    box("most_mm").setValue(most_mm);
    box("least_mm").setValue(0.001);
    EXPECT_NE(outcome(), first);
    box("least_mm").setValue(least_mm);
    dialog()->accept();
    settle();
    const double chosen_mm2 = selected_mm2();
    EXPECT_GT(chosen_mm2, 5.0);
    EXPECT_LT(chosen_mm2, 400.0);
    EXPECT_FALSE(selected(30.0, 20.0)) << "the bare canvas";
}

TEST_F(SelectionWindow, ByWetnessTakesWetPaintAndLeavesDry) {
    mouse_stroke(line_mm({10.0, 12.0}, {50.0, 12.0}));
    give(Command::DryNow);
    mouse_stroke(line_mm({10.0, 28.0}, {50.0, 28.0}));
    settle();
    give(Command::SelectRectangle);
    drag({{30.0, 2.0}, {58.0, 38.0}});
    give(Command::SelectWetness);
    dialog()
        ->findChild<QComboBox*>(QStringLiteral("how"))
        ->setCurrentIndex(static_cast<int>(grid::Combination::Intersect));
    dialog()->accept();
    settle();
    EXPECT_TRUE(selected(40.0, 28.0));
    EXPECT_FALSE(selected(20.0, 28.0)) << "outside the rectangle";
    EXPECT_FALSE(selected(40.0, 12.0)) << "dry";
}

TEST_F(SelectionWindow, ACancelledRangeLeavesEverythingAsItWas) {
    mouse_stroke(line_mm({10.0, 12.0}, {50.0, 12.0}));
    settle();
    const QImage before = picture();
    give(Command::SelectWetness);
    box("least_mm").setValue(500.0);
    EXPECT_GE(box("most_mm").value(), 500.0) << "neither passes the other";
    EXPECT_THAT(outcome(), HasSubstr("Nothing"));
    give(Command::SelectHeight);
    EXPECT_EQ(window().findChildren<dialogs::SelectRangeDialog*>().size(), 1) << "one at a time";
    dialog()->reject();
    settle();
    EXPECT_EQ(selection(), nullptr);
    EXPECT_EQ(difference(before, picture()).largest, 0);
    EXPECT_TRUE(session().take_errors().empty());
}

}  // namespace
}  // namespace pastoso::tests
