// Moving, scaling and turning paint in the real window: by dragging the frame, by keys and by numbers.
#include "app/canvas_mouse.hpp"
#include "app/window_fixture.hpp"
#include "appearance/said_value.hpp"
#include "dialogs/transform_dialog.hpp"
#include "main/canvas/dialog_corner.hpp"
#include "main/window_parts.hpp"

#include <cmath>
#include <variant>

#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QStatusBar>
#include <QTest>
#include <QToolButton>
#include <glm/vec3.hpp>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;

class TransformWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        give(Command::Pause);
        studio().easel().take_brush("Flat bristle 20", 4.0);
        mouse_stroke(line_mm({10.0, 10.0}, {20.0, 14.0}));
        settle();
    }

    void give(Command command) {
        ASSERT_TRUE(action(command)->isEnabled()) << action(command)->text().toStdString();
        action(command)->trigger();
        settle();
    }
    void key(Qt::Key key, Qt::KeyboardModifiers keys = {}) {
        QTest::keyClick(&canvas(), key, keys);
        settle();
    }
    const std::optional<tools::TransformFrame>& frame() { return studio().on_canvas().frame.shown(); }
    void begin() {
        key(Qt::Key_T, Qt::ControlModifier);
        ASSERT_TRUE(frame().has_value()) << told();
    }
    void begin_refused(const char* why) {
        key(Qt::Key_T, Qt::ControlModifier);
        EXPECT_FALSE(frame().has_value());
        EXPECT_FALSE(action(Command::TransformLayer)->isChecked());
        EXPECT_THAT(told(), testing::HasSubstr(why));
    }

    void send(QEvent::Type type, const glm::dvec2& place_mm, Qt::KeyboardModifiers keys) {
        send_mouse(canvas(), type, place_mm, keys);
    }
    void drag(const glm::dvec2& from_mm, const glm::dvec2& to_mm, Qt::KeyboardModifiers keys = {}) {
        send(QEvent::MouseButtonPress, from_mm, keys);
        for (const glm::dvec2& place_mm : line_mm(from_mm, to_mm, 5))
            send(QEvent::MouseMove, place_mm, keys);
        send(QEvent::MouseButtonRelease, to_mm, keys);
    }
    glm::dvec2 handle(int x, int y) { return tools::handle_mm(*frame(), {x, y}); }
    glm::dvec2 middle() { return handle(0, 0); }

    dialogs::TransformDialog* dialog() {
        auto* found = window().findChild<dialogs::TransformDialog*>();
        return found != nullptr && found->isVisible() ? found : nullptr;
    }
    QDoubleSpinBox& box(const char* name) {
        return *dialog()->findChild<QDoubleSpinBox*>(QLatin1String(name));
    }
    QToolButton& mirror(const char* name) {
        return *dialog()->findChild<QToolButton*>(QLatin1String(name));
    }
    std::string outcome() {
        return dialog()->findChild<QLabel*>(QStringLiteral("outcome"))->text().toStdString();
    }
    QPushButton& button(QDialogButtonBox::StandardButton which) {
        return *dialog()->findChild<QDialogButtonBox*>()->button(which);
    }

    std::shared_ptr<const document::Snapshot> painting() {
        session().wait_until_applied();
        return session().snapshot();
    }
    std::size_t events_posted() {
        session().wait_until_applied();
        return session().recording().events.size();
    }
    std::uint64_t hash() { return film::state_hash(painting()->film); }

    /// Of so many pixels around a place, whose weave is shaded.
    glm::dvec3 mean_rgb(const glm::dvec2& place_mm) {
        constexpr int kSide = 9;
        const QImage seen = picture();
        const QPoint middle =
            (canvas().devicePixelRatioF() * canvas().widget_position(place_mm)).toPoint();
        glm::dvec3 sum(0.0);
        for (int i = 0; i < kSide * kSide; ++i) {
            const QColor colour =
                seen.pixelColor(middle + QPoint(i % kSide - kSide / 2, i / kSide - kSide / 2));
            sum += glm::dvec3(colour.red(), colour.green(), colour.blue());
        }
        return sum / static_cast<double>(kSide * kSide);
    }
    /// An even coat on a layer of its own.
    void lay_dry_layer(const char* pigment, double thickness_mm) {
        give(Command::AddLayer);
        session().post(
            document::FillWithPaint{.paint = {{{pigment, 1.0}}, 1.0}, .thickness_mm = thickness_mm});
        settle();
        give(Command::DryNow);
    }

    /// Whether every cell holds what the cell that lies so much before it held.
    static void expect_moved(const film::FilmState& before, const film::FilmState& after, int x_cells,
                             int y_cells) {
        for (int y = 0; y < after.shape.height; ++y)
            for (int x = 0; x < after.shape.width; ++x) {
                const int from_x = x - x_cells, from_y = y - y_cells;
                const bool inside = before.shape.contains(from_x, from_y);
                ASSERT_EQ(after.thickness.at(x, y), inside ? before.thickness.at(from_x, from_y) : 0)
                    << x << ", " << y;
            }
    }
};

