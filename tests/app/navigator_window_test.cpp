// The navigator: its frame lies where the window is, and moves it, also turned and mirrored.
#include "app/window_fixture.hpp"
#include "panels/canvas/navigator_map.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QTest>
#include <QWheelEvent>
#include <glm/geometric.hpp>

namespace pastoso::tests {
namespace {

using commands::Command;

class Navigator : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        action(Command::NavigatorPanel)->trigger();
        wait_for([this] { return colour_on_map({30.0, 20.0}).lightness() > 180; });
        canvas().zoom_about_centre(4.0);
    }
    template <class Widget>
    Widget& find(const char* name) {
        auto* found = window().findChild<Widget*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    panels::NavigatorMap& map() { return find<panels::NavigatorMap>("navigator_map"); }

    glm::dvec2 size_mm() { return canvas().canvas_size_mm(); }
    glm::dvec2 centre_mm() {
        return canvas().canvas_mm({0.5 * canvas().width(), 0.5 * canvas().height()});
    }
    QPointF on_map(const glm::dvec2& mm) {
        return map().widget_position({mm.x / size_mm().x, mm.y / size_mm().y});
    }
    double map_px_per_mm() { return (on_map({1.0, 0.0}) - on_map({0.0, 0.0})).x(); }

    void send(QEvent::Type type, const QPointF& position, Qt::MouseButtons buttons) {
        QMouseEvent event(type, position, map().mapToGlobal(position),
                          type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, buttons, {});
        QApplication::sendEvent(&map(), &event);
    }
    void drag(const QPointF& from, const QPointF& way) {
        send(QEvent::MouseButtonPress, from, Qt::LeftButton);
        for (const double share : {0.3, 0.7, 1.0})
            send(QEvent::MouseMove, from + share * way, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, from + way, Qt::NoButton);
    }
    void expect_frame_where_the_window_is() {
        const QPointF corners[] = {{0.0, 0.0},
                                   {1.0 * canvas().width(), 0.0},
                                   {1.0 * canvas().width(), 1.0 * canvas().height()},
                                   {0.0, 1.0 * canvas().height()}};
        ASSERT_EQ(map().frame().size(), 4);
        for (int i = 0; i < 4; ++i) {
            const glm::dvec2 mm = canvas().canvas_mm(corners[i]);
            EXPECT_NEAR(map().frame()[i].x(), mm.x / size_mm().x, 1e-9);
            EXPECT_NEAR(map().frame()[i].y(), mm.y / size_mm().y, 1e-9);
        }
    }
    /// Of the canvas's picture in the panel, without the frame's lines.
    QColor colour_on_map(const glm::dvec2& mm) {
        const QImage image = map().grab().toImage();
        const double ratio = image.devicePixelRatio();
        return image.pixelColor((on_map(mm) * ratio).toPoint());
    }
    /// The least and the most around a place of the panel.
    std::pair<int, int> lightness_about(const QPointF& position, int reach_px) {
        const QImage image = map().grab().toImage();
        const QPoint middle = (position * image.devicePixelRatio()).toPoint();
        std::pair<int, int> range(255, 0);
        for (int y = -reach_px; y <= reach_px; ++y) {
            for (int x = -reach_px; x <= reach_px; ++x) {
                const int here = image.pixelColor(middle + QPoint(x, y)).lightness();
                range = {std::min(range.first, here), std::max(range.second, here)};
            }
        }
        return range;
    }
};

TEST_F(Navigator, AKeyShowsIt) {
    find<QDockWidget>("navigator_panel").hide();
    QTest::keyClick(&window(), Qt::Key_F7, Qt::ShiftModifier);
    EXPECT_TRUE(find<QDockWidget>("navigator_panel").isVisible());
}

TEST_F(Navigator, TheFrameLiesWhereTheWindowIs) {
    expect_frame_where_the_window_is();
    canvas().turn_about_centre(30.0);
    expect_frame_where_the_window_is();
    canvas().mirror();
    expect_frame_where_the_window_is();
    canvas().fit();
    expect_frame_where_the_window_is();
    EXPECT_LT(map().frame()[0].x(), 1.0);
}

TEST_F(Navigator, TheFrameIsDrawnThere) {
    for (int edge = 1; edge < 4; ++edge) {
        action(Command::TurnRight)->trigger();
        const QPointF middle = 0.5 * (map().widget_position(map().frame()[edge]) +
                                      map().widget_position(map().frame()[(edge + 1) % 4]));
        // A light line between dark ones, on the bare canvas, which is light.
        EXPECT_GT(lightness_about(middle, 1).second, 180) << edge;
        EXPECT_LT(lightness_about(middle, 3).first, 150) << edge;
        canvas().fit();
        EXPECT_GT(lightness_about(middle, 3).first, 180) << edge;
        canvas().zoom_about_centre(4.0);
    }
}

TEST_F(Navigator, DraggingTheFrameMovesTheViewByAsMuch) {
    for (const double turn_deg : {0.0, 90.0, 33.0}) {
        for (const bool mirrored : {false, true}) {
            canvas().fit();
            canvas().turn_upright();
            canvas().zoom_about_centre(4.0);
            if (canvas().view_transform().mirrored != mirrored) canvas().mirror();
            canvas().turn_about_centre(turn_deg);
            canvas().show_at_centre(0.5 * size_mm());
            const glm::dvec2 before = centre_mm();
            const QPointF way(21.0, -13.0);
            drag(on_map(before) + QPointF(3.0, 2.0), way);
            const glm::dvec2 moved = centre_mm() - before;
            EXPECT_NEAR(moved.x, way.x() / map_px_per_mm(), 1e-6) << turn_deg << mirrored;
            EXPECT_NEAR(moved.y, way.y() / map_px_per_mm(), 1e-6) << turn_deg << mirrored;
        }
    }
}

TEST_F(Navigator, AClickGoesThere) {
    canvas().turn_about_centre(20.0);
    const glm::dvec2 place{12.0, 30.0};
    drag(on_map(place), {});
    EXPECT_LT(glm::distance(centre_mm(), place), 1e-6);
    const glm::dvec2 near_by{13.0, 30.5};  // in the frame that is there now
    drag(on_map(near_by), {});
    EXPECT_LT(glm::distance(centre_mm(), near_by), 1e-6);
}

TEST_F(Navigator, TheWheelZoomsAboutTheMiddle) {
    const glm::dvec2 before = centre_mm();
    const double zoom = canvas().view_transform().zoom;
    const QPointF position(5.0, 5.0);
    QWheelEvent event(position, map().mapToGlobal(position), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&map(), &event);
    EXPECT_NEAR(canvas().view_transform().zoom, 1.25 * zoom, 1e-9);
    EXPECT_LT(glm::distance(centre_mm(), before), 1e-6);
}

TEST_F(Navigator, ZoomAndTurnAreShownAndTyped) {
    const double zoom = canvas().view_transform().zoom;
    auto& zoom_box = find<QDoubleSpinBox>("navigator_zoom");
    auto& angle_box = find<QDoubleSpinBox>("navigator_angle");
    EXPECT_NEAR(zoom_box.value(), 100.0 * zoom, 0.06);
    zoom_box.setValue(250.0);
    EXPECT_NEAR(canvas().view_transform().zoom, 2.5, 1e-9);
    angle_box.setValue(-40.0);
    EXPECT_NEAR(canvas().view_transform().angle_deg, -40.0, 1e-9);
    action(Command::TurnUpright)->trigger();
    EXPECT_EQ(angle_box.value(), 0.0);
    canvas().fit();
    EXPECT_NEAR(zoom_box.value(), 100.0 * canvas().view_transform().zoom, 0.06);
}

TEST_F(Navigator, ThePictureFollowsThePaint) {
    canvas().fit();
    canvas().show_at_centre({-20.0, -15.0});  // the frame is out of the way
    wait_for([this] { return colour_on_map({30.0, 20.0}).lightness() > 180; });
    canvas().fit();
    mouse_stroke(line_mm({20.0, 20.0}, {40.0, 20.0}));
    wait_for([this] { return colour_on_map({30.0, 20.0}).lightness() < 120; });
    EXPECT_GT(colour_on_map({30.0, 35.0}).lightness(), 180);
}

TEST_F(Navigator, ArrowKeysGoAcrossTheScreen) {
    canvas().turn_about_centre(90.0);
    canvas().show_at_centre(0.5 * size_mm());
    const QPointF before(0.5 * canvas().width(), 0.5 * canvas().height());
    const glm::dvec2 place = centre_mm();
    map().setFocus();
    QTest::keyClick(&map(), Qt::Key_Right);
    const QPointF after = canvas().widget_position(place);
    EXPECT_NEAR(before.x() - after.x(), 0.1 * canvas().width(), 1.0);
    EXPECT_NEAR(after.y(), before.y(), 1.0);
}

}  // namespace
}  // namespace pastoso::tests
