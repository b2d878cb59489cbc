// Mirror, copies, straight lines, guides and stabiliser, as the window has them.
#include "app/window_fixture.hpp"
#include "main/window_parts.hpp"

#include <cmath>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMouseEvent>
#include <QSlider>

namespace pastoso::tests {
namespace {

using commands::Command;

class Guides : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        give(Command::Pause);
        studio().easel().take_brush("Flat bristle 20", 4.0);
    }

    void give(Command command) { studio().commands().action(command)->trigger(); }

    /// Volume per mm2 around a place.
    double paint_at(double x_mm, double y_mm) {
        session().wait_until_applied();
        const auto snapshot = session().snapshot();
        const film::FilmState& film = snapshot->film;
        double sum = 0.0;
        for (int y = -3; y <= 3; ++y) {
            for (int x = -3; x <= 3; ++x)
                sum += film::thickness_mm(film.thickness.at(static_cast<int>(x_mm / film.cell_mm) + x,
                                                            static_cast<int>(y_mm / film.cell_mm) + y));
        }
        return sum / 49.0;
    }

    void shift_press(const glm::dvec2& place_mm) {
        const QPointF position = canvas().widget_position(place_mm);
        QMouseEvent event(QEvent::MouseButtonPress, position, canvas().mapToGlobal(position),
                          Qt::LeftButton, Qt::LeftButton, Qt::ShiftModifier);
        QApplication::sendEvent(&canvas(), &event);
    }
};

TEST_F(Guides, TheMirrorPaintsBothSides) {
    give(Command::MirrorSymmetry);
    EXPECT_TRUE(studio().commands().action(Command::MirrorSymmetry)->isChecked());
    mouse_stroke(line_mm({8.0, 12.0}, {20.0, 28.0}));
    EXPECT_GT(paint_at(14.0, 20.0), 0.01);
    EXPECT_GT(paint_at(46.0, 20.0), 0.01);
    settle();
    give(Command::Undo);
    EXPECT_EQ(volume_mm3(), 0.0);
    give(Command::MirrorSymmetry);
    mouse_stroke(line_mm({8.0, 12.0}, {20.0, 28.0}));
    EXPECT_EQ(paint_at(46.0, 20.0), 0.0);
}