/// The mouse hits whole pixels, some eight a millimetre.
constexpr double kPixel_mm = 0.2;

TEST_F(TransformWindow, PaintIsMovedByDraggingTheFrameAndEnter) {
    const auto before = painting();
    begin();
    ASSERT_NE(dialog(), nullptr);
    EXPECT_TRUE(action(Command::TransformLayer)->isChecked());
    drag(middle(), middle() + glm::dvec2(15.0, 8.0));
    EXPECT_NEAR(frame()->move_mm.x, 15.0, 2.0 * kPixel_mm);
    EXPECT_EQ(box("move_x").value(), frame()->move_mm.x);
    EXPECT_EQ(hash(), film::state_hash(before->film)) << "the paint comes with Enter";
    const glm::dvec2 cells = 4.0 * frame()->move_mm;
    key(Qt::Key_Return);
    EXPECT_FALSE(frame().has_value());
    EXPECT_EQ(dialog(), nullptr);
    EXPECT_FALSE(action(Command::TransformLayer)->isChecked());
    expect_moved(before->film, painting()->film, static_cast<int>(cells.x), static_cast<int>(cells.y));
    give(Command::Undo);
    EXPECT_EQ(hash(), film::state_hash(before->film));
    give(Command::Redo);
    expect_moved(before->film, painting()->film, static_cast<int>(cells.x), static_cast<int>(cells.y));
}

TEST_F(TransformWindow, APenDragsTheFrameToo) {
    const std::size_t events = events_posted();
    begin();
    pen_stroke(line_mm(middle(), middle() + glm::dvec2(10.0, 5.0), 5), {.pressure = 0.8});
    EXPECT_NEAR(frame()->move_mm.x, 10.0, 2.0 * kPixel_mm);
    EXPECT_NEAR(frame()->move_mm.y, 5.0, 2.0 * kPixel_mm);
    EXPECT_EQ(events_posted(), events);
}

TEST_F(TransformWindow, TheFrameShowsThePaintWhereItWouldLie) {
    begin();
    const double ratio = canvas().devicePixelRatioF();
    const auto light_at = [&](const QImage& seen, const glm::dvec2& place_mm) {
        const QPointF px = ratio * canvas().widget_position(place_mm);
        return qGray(seen.pixel(px.toPoint()));
    };
    const glm::dvec2 painted{15.0, 12.0}, shift{20.0, 15.0};
    const QImage before = picture();
    drag(middle(), middle() + shift);
    const QImage after = picture();
    EXPECT_LT(light_at(after, painted + shift), light_at(before, painted + shift) - 60);
    EXPECT_GT(light_at(after, painted), light_at(before, painted) + 60) << "veiled where it lies";
    key(Qt::Key_Escape);
    EXPECT_EQ(light_at(picture(), painted), light_at(before, painted));
}

TEST_F(TransformWindow, NoShadeOfThePaintIsLeftWhereItLay) {
    const auto mean_red = [&](const glm::dvec2& place_mm) { return mean_rgb(place_mm).r; };
    const glm::dvec2 painted{15.0, 12.0}, beside{15.0, 24.0};
    const double lower = mean_red(painted), bare = mean_red(beside);
    begin();
    drag(middle(), middle() + glm::dvec2(20.0, 15.0));
    EXPECT_NEAR(mean_red(painted), bare, 15.0);
    key(Qt::Key_Escape);
    give(Command::AddLayer);
    studio().easel().choose_paint({{{"PW6", 1.0}}, 1.0});
    mouse_stroke(line_mm({10.0, 10.0}, {20.0, 14.0}));
    settle();
    EXPECT_GT(mean_red(painted), lower + 60.0) << "white lies on it";
    begin();
    drag(middle(), middle() + glm::dvec2(20.0, 15.0));
    EXPECT_LT(mean_red(painted), lower + 30.0) << "the layer below is seen again";
}

