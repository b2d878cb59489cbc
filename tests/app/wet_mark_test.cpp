// The part of a stroke that is ahead of the screen, and the mark that stands for it.
#include "interactions/wet_mark.hpp"

#include "brush/preset.hpp"
#include "document/actions/actions.hpp"
#include "document/painting.hpp"
#include "interactions/stroke_ahead.hpp"
#include "screen/raster_overlay.hpp"

#include <cmath>

#include <QImage>
#include <QPainter>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::interactions {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

const brush::Preset& flat() {
    return brush::find_preset("Flat bristle 20");
}

brush::HandPath path_of(const brush::Preset& tool, const brush::HandAids& aids = {}) {
    return {tool, brush::make_tip(tool, 1), aids};
}

/// Along a wave, 5 ms apart.
brush::PenSample sample(int i) {
    return {.time_s = 0.005 * i,
            .x_mm = 10.0 + 0.6 * i,
            .y_mm = 30.0 + 4.0 * std::sin(0.1 * i),
            .pressure = 0.5};
}

StrokeAhead stroke_of(int samples, std::uint64_t first_number = 1) {
    StrokeAhead ahead;
    ahead.begin(path_of(flat()), sample(0), first_number);
    for (int i = 1; i < samples; ++i)
        ahead.add(sample(i), first_number + static_cast<std::uint64_t>(i));
    return ahead;
}

std::vector<brush::PathStep> painted_steps(int samples) {
    brush::HandPath path = path_of(flat());
    path.begin(sample(0));
    for (int i = 1; i < samples; ++i)
        path.add(sample(i));
    return path.take_steps();
}