TEST_F(Guides, CopiesStandAroundTheMiddle) {
    for (int i = 0; i < 3; ++i)
        give(Command::MoreCopies);
    EXPECT_EQ(studio().easel().hand().symmetry.count, 4);
    mouse_stroke(line_mm({30.0, 8.0}, {36.0, 8.0}));
    EXPECT_GT(paint_at(33.0, 8.0), 0.01);
    EXPECT_GT(paint_at(42.0, 23.0), 0.01);
    EXPECT_GT(paint_at(27.0, 32.0), 0.01);
    EXPECT_GT(paint_at(18.0, 17.0), 0.01);
    for (int i = 0; i < 20; ++i)
        give(Command::FewerCopies);
    EXPECT_EQ(studio().easel().hand().symmetry.count, 1);
    for (int i = 0; i < 20; ++i)
        give(Command::MoreCopies);
    EXPECT_EQ(studio().easel().hand().symmetry.count, 16);
    session().wait_until_applied();
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(Guides, TheAxisIsDrawnOverTheCanvas) {
    const QImage before = picture();
    give(Command::MirrorSymmetry);
    const QImage after = picture();
    EXPECT_GT(difference(before, after).largest, 20);
    const double ratio = canvas().devicePixelRatioF();
    int changed = 0;
    // Off the handles in the middle and on the axis.
    const int y = static_cast<int>(ratio * canvas().widget_position({30.0, 10.0}).y());
    const double axis_px = ratio * canvas().widget_position({30.0, 20.0}).x();
    for (int x = 0; x < after.width(); ++x) {
        if (after.pixel(x, y) == before.pixel(x, y)) continue;
        ++changed;
        EXPECT_NEAR(x, axis_px, 4.0);
    }
    EXPECT_GT(changed, 0);
    give(Command::MirrorSymmetry);
    EXPECT_EQ(difference(before, picture()).largest, 0);
}

TEST_F(Guides, ShiftAndDragDrawAStraightLine) {
    shift_press({10.0, 20.0});
    for (const glm::dvec2& place : line_mm({10.0, 20.0}, {30.0, 5.0}))
        move(place);
    for (const glm::dvec2& place : line_mm({30.0, 5.0}, {50.0, 20.0}))
        move(place);
    EXPECT_EQ(volume_mm3(), 0.0);
    release({50.0, 20.0});
    EXPECT_GT(paint_at(30.0, 20.0), 0.01);
    EXPECT_EQ(paint_at(30.0, 6.0), 0.0);
    // The next stroke is free again.
    mouse_stroke({{10.0, 30.0}, {20.0, 33.0}, {30.0, 36.0}, {40.0, 33.0}, {50.0, 30.0}});
    EXPECT_GT(paint_at(30.0, 35.5), 0.01);
}

TEST_F(Guides, TheRulerKeepsStrokesParallelToTheLast) {
    mouse_stroke(line_mm({10.0, 8.0}, {50.0, 8.0}));
    give(Command::Ruler);
    EXPECT_TRUE(studio().commands().action(Command::Ruler)->isChecked());
    mouse_stroke({{10.0, 24.0}, {20.0, 28.0}, {30.0, 36.0}, {40.0, 28.0}, {50.0, 24.0}});
    EXPECT_GT(paint_at(30.0, 24.0), 0.01);
    EXPECT_EQ(paint_at(30.0, 34.0), 0.0);
    give(Command::Ruler);
    EXPECT_FALSE(studio().easel().hand().ruler().has_value());
}

TEST_F(Guides, TheHandIsSteadiedByTimeOrByAString) {
    auto& mode = *window().findChild<QComboBox*>(QStringLiteral("steady_mode"));
    auto& strength = *window().findChild<QSlider*>(QStringLiteral("steady_strength"));
    const auto choose = [&](int index) {
        mode.setCurrentIndex(index);
        Q_EMIT mode.activated(index);
    };
    const auto steadied = [&] {
        session().wait_until_applied();
        const auto events = session().recording().events;
        return std::get<document::SetStabiliser>(events.back().action).stabiliser;
    };
    EXPECT_FALSE(strength.isEnabled());
    choose(1);
    strength.setValue(strength.maximum() / 2);
    EXPECT_EQ(steadied(), (brush::Stabiliser{200.0, 0.0}));
    choose(2);
    strength.setValue(strength.maximum());
    EXPECT_EQ(steadied(), (brush::Stabiliser{0.0, 20.0}));
    choose(0);
    EXPECT_EQ(steadied(), brush::Stabiliser{});
    EXPECT_FALSE(strength.isEnabled());
    choose(1);
    EXPECT_EQ(steadied(), (brush::Stabiliser{200.0, 0.0})) << "each mode keeps its strength";
    EXPECT_EQ(studio().easel().hand().stabiliser, steadied());
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(Guides, ASteadiedBrushCatchesUpWhileThePenRests) {
    studio().easel().set_stabiliser({150.0, 0.0});
    press({10.0, 20.0});
    for (const glm::dvec2& place : line_mm({10.0, 20.0}, {50.0, 20.0}, 8))
        move(place);
    EXPECT_EQ(paint_at(48.0, 20.0), 0.0);
    wait_for([this] { return paint_at(48.0, 20.0) > 0.01; });
    EXPECT_TRUE(session().status().stroke_in_progress);
    release({50.0, 20.0});
}

TEST_F(Guides, AnotherCanvasKeepsTheMirrorInItsOwnMiddle) {
    give(Command::MirrorSymmetry);
    document::CanvasSettings other = canvas_settings();
    other.width_mm = 40.0;
    parts().files.new_canvas(other);
    loaded();
    settle();
    EXPECT_EQ(studio().easel().hand().symmetry.centre_x_mm, 20.0);
    mouse_stroke(line_mm({6.0, 12.0}, {6.0, 28.0}));
    EXPECT_GT(paint_at(34.0, 20.0), 0.01);
}

TEST_F(Guides, BothMirrorsPaintFourImages) {
    give(Command::MirrorSymmetry);
    give(Command::MirrorLevel);
    EXPECT_TRUE(studio().commands().action(Command::MirrorSymmetry)->isChecked());
    mouse_stroke(line_mm({8.0, 8.0}, {16.0, 10.0}));
    for (const double x_mm : {12.0, 48.0}) {
        for (const double y_mm : {9.0, 31.0})
            EXPECT_GT(paint_at(x_mm, y_mm), 0.01) << x_mm << ", " << y_mm;
    }
    give(Command::MirrorSymmetry);
    EXPECT_FALSE(studio().commands().action(Command::MirrorSymmetry)->isChecked());
    EXPECT_TRUE(studio().commands().action(Command::MirrorLevel)->isChecked());
    give(Command::RemoveGuides);
    EXPECT_FALSE(studio().easel().hand().symmetry.mirror);
    EXPECT_FALSE(studio().commands().action(Command::RemoveGuides)->isEnabled());
}

TEST_F(Guides, TheMirrorIsDraggedByItsCentre) {
    give(Command::MirrorSymmetry);
    press({30.0, 20.0});
    move({25.0, 20.0});
    move({20.0, 20.0});
    release({20.0, 20.0});
    EXPECT_EQ(volume_mm3(), 0.0) << "dragging does not paint";
    // The mouse hits whole pixels, some eight a millimetre.
    EXPECT_NEAR(studio().easel().hand().symmetry.centre_x_mm, 20.0, 0.15);
    mouse_stroke(line_mm({8.0, 12.0}, {8.0, 28.0}));
    EXPECT_GT(paint_at(32.0, 20.0), 0.01);
    EXPECT_EQ(paint_at(52.0, 20.0), 0.0);
}

TEST_F(Guides, WithoutHandlesTheCentreIsPaintedOn) {
    give(Command::MirrorSymmetry);
    const QImage with_handles = picture();
    give(Command::GuideHandles);
    EXPECT_GT(difference(with_handles, picture()).largest, 20);
    mouse_stroke(line_mm({30.0, 20.0}, {40.0, 20.0}));
    EXPECT_GT(volume_mm3(), 0.0);
    EXPECT_EQ(studio().easel().hand().symmetry.centre_x_mm, 30.0);
}

TEST_F(Guides, TheRulerIsDraggedByItsEnds) {
    give(Command::Ruler);  // level, through the middle
    const double end_mm = studio().easel().hand().ruler()->x2_mm;
    press({end_mm, 20.0});
    move({end_mm, 30.0});
    release({end_mm, 30.0});
    EXPECT_NEAR(studio().easel().hand().ruler()->y2_mm, 30.0, 0.15);
    EXPECT_EQ(studio().easel().hand().ruler()->y1_mm, 20.0);
    session().wait_until_applied();
    mouse_stroke({{10.0, 12.0}, {30.0, 12.0}});
    const auto& form = studio().easel().hand().guide.form;
    EXPECT_EQ(std::get<brush::Ruler>(form), *studio().easel().hand().ruler());
}

TEST_F(Guides, StrokesRunAlongTheEllipse) {
    give(Command::Ruler);
    give(Command::Ellipse);
    EXPECT_FALSE(studio().commands().action(Command::Ruler)->isChecked()) << "one guide at a time";
    auto* width = window().findChild<QDoubleSpinBox*>(QStringLiteral("ellipse_width"));
    width->setValue(40.0);
    ASSERT_TRUE(studio().easel().hand().ellipse().has_value());
    EXPECT_EQ(studio().easel().hand().ellipse()->half_width_mm, 20.0);
    // A straight movement from the ellipse's left end over its top; its half height is 12 mm.
    mouse_stroke({{10.5, 19.0}, {14.0, 11.0}, {22.0, 6.0}, {30.0, 4.0}});
    EXPECT_GT(paint_at(30.0 - 20.0 * std::sqrt(0.5), 20.0 - 12.0 * std::sqrt(0.5)), 0.01);
    EXPECT_EQ(paint_at(22.0, 5.0), 0.0);
}

TEST_F(Guides, StrokesRunToTheVanishingPoint) {
    give(Command::OnePointPerspective);
    EXPECT_TRUE(studio().commands().action(Command::OnePointPerspective)->isChecked());
    window().findChild<QDoubleSpinBox*>(QStringLiteral("first_point_x"))->setValue(120.0);
    window().findChild<QDoubleSpinBox*>(QStringLiteral("first_point_y"))->setValue(20.0);
    mouse_stroke({{10.0, 8.0}, {14.0, 8.4}, {20.0, 12.0}, {30.0, 18.0}, {40.0, 20.0}});
    EXPECT_GT(paint_at(30.0, 8.0 + 12.0 * 20.0 / 110.0), 0.01);
    EXPECT_EQ(paint_at(30.0, 18.0), 0.0);
    EXPECT_EQ(std::get<brush::VanishingPoints>(studio().easel().hand().guide.form).x1_mm, 120.0);
}

TEST_F(Guides, APointBesideTheCanvasIsDraggedByTheEdge) {
    give(Command::TwoPointPerspective);
    const auto points = [&] {
        return std::get<brush::VanishingPoints>(studio().easel().hand().laid.form);
    };
    const brush::VanishingPoints before = points();
    ASSERT_GT(before.x2_mm, 60.0);
    const glm::dvec2 handle{60.0 - 0.03 * 40.0, before.y2_mm};
    press(handle);
    move(handle + glm::dvec2(0.0, 3.0));
    move(handle + glm::dvec2(0.0, 6.0));
    release(handle + glm::dvec2(0.0, 6.0));
    EXPECT_EQ(volume_mm3(), 0.0) << "dragging does not paint";
    EXPECT_NEAR(points().x2_mm, before.x2_mm, 0.15);
    EXPECT_NEAR(points().y2_mm, before.y2_mm + 6.0, 0.15);
    EXPECT_GT(points().upright_deg, 91.0) << "uprights stand on the horizon";
}

TEST_F(Guides, TheHorizonIsTurnedByItsHandle) {
    give(Command::OnePointPerspective);
    const auto points = [&] {
        return std::get<brush::VanishingPoints>(studio().easel().hand().laid.form);
    };
    const glm::dvec2 handle{points().x1_mm + 0.4 * 40.0, points().y1_mm};
    press(handle);
    move(handle + glm::dvec2(0.0, 8.0));
    move(handle + glm::dvec2(0.0, 16.0));
    release(handle + glm::dvec2(0.0, 16.0));
    EXPECT_NEAR(points().level_deg, 45.0, 1.0);
    EXPECT_DOUBLE_EQ(points().upright_deg, points().level_deg + 90.0);
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(Guides, StrokesSnapOntoTheLinesOfTheGrid) {
    give(Command::GuideGrid);  // a line through the middle every 20 mm
    mouse_stroke({{8.0, 22.0}, {14.0, 22.5}, {20.0, 26.0}, {30.0, 30.0}, {40.0, 30.0}});
    EXPECT_GT(paint_at(30.0, 20.0), 0.01);
    EXPECT_EQ(paint_at(30.0, 29.0), 0.0);
}

TEST_F(Guides, AHandThatDoesNotSnapIsFreeAndTheGuideStays) {
    give(Command::GuideGrid);
    auto* strength = window().findChild<QDoubleSpinBox*>(QStringLiteral("guide_strength"));
    strength->setValue(50.0);
    EXPECT_EQ(studio().easel().hand().laid.strength, 0.5);
    give(Command::SnapToGuide);
    EXPECT_FALSE(studio().commands().action(Command::SnapToGuide)->isChecked());
    EXPECT_EQ(strength->value(), 0.0);
    mouse_stroke({{8.0, 24.0}, {14.0, 24.5}, {20.0, 27.0}, {30.0, 32.0}, {40.0, 32.0}});
    EXPECT_GT(paint_at(30.0, 32.0), 0.01);
    EXPECT_EQ(paint_at(30.0, 20.0), 0.0);
    EXPECT_TRUE(studio().commands().action(Command::GuideGrid)->isChecked());
    give(Command::SnapToGuide);
    EXPECT_EQ(studio().easel().hand().laid.strength, 0.5) << "as strong as before";
    session().wait_until_applied();
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(Guides, ThePanelHasTheNumbersOfWhatLies) {
    auto& kind = *window().findChild<QComboBox*>(QStringLiteral("guide_kind"));
    const auto choose = [&](tools::GuideKind chosen) {
        kind.setCurrentIndex(kind.findData(static_cast<int>(chosen)));
        Q_EMIT kind.activated(kind.currentIndex());
    };
    const auto has = [&](const char* name) {
        return !window().findChild<QDoubleSpinBox*>(QString::fromLatin1(name))->isHidden();
    };
    EXPECT_FALSE(has("ruler_x"));
    choose(tools::GuideKind::ParallelRuler);
    EXPECT_EQ(studio().easel().hand().laid.reach_mm, 0.0);
    EXPECT_TRUE(studio().commands().action(Command::ParallelRuler)->isChecked());
    EXPECT_TRUE(has("ruler_x"));
    EXPECT_FALSE(has("guide_reach"));
    choose(tools::GuideKind::Ruler);
    EXPECT_GT(studio().easel().hand().laid.reach_mm, 0.0);
    EXPECT_TRUE(has("guide_reach"));
    choose(tools::GuideKind::TwoPoints);
    EXPECT_TRUE(has("second_point_x"));
    EXPECT_FALSE(has("third_point_x"));
    choose(tools::GuideKind::ThreePoints);
    EXPECT_TRUE(has("third_point_x"));
    choose(tools::GuideKind::None);
    EXPECT_FALSE(has("first_point_x"));
    EXPECT_FALSE(studio().commands().action(Command::RemoveGuides)->isEnabled());
}

TEST_F(Guides, EachIsDrawnOverTheCanvasAndTakenAwayAgain) {
    const QImage bare = picture();
    for (const Command command :
         {Command::ParallelRuler, Command::ConcentricEllipse, Command::OnePointPerspective,
          Command::TwoPointPerspective, Command::ThreePointPerspective, Command::GuideGrid}) {
        give(command);
        EXPECT_GT(difference(bare, picture()).largest, 20);
        give(Command::RemoveGuides);
        EXPECT_EQ(difference(bare, picture()).largest, 0);
    }
}

TEST_F(Guides, APerspectiveTurnsWithTheCanvas) {
    give(Command::TwoPointPerspective);
    mouse_stroke(line_mm({30.0, 10.0}, {30.0, 30.0}));
    settle();
    const auto points = [&] {
        return std::get<brush::VanishingPoints>(studio().easel().hand().laid.form);
    };
    const brush::VanishingPoints before = points();
    give(Command::RotateImageRight);
    settle();
    EXPECT_DOUBLE_EQ(points().x1_mm, 40.0 - before.y1_mm);
    EXPECT_DOUBLE_EQ(points().y1_mm, before.x1_mm);
    EXPECT_DOUBLE_EQ(std::abs(points().upright_deg), 180.0);
    give(Command::Undo);
    settle();
    EXPECT_DOUBLE_EQ(points().x2_mm, before.x2_mm);
}

TEST_F(Guides, NumbersMoveTheMirrorToo) {
    give(Command::MirrorSymmetry);
    window().findChild<QDoubleSpinBox*>(QStringLiteral("symmetry_x"))->setValue(20.0);
    window().findChild<QDoubleSpinBox*>(QStringLiteral("copies"))->setValue(3.0);
    EXPECT_EQ(studio().easel().hand().symmetry.centre_x_mm, 20.0);
    EXPECT_EQ(studio().easel().hand().symmetry.count, 3);
    EXPECT_TRUE(studio().easel().hand().symmetry.mirror);
    session().wait_until_applied();
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(Guides, ALostReleaseEndsTheStroke) {
    press({10.0, 20.0});
    move({20.0, 20.0});
    move({50.0, 35.0}, Qt::NoButton);
    session().wait_until_applied();
    EXPECT_FALSE(session().status().stroke_in_progress);
    EXPECT_EQ(paint_at(40.0, 30.0), 0.0);
}

}  // namespace
}  // namespace pastoso::tests