TEST_F(TransformWindow, AGlazeBelowIsSeenOverWhatItLiesOn) {
    lay_dry_layer("PY74", 0.1);
    lay_dry_layer("PB29", 0.02);
    const glm::dvec2 painted{35.0, 22.0};
    const double lower = mean_rgb(painted).b;
    give(Command::AddLayer);
    studio().easel().choose_paint({{{"PW6", 1.0}}, 1.0});
    mouse_stroke(line_mm({30.0, 20.0}, {40.0, 24.0}));
    settle();
    EXPECT_GT(mean_rgb(painted).b, lower + 60.0) << "white lies on it";
    begin();
    drag(middle(), middle() + glm::dvec2(-15.0, 0.0));
    EXPECT_LT(mean_rgb(painted).b, lower + 30.0) << "the glaze alone would be bluer";
}

TEST_F(TransformWindow, EscapeLeavesAllBits) {
    const std::uint64_t before = hash();
    const std::size_t events = events_posted();
    begin();
    drag(handle(1, 1), handle(1, 1) + glm::dvec2(10.0, 10.0));
    drag(middle(), middle() + glm::dvec2(3.0, 8.0));
    // In the middle of a drag it gives up the drag alone.
    const tools::TransformFrame pressed = *frame();
    send(QEvent::MouseButtonPress, middle(), {});
    send(QEvent::MouseMove, middle() + glm::dvec2(9.0, 0.0), {});
    EXPECT_NE(*frame(), pressed);
    key(Qt::Key_Escape);
    ASSERT_TRUE(frame().has_value());
    EXPECT_EQ(*frame(), pressed);
    EXPECT_EQ(box("move_x").value(), std::round(100.0 * pressed.move_mm.x) / 100.0);
    key(Qt::Key_Escape);
    EXPECT_FALSE(frame().has_value());
    EXPECT_EQ(dialog(), nullptr);
    EXPECT_EQ(hash(), before);
    EXPECT_EQ(events_posted(), events);
}

TEST_F(TransformWindow, HandlesScaleAndOutsideTurns) {
    begin();
    const glm::dvec2 size = frame()->size_mm;
    const glm::dvec2 fixed = handle(-1, -1);
    drag(handle(1, 1), handle(1, 1) + size, Qt::ShiftModifier);
    EXPECT_NEAR(frame()->scale.x, 2.0, kPixel_mm);
    EXPECT_EQ(frame()->scale.x, frame()->scale.y);
    EXPECT_NEAR(handle(-1, -1).x, fixed.x, 1e-9);
    EXPECT_NEAR(box("width").value(), 100.0 * frame()->scale.x, 0.0051);
    EXPECT_THAT(outcome(), HasSubstr("keeps its thickness"));
    const glm::dvec2 right = middle() + glm::dvec2(size.x + 4.0, 0.0);
    drag(right, middle() + glm::dvec2(0.5, size.x + 4.0), Qt::ShiftModifier);
    EXPECT_EQ(frame()->turn_deg, 90.0);
    EXPECT_EQ(box("turn").value(), 90.0);
    const double before_mm3 = volume_mm3();
    const double share = frame()->scale.x * frame()->scale.y;
    key(Qt::Key_Enter);
    // The rule of volume, within what an interpolation keeps (docs/decisions/0030).
    EXPECT_NEAR(volume_mm3(), share * before_mm3, 0.02 * share * before_mm3);
}

TEST_F(TransformWindow, ControlPullsACornerIntoPerspective) {
    const auto before = painting();
    begin();
    const glm::dvec2 corner = handle(1, -1), others[] = {handle(-1, -1), handle(1, 1), handle(-1, 1)};
    const glm::dvec2 way(-0.2 * frame()->size_mm.x, 0.3 * frame()->size_mm.y);
    drag(corner, corner + way, Qt::ControlModifier);
    ASSERT_TRUE(frame()->is_distorted());
    EXPECT_NEAR(handle(1, -1).x, corner.x + way.x, 2.0 * kPixel_mm);
    EXPECT_NEAR(handle(1, -1).y, corner.y + way.y, 2.0 * kPixel_mm);
    EXPECT_NEAR(handle(-1, -1).x, others[0].x, 1e-9);
    EXPECT_NEAR(handle(1, 1).y, others[1].y, 1e-9);
    EXPECT_NEAR(handle(-1, 1).x, others[2].x, 1e-9);
    EXPECT_THAT(outcome(), HasSubstr("keeps its thickness"));
    key(Qt::Key_Return);
    EXPECT_FALSE(frame().has_value());
    session().wait_until_applied();
    EXPECT_TRUE(
        std::holds_alternative<document::DistortLayer>(session().recording().events.back().action));
    EXPECT_NE(hash(), film::state_hash(before->film));
    give(Command::Undo);
    EXPECT_EQ(hash(), film::state_hash(before->film));
}