TEST(StrokeAhead, WhatIsNotForetoldIsTheBrushsOwnWay) {
    const StrokeAhead ahead = stroke_of(30);
    const std::vector<brush::PathStep> steps = painted_steps(30);
    const std::vector<brush::PenSample> places = ahead.places();
    ASSERT_GT(places.size(), steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
        EXPECT_EQ(places[i], steps[i].pen);
}

TEST(StrokeAhead, ItStartsWhereTheScreensPaintEnds) {
    StrokeAhead ahead = stroke_of(30, 101);
    EXPECT_FALSE(ahead.is_down());
    ahead.shown(100);
    EXPECT_FALSE(ahead.is_down());
    ahead.shown(120);
    EXPECT_TRUE(ahead.is_down());
    EXPECT_EQ(ahead.places().front(), painted_steps(20).back().pen);
    ahead.shown(130);
    EXPECT_EQ(ahead.places().front(), painted_steps(30).back().pen);
}

TEST(StrokeAhead, WhereTheHandRestsTheBrushComesToIt) {
    StrokeAhead ahead = stroke_of(30);
    ahead.shown(30);
    EXPECT_TRUE(ahead.rest());
    EXPECT_FALSE(ahead.rest());
    const brush::PenSample last = ahead.places().back();
    const double step_mm = path_of(flat()).step_mm();
    EXPECT_NEAR(std::hypot(last.x_mm - sample(29).x_mm, last.y_mm - sample(29).y_mm), 0.0, step_mm);
    ahead.add(sample(30), 31);
    EXPECT_TRUE(ahead.rest());
}

// The tip hangs on its string, and does not come nearer.
TEST(StrokeAhead, ABrushOnAStringRestsWithTheHand) {
    StrokeAhead ahead;
    ahead.begin(path_of(flat(), {.stabiliser = {.string_mm = 6.0}, .guide = {}}), sample(0), 1);
    for (int i = 1; i < 30; ++i)
        ahead.add(sample(i), static_cast<std::uint64_t>(i) + 1);
    ahead.rest();
    const brush::PenSample last = ahead.places().back();
    EXPECT_NEAR(std::hypot(last.x_mm - sample(29).x_mm, last.y_mm - sample(29).y_mm), 6.0, 0.2);
}

// A mouse's events: the brush follows 10 ms and an event late, so that it gets past the newest one.
TEST(StrokeAhead, AMovingHandIsMetWhereItIsAboutToBe) {
    StrokeAhead ahead = stroke_of(30);
    ahead.shown(30);
    const std::vector<brush::PenSample> places = ahead.places();
    ASSERT_THAT(places, ::testing::Not(IsEmpty()));
    EXPECT_EQ(places.front(), painted_steps(30).back().pen);
    EXPECT_GT(places.back().x_mm, sample(29).x_mm);
    // No farther than a hand of that speed comes in two hundredths of a second.
    EXPECT_LT(places.back().x_mm, sample(29).x_mm + 0.02 * 120.0);
}

TEST(StrokeAhead, TheEndOfAStrokeIsForetoldNoMore) {
    StrokeAhead ahead = stroke_of(30);
    ahead.end(31);
    ahead.shown(30);
    const double step_mm = path_of(flat()).step_mm();
    const brush::PenSample last = ahead.places().back();
    EXPECT_NEAR(last.x_mm, sample(29).x_mm, step_mm);
    EXPECT_LE(last.x_mm, sample(29).x_mm);
    ahead.add(sample(40), 32);
    EXPECT_EQ(ahead.places().back(), last);
    ahead.shown(31);
    EXPECT_THAT(ahead.places(), IsEmpty());
}

TEST(StrokeAhead, AStrokeThatIsTurnedIsTheOneThatBeganSo) {
    const auto turned = [](int i) {
        brush::PenSample with = sample(i);
        with.rotation_deg = 70.0;
        return with;
    };
    StrokeAhead ahead = stroke_of(4), other;
    ahead.shown(2);
    ahead.turn(70.0);
    other.begin(path_of(flat()), turned(0), 1);
    for (int i = 1; i < 10; ++i) {
        if (i >= 4) ahead.add(turned(i), static_cast<std::uint64_t>(i) + 1);
        other.add(turned(i), static_cast<std::uint64_t>(i) + 1);
    }
    other.shown(2);
    EXPECT_EQ(ahead.places(), other.places());
}

class WetMarkTest : public ::testing::Test {
  protected:
    WetMarkTest() {
        picture_.fill(Qt::white);
        mark_.set_paint({.held = tools::WetColour{{200, 0, 0}, 1.0}});
        hand_.stabiliser = {};
        outline_.set_tool(flat());
    }

    void note(const document::Action& action) { mark_.note(action, ++number_, hand_, outline_); }
    void stroke(int samples, document::Surface surface = document::Surface::Canvas) {
        note(document::PenDown{sample(0), surface});
        for (int i = 1; i < samples; ++i)
            note(document::PenMove{sample(i)});
    }
    void draw() {
        QPainter painter(&picture_);
        screen::RasterOverlay overlay(painter, 1.0);
        // 4 px/mm.
        const screen::OverlayFrame frame{{0.0, 0.0}, glm::dmat2(4.0), picture_.size()};
        mark_.draw(shown_, {overlay, frame, 0.25}, outline_);
    }
    QColor seen_at(double x_mm, double y_mm) const {
        return picture_.pixelColor(static_cast<int>(4.0 * x_mm), static_cast<int>(4.0 * y_mm));
    }
    bool is_bare() const {
        QImage white(picture_);
        white.fill(Qt::white);
        return picture_ == white;
    }

    QImage picture_{400, 240, QImage::Format_RGB32};
    WetMark mark_;
    tools::Hand hand_;
    BrushOutline outline_;
    document::Snapshot shown_;
    std::uint64_t number_ = 0;
};

TEST_F(WetMarkTest, PaintLiesUnderThePenAtOnce) {
    stroke(30);
    draw();
    for (const int i : {5, 15, 25, 29}) {
        const QColor seen = seen_at(sample(i).x_mm, sample(i).y_mm);
        EXPECT_GT(seen.red(), 180) << i;
        EXPECT_LT(seen.green(), 60) << i;
        EXPECT_EQ(seen.green(), seen_at(sample(5).x_mm, sample(5).y_mm).green())
            << "darker where marks meet";
    }
    EXPECT_EQ(seen_at(60.0, 50.0), QColor(Qt::white));
}

TEST_F(WetMarkTest, ItGoesWhenThePaintIsThere) {
    stroke(30);
    note(document::PenUp{});
    shown_.posted_actions = number_;
    draw();
    EXPECT_TRUE(is_bare());
}

TEST_F(WetMarkTest, ThinPaintShowsWhatItCovers) {
    mark_.set_paint({.held = tools::WetColour{{200, 0, 0}, 0.25}});
    stroke(10);
    draw();
    const QColor seen = seen_at(sample(5).x_mm, sample(5).y_mm);
    EXPECT_GT(seen.green(), 180);
    EXPECT_LT(seen.green(), 240);
}

TEST_F(WetMarkTest, ABrushThatIsDippedAtEveryTouchHasThatPaintFirst) {
    mark_.set_paint(
        {.held = tools::WetColour{{200, 0, 0}, 1.0}, .dipped = tools::WetColour{{0, 0, 200}, 1.0}});
    stroke(30);
    draw();
    EXPECT_LT(seen_at(sample(20).x_mm, sample(20).y_mm).red(), 60);
    picture_.fill(Qt::white);
    shown_.posted_actions = 2;
    draw();
    EXPECT_LT(seen_at(sample(20).x_mm, sample(20).y_mm).blue(), 60);
}

TEST_F(WetMarkTest, NothingIsMarkedThatIsNotPaintedThere) {
    mark_.set_paint({});
    stroke(30);
    draw();
    EXPECT_TRUE(is_bare()) << "an empty brush";

    mark_.set_paint({.held = tools::WetColour{{200, 0, 0}, 1.0}});
    stroke(30, document::Surface::Well);
    draw();
    EXPECT_TRUE(is_bare()) << "the well";

    hand_.guide.form = brush::StraightLine{};
    stroke(30);
    draw();
    EXPECT_TRUE(is_bare()) << "a line, painted at its end";
    hand_.guide = {};

    outline_.set_tool(brush::find_preset("Spray can 35"));
    stroke(30);
    draw();
    EXPECT_TRUE(is_bare()) << "drops";
    outline_.set_tool(flat());

    stroke(30);
    shown_.selection = std::make_shared<const grid::Mask>(grid::Shape{400, 240});
    draw();
    EXPECT_TRUE(is_bare()) << "a selection that may leave it out";
    shown_.selection = nullptr;
    shown_.masking.cells = std::make_shared<const grid::Mask>(grid::Shape{400, 240});
    draw();
    EXPECT_TRUE(is_bare()) << "masking that may keep it off";
    shown_.masking = {};
    document::LayerStack locked = document::single_layer();
    locked.layers[0].look.bare_locked = true;
    shown_.layers = std::make_shared<const document::LayerStack>(locked);
    draw();
    EXPECT_TRUE(is_bare()) << "what is bare stays so";

    locked.layers[0].look.bare_locked = false;
    locked.layers.push_back({.id = 2, .look = {.clipped = true}});
    locked.active = 1;
    shown_.layers = std::make_shared<const document::LayerStack>(locked);
    draw();
    EXPECT_TRUE(is_bare()) << "a clipped layer, of which it may be hidden";

    document::LayerStack stack = document::single_layer();
    stack.layers.push_back({.id = 1});
    shown_.layers = std::make_shared<const document::LayerStack>(stack);
    draw();
    EXPECT_TRUE(is_bare()) << "below another layer";

    mark_.clear();
    shown_.layers = nullptr;
    draw();
    EXPECT_TRUE(is_bare()) << "another painting";
}

TEST_F(WetMarkTest, SymmetryMarksAllCopies) {
    hand_.symmetry = {.centre_x_mm = 50.0, .centre_y_mm = 30.0, .mirror = true};
    stroke(30);
    draw();
    const QColor here = seen_at(sample(15).x_mm, sample(15).y_mm);
    EXPECT_LT(here.green(), 60);
    EXPECT_EQ(seen_at(100.0 - sample(15).x_mm, sample(15).y_mm), here);
}

TEST_F(WetMarkTest, ARulerLeadsTheMarkToo) {
    hand_.guide.form = brush::Ruler{0.0, 30.0, 100.0, 30.0};
    outline_.set_tool(brush::resized(flat(), 2.0));
    stroke(60);
    draw();
    // The hand is 4 mm above it here.
    EXPECT_EQ(seen_at(sample(16).x_mm, sample(16).y_mm), QColor(Qt::white));
    EXPECT_LT(seen_at(sample(16).x_mm, 30.0).green(), 60);
}

TEST_F(WetMarkTest, APerspectiveLeadsTheMarkOnceItsDirectionIsKnown) {
    hand_.guide.form = brush::VanishingPoints{.count = 1, .x1_mm = 400.0, .y1_mm = sample(0).y_mm};
    outline_.set_tool(brush::resized(flat(), 2.0));
    stroke(1);
    draw();
    EXPECT_TRUE(is_bare()) << "it is not yet";
    stroke(60);
    draw();
    EXPECT_FALSE(is_bare());
}

}  // namespace
}  // namespace pastoso::interactions