TEST_F(TransformWindow, KeysPullCornersByPixelsOfTheScreen) {
    const auto before = painting();
    begin();
    const interactions::Frame& shown = studio().on_canvas().frame;
    const auto on_screen = [&](int x, int y) { return canvas().widget_position(handle(x, y)); };
    const QPointF upper_left = on_screen(-1, -1), lower_right = on_screen(1, 1);
    const glm::dvec2 upper_right = handle(1, -1);
    key(Qt::Key_Left);
    EXPECT_FALSE(frame()->is_distorted()) << "no corner is chosen";
    key(Qt::Key_Tab);
    EXPECT_EQ(shown.corner(), std::optional<std::size_t>(0));
    EXPECT_FALSE(action(Command::CanvasOnly)->isChecked()) << "its key is the frame's now";
    key(Qt::Key_Left);
    key(Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_NEAR(on_screen(-1, -1).x(), upper_left.x() - 1.0, 1e-3);
    EXPECT_NEAR(on_screen(-1, -1).y(), upper_left.y() - 10.0, 1e-3);
    EXPECT_NEAR(handle(1, -1).x, upper_right.x, 1e-9);
    EXPECT_NEAR(handle(1, -1).y, upper_right.y, 1e-9);
    EXPECT_THAT(appearance::said_value(canvas()).toStdString(), HasSubstr("Upper left corner at"));
    const double zoom = canvas().view_transform().zoom;
    key(Qt::Key_3);
    EXPECT_EQ(shown.corner(), std::optional<std::size_t>(2));
    key(Qt::Key_1);
    EXPECT_EQ(canvas().view_transform().zoom, zoom) << "it is no key of the view now";
    key(Qt::Key_3);
    key(Qt::Key_Right);
    key(Qt::Key_Down);
    EXPECT_NEAR(on_screen(1, 1).x(), lower_right.x() + 1.0, 1e-3);
    EXPECT_NEAR(on_screen(1, 1).y(), lower_right.y() + 1.0, 1e-3);
    key(Qt::Key_Tab);
    key(Qt::Key_Tab);
    EXPECT_EQ(shown.corner(), std::nullopt) << "after the last one none";
    EXPECT_EQ(appearance::said_value(canvas()).toStdString(), "No corner is chosen");
    key(Qt::Key_Return);
    EXPECT_FALSE(frame().has_value());
    EXPECT_NE(hash(), film::state_hash(before->film));
    give(Command::Undo);
    EXPECT_EQ(hash(), film::state_hash(before->film));
    key(Qt::Key_Tab);
    EXPECT_TRUE(action(Command::CanvasOnly)->isChecked());
    key(Qt::Key_Tab);
}

TEST_F(TransformWindow, ArrowsMoveACornerAsItIsSeenInAMirror) {
    give(Command::MirrorView);
    begin();
    const QPointF seen = canvas().widget_position(handle(-1, -1));
    key(Qt::Key_1);
    key(Qt::Key_Left);
    EXPECT_NEAR(canvas().widget_position(handle(-1, -1)).x(), seen.x() - 1.0, 1e-3);
    EXPECT_GT(frame()->pull_mm[0].x, 0.0);
    key(Qt::Key_Escape);
    give(Command::MirrorView);
}

TEST_F(TransformWindow, TheDialogOpensInTheFirstCornerThatIsFree) {
    const QSize size(200, 300), view(1000, 800);
    const auto place = [&](const QRect& frame) { return main::place_beside(frame, size, view); };
    EXPECT_EQ(place({100, 500, 200, 200}), QPoint(784, 484)) << "on the other side";
    EXPECT_EQ(place({600, 450, 380, 340}), QPoint(16, 484));
    EXPECT_EQ(place({0, 400, 1000, 400}), QPoint(784, 16)) << "above it";
    EXPECT_EQ(place({0, 0, 1000, 400}), QPoint(784, 484));
    EXPECT_EQ(place({300, 0, 700, 800}), QPoint(16, 484));
    EXPECT_EQ(place({-100, -100, 2000, 2000}), QPoint(16, 484)) << "there is no room";
    begin();
    const QRect dialog_is(canvas().mapFromGlobal(dialog()->pos()), dialog()->size());
    for (const glm::ivec2& side : tools::kFrameHandles)
        EXPECT_FALSE(
            dialog_is.contains(canvas().widget_position(tools::handle_mm(*frame(), side)).toPoint()));
    key(Qt::Key_Escape);
}

TEST_F(TransformWindow, ControlPullsASideAskewAndNoCornerFolds) {
    begin();
    const glm::dvec2 upper = handle(0, -1), lower_left = handle(-1, 1);
    drag(upper, upper + glm::dvec2(5.0, 0.5), Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_NEAR(handle(0, -1).x, upper.x + 5.0, 2.0 * kPixel_mm);
    EXPECT_NEAR(handle(0, -1).y, upper.y, 1e-9);
    EXPECT_NEAR(handle(-1, 1).x, lower_left.x, 1e-9);
    EXPECT_NEAR(tools::area_growth(*frame()), 1.0, 1e-9);
    drag(handle(1, 1), handle(-1, -1) - glm::dvec2(3.0, 3.0), Qt::ControlModifier);
    EXPECT_TRUE(tools::problem_of(*frame()).empty()) << "it stops before";
    EXPECT_TRUE(button(QDialogButtonBox::Ok).isEnabled());
    const std::size_t events = events_posted();
    key(Qt::Key_Escape);
    EXPECT_EQ(events_posted(), events);
}

TEST_F(TransformWindow, WaysMayBeTypedInOtherUnits) {
    begin();
    const auto type = [this](const char* name, const char* words) {
        box(name).setFocus();
        box(name).selectAll();
        QTest::keyClicks(&box(name), QString::fromLatin1(words));
        QTest::keyClick(&box(name), Qt::Key_Tab);
    };
    type("move_x", "1.2 cm");
    type("move_y", "-1 in");
    EXPECT_EQ(box("move_x").value(), 12.0);
    EXPECT_EQ(box("move_y").value(), -25.4);
    EXPECT_EQ(frame()->move_mm, glm::dvec2(12.0, -25.4));
}

TEST_F(TransformWindow, NumbersAndFrameKeepInStep) {
    const auto before = painting();
    begin();
    box("move_x").setValue(12.0);
    box("move_y").setValue(-2.5);
    EXPECT_EQ(frame()->move_mm, glm::dvec2(12.0, -2.5));
    mirror("mirror_x").click();
    EXPECT_EQ(frame()->scale, glm::dvec2(-1.0, 1.0));
    box("height").setValue(150.0);
    box("turn").setValue(-30.0);
    EXPECT_EQ(frame()->scale, glm::dvec2(-1.0, 1.5));
    EXPECT_EQ(frame()->turn_deg, -30.0);
    EXPECT_THAT(outcome(), HasSubstr("150 %"));
    // Drawn across its own left side it is mirrored back.
    box("height").setValue(100.0);
    box("turn").setValue(0.0);
    drag(handle(1, 0), handle(-1, 0) + handle(-1, 0) - handle(1, 0));
    EXPECT_FALSE(mirror("mirror_x").isChecked());
    mirror("mirror_x").click();
    box("width").setValue(100.0);
    box("move_x").setValue(0.0);
    box("move_y").setValue(0.0);
    box("move_x").setValue(60.0);
    EXPECT_THAT(outcome(), HasSubstr("beyond the canvas"));
    box("move_x").setValue(0.0);
    const tools::TransformFrame mirrored = *frame();
    button(QDialogButtonBox::Ok).click();
    settle();
    EXPECT_EQ(dialog(), nullptr);
    // Mirrored about the middle of the frame, cell by cell.
    const int sum = static_cast<int>(std::lround(4.0 * (2.0 * mirrored.centre_mm().x))) - 1;
    const auto after = painting();
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x <= sum; ++x)
            ASSERT_EQ(after->film.thickness.at(x, y), before->film.thickness.at(sum - x, y));
}

TEST_F(TransformWindow, OnlyWhatIsSelectedMoves) {
    studio().easel().select(document::SelectArea{{{0, 0}, {15, 0}, {15, 40}, {0, 40}}});
    settle();
    const auto before = painting();
    begin();
    EXPECT_LE(handle(1, 0).x, 15.25);
    box("move_y").setValue(20.0);
    key(Qt::Key_Return);
    const auto after = painting();
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 240; ++x) {
            const std::int32_t was = before->film.thickness.at(x, y);
            ASSERT_EQ(after->film.thickness.at(x, y), x < 60 ? 0 : was);
            ASSERT_EQ(after->film.thickness.at(x, y + 80), x < 60 ? was : 0);
        }
    EXPECT_EQ(grid::chosen_area(*after->selection), (grid::Rect{0, 80, 60, 160}));
    give(Command::Undo);
    EXPECT_EQ(hash(), film::state_hash(before->film));
}

TEST_F(TransformWindow, TheFrameLeavesOutWhatIsMasked) {
    studio().easel().select(document::SelectArea{{{0, 0}, {15, 0}, {15, 40}, {0, 40}}});
    settle();
    give(Command::MaskSelection);
    studio().easel().select(document::SelectAll{});
    settle();
    begin();
    EXPECT_GE(handle(-1, 0).x, 14.75);
    give(Command::PeelMasking);
    wait_for([&] { return !frame().has_value(); });
    begin();
    EXPECT_LT(handle(-1, 0).x, 12.0);
}

TEST_F(TransformWindow, TheFrameShowsNoPaintOnWhatIsMasked) {
    const glm::dvec2 shift{20.0, 15.0}, masked{33.0, 26.0}, open{37.0, 27.5};
    studio().easel().select(document::SelectArea{{{25, 0}, {35, 0}, {35, 40}, {25, 40}}});
    settle();
    give(Command::MaskSelection);
    studio().easel().select(document::SelectAll{});
    settle();
    const double masked_before = mean_rgb(masked).r, open_before = mean_rgb(open).r;
    begin();
    drag(middle(), middle() + shift);
    EXPECT_NEAR(mean_rgb(masked).r, masked_before, 3.0) << "it would come off with the mask";
    EXPECT_LT(mean_rgb(open).r, open_before - 40.0);
    key(Qt::Key_Return);
    give(Command::PeelMasking);
    const auto after = painting();
    EXPECT_EQ(after->film.thickness.at(132, 104), 0);
    EXPECT_GT(after->film.thickness.at(148, 110), 0);
}

TEST_F(TransformWindow, NothingIsPaintedWhileTheFrameIsUp) {
    begin();
    const std::size_t events = events_posted();
    const QImage with_pointer_far = picture();
    mouse_stroke(line_mm({40.0, 30.0}, {50.0, 30.0}));
    EXPECT_EQ(events_posted(), events);
    EXPECT_NE(frame()->turn_deg, 0.0);
    key(Qt::Key_Escape);
    EXPECT_GT(difference(with_pointer_far, picture()).largest, 20) << "the frame was seen";
    mouse_stroke(line_mm({40.0, 30.0}, {50.0, 30.0}));
    EXPECT_GT(events_posted(), events);
}

TEST_F(TransformWindow, OtherDeedsEndTheFrameAndLeaveThePaint) {
    const std::uint64_t before = hash();
    const auto drag_frame = [&] {
        begin();
        drag(middle(), middle() + glm::dvec2(9.0, 3.0));
    };
    drag_frame();
    give(Command::Undo);
    EXPECT_FALSE(frame().has_value());
    EXPECT_EQ(hash(), before) << "what is taken back is the frame";
    drag_frame();
    give(Command::AddLayer);
    wait_for([&] { return !frame().has_value(); });
    begin_refused("no paint on this layer");
    give(Command::Undo);
    EXPECT_EQ(hash(), before);
    drag_frame();
    give(Command::SelectRectangle);
    EXPECT_FALSE(frame().has_value());
    key(Qt::Key_Escape);
    drag_frame();
    window().replay({session().canvas(), {{5, document::SelectAll{}}}, 10});
    EXPECT_FALSE(frame().has_value());
    give(Command::Pause);
    wait_for([&] { return !session().status().replaying; });
    give(Command::Pause);
    drag_frame();
    parts().files.new_canvas(canvas_settings());
    loaded();
    EXPECT_FALSE(frame().has_value());
    EXPECT_EQ(dialog(), nullptr);
}

TEST_F(TransformWindow, LockedAndHiddenLayersSayWhy) {
    give(Command::LockLayer);
    begin_refused("locked");
    give(Command::LockLayer);
    give(Command::ShowLayer);
    begin_refused("hidden");
    give(Command::ShowLayer);
    begin();
    give(Command::LockLayer);
    wait_for([&] { return !frame().has_value(); });
}

}  // namespace
}  // namespace pastoso::tests
