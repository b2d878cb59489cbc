#include "tools/easel.hpp"

#include "core/units.hpp"
#include "tools/canvas_resizing.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

using namespace document;
using ::testing::ElementsAre;

/// Names of the posted actions, in their order.
std::vector<std::string> names(const std::vector<Action>& actions) {
    static const char* const kNames[] = {
        "brush",         "load", "clean", "aside",  "swap",        "medium",
        "drying",        "dry",  "tilt",  "size",   "turn canvas", "scale canvas",
        "rotate canvas", "down", "move",  "up",     "turn",        "squeeze",
        "wipe well",     "undo", "redo",  "steady", "guide",       "symmetry"};
    std::vector<std::string> list;
    for (const Action& action : actions)
        list.emplace_back(kNames[action.index()]);
    return list;
}

Pointer at_ms(std::uint64_t time_ms) {
    Pointer pointer;
    pointer.time_ms = time_ms;
    return pointer;
}

class EaselTest : public ::testing::Test {
  protected:
    std::vector<std::string> posted() {
        std::vector<std::string> list = names(actions_);
        actions_.clear();
        return list;
    }

    std::vector<Action> actions_;
    Easel easel_{Hand{}, [this](Action action) { actions_.push_back(std::move(action)); }};
};

TEST_F(EaselTest, SetsUpAPainterWhoHasReadNothing) {
    easel_.set_up();
    EXPECT_THAT(posted(), ElementsAre("medium", "tilt", "drying", "brush", "clean", "load"));
}

TEST_F(EaselTest, EveryStrokeStartsWithAFreshBrushUnlessToldOtherwise) {
    easel_.press({});
    easel_.release();
    EXPECT_THAT(posted(), ElementsAre("clean", "load", "down", "up"));
    easel_.set_reload_each_stroke(false);
    easel_.press({});
    easel_.release();
    EXPECT_THAT(posted(), ElementsAre("down", "up"));
}

TEST_F(EaselTest, TellsThatThePenComesDownBeside) {
    Pointer outside;
    outside.beside = true;
    easel_.press(outside);
    EXPECT_TRUE(std::get<PenDown>(actions_.back()).beside);
    easel_.release();
    easel_.press({});
    EXPECT_FALSE(std::get<PenDown>(actions_.back()).beside);
}

Pointer on_well(double x_mm, double y_mm) {
    Pointer pointer;
    pointer.surface = Surface::Well;
    pointer.x_mm = x_mm;
    pointer.y_mm = y_mm;
    return pointer;
}

TEST_F(EaselTest, WhatWasMixedInTheWellIsNotThrownAway) {
    easel_.press(on_well(20, 20));
    EXPECT_EQ(std::get<PenDown>(actions_.back()).surface, Surface::Well);
    easel_.release();
    EXPECT_THAT(posted(), ElementsAre("down", "up"));
    easel_.press({});
    EXPECT_EQ(std::get<PenDown>(actions_.back()).surface, Surface::Canvas);
    easel_.release();
    EXPECT_THAT(posted(), ElementsAre("down", "up"));
    easel_.clean();
    easel_.press({});
    easel_.release();
    EXPECT_THAT(posted(), ElementsAre("clean", "clean", "load", "down", "up"));
}

TEST_F(EaselTest, TheWellKnowsNoRulerAndNoPointersElsewhere) {
    easel_.lay_guide({.form = brush::Ruler{0, 0, 100, 0}});
    easel_.press(on_well(20, 20), true);
    EXPECT_FALSE(easel_.line_start().has_value());
    easel_.move({});
    easel_.wait(1.0);
    easel_.release();
    EXPECT_THAT(posted(), ElementsAre("down", "up"));
}

TEST_F(EaselTest, KnowsThePaintsOfTheLastWell) {
    const document::PaintRecipe blue{{{"PB29", 1.0}}, 1.0}, white{{{"PW6", 1.0}}, 1.0};
    SqueezedPaints& paints = easel_.squeezed_paints();
    for (const document::PaintRecipe& paint : {blue, white, blue})
        easel_.squeeze_next(paint);
    EXPECT_TRUE(paints.last().empty());
    EXPECT_THAT(paints.latest({}).squeezed, ElementsAre(blue, white));
    paints.begin({});
    EXPECT_THAT(paints.last().squeezed, ElementsAre(blue, white));
    paints.begin({});
    EXPECT_THAT(paints.last().squeezed, ElementsAre(blue, white)) << "beside that painting was none";
    easel_.squeeze_next(white);
    EXPECT_THAT(paints.last().squeezed, ElementsAre(blue, white));
    EXPECT_THAT(paints.latest({}).squeezed, ElementsAre(white));
    easel_.clean_well();
    EXPECT_THAT(paints.latest({}).squeezed, ElementsAre(blue, white)) << "the well is bare";
}

TEST_F(EaselTest, KnowsTheMixturesOfTheLastWell) {
    const document::PaintRecipe tint{{{"PB29", 1.0}, {"PW6", 1.0}}, 1.0};
    const document::Puddle mixed{{{{"PB29", 1.0}, {"PW6", 4.0}}, 1.0}, 80.0, 30.0, 20.0};
    const document::Puddle as_squeezed{{{{"PB29", 50.5}, {"PW6", 49.5}}, 1.0}, 250.0, 60.0, 20.0};
    SqueezedPaints& paints = easel_.squeezed_paints();
    easel_.squeeze_next(tint);
    paints.begin({mixed, as_squeezed});
    EXPECT_EQ(paints.last(), (WellPalette{{tint}, {mixed}}));
    paints.begin({});
    EXPECT_EQ(paints.last(), (WellPalette{{tint}, {mixed}})) << "beside that painting was none";
    EXPECT_EQ(paints.latest({as_squeezed}), (WellPalette{{tint}, {as_squeezed}}));
    easel_.squeeze_puddle(mixed, true);
    EXPECT_EQ(std::get<SqueezePaint>(actions_.back()),
              (SqueezePaint{mixed.paint, 80.0, 30.0, 20.0, true}));
    EXPECT_EQ(paints.latest({}), (WellPalette{{tint}, {mixed}})) << "it is no tube of this well";
}

TEST_F(EaselTest, SqueezesInTwoRowsAlongTheEdges) {
    std::vector<SqueezePaint> squeezes;
    for (int i = 0; i < 11; ++i) {
        easel_.squeeze_next();
        squeezes.push_back(std::get<SqueezePaint>(actions_.back()));
    }
    EXPECT_EQ(squeezes[0].y_mm, squeezes[4].y_mm);
    EXPECT_GT(squeezes[1].x_mm, squeezes[0].x_mm + 15.0);
    EXPECT_GT(squeezes[5].y_mm, squeezes[0].y_mm + 50.0);
    EXPECT_EQ(squeezes[10], squeezes[0]);
    easel_.clean_well();
    easel_.squeeze_next();
    EXPECT_EQ(std::get<SqueezePaint>(actions_.back()), squeezes[0]);
    easel_.squeeze(-5, 500);
    EXPECT_EQ(std::get<SqueezePaint>(actions_.back()).x_mm, 0.0);
    EXPECT_EQ(std::get<SqueezePaint>(actions_.back()).y_mm, 90.0);
}

TEST_F(EaselTest, MovesWithoutAPressAndSecondReleasesPostNothing) {
    easel_.move({});
    easel_.release();
    easel_.release();
    EXPECT_TRUE(actions_.empty());
}

TEST_F(EaselTest, AChangeOfToolEndsTheStrokeFirst) {
    easel_.set_reload_each_stroke(false);
    easel_.press({});
    easel_.choose_paint({{{"PR108", 1.0}}, 1.0});
    easel_.move({});
    EXPECT_THAT(posted(), ElementsAre("down", "up", "clean", "load"));
    easel_.press({});
    easel_.undo();
    EXPECT_THAT(posted(), ElementsAre("down", "up", "undo"));
}

TEST_F(EaselTest, AToolThatIsChangedIsTakenWithTheNextStroke) {
    brush::Preset preset = preset_in_hand(easel_.hand());
    const brush::Preset before = preset;
    preset.tip.width_mm = 31.0;
    preset.paint.film_mm = 0.4;
    easel_.change_brush(preset, preset.tip.width_mm);
    EXPECT_EQ(sized_preset_in_hand(easel_.hand()), preset);
    EXPECT_THAT(posted(), ElementsAre());
    easel_.press({});
    easel_.release();
    const auto taken = std::get<TakeBrush>(actions_.front());
    EXPECT_EQ(taken.size_mm, 31.0);
    EXPECT_EQ(brush::parse_preset(taken.definition, "posted"), preset);
    posted();
    easel_.change_brush(before, before.tip.width_mm);
    easel_.press({});
    easel_.release();
    EXPECT_EQ(std::get<TakeBrush>(actions_.front()).definition, "");
    EXPECT_EQ(std::get<TakeBrush>(actions_.front()).size_mm, 20.0);
}

TEST_F(EaselTest, AnotherMediumComesWithAFreshBrush) {
    easel_.use_medium("ink glaze");
    EXPECT_THAT(posted(), ElementsAre("clean", "medium", "clean", "load"));
    EXPECT_EQ(easel_.hand().medium, UseMedium{"ink glaze"});
}

TEST_F(EaselTest, ThinnerPaintComesWithAFreshBrushAndKeepsItsNumbers) {
    film::Medium own = film::find_medium("house paint");
    own.yield_stress_Pa = 3.0;
    easel_.change_medium(own);
    easel_.press({});
    actions_.clear();
    easel_.set_paint_share(0.3);
    EXPECT_THAT(posted(), ElementsAre("up", "clean", "medium", "clean", "load"));
    EXPECT_EQ(easel_.hand().medium, (UseMedium{"house paint", own, 0.3}));
    own.yield_stress_Pa = 4.0;
    easel_.change_medium(own);
    EXPECT_EQ(easel_.hand().medium, (UseMedium{"house paint", own, 0.3}));
    easel_.use_medium("ink glaze");
    EXPECT_EQ(easel_.hand().medium, UseMedium{"ink glaze"});
}

TEST_F(EaselTest, IsThinnedWithinLimitsAndPouredOnlyWhereThatChangesSomething) {
    easel_.set_paint_share(1.0);
    EXPECT_TRUE(actions_.empty());
    easel_.set_paint_share(0.001);
    EXPECT_EQ(easel_.hand().medium.paint_share, film::kLeastPaintShare);
    easel_.use_medium("thinner");
    actions_.clear();
    easel_.set_paint_share(0.5);
    EXPECT_TRUE(actions_.empty());
    EXPECT_EQ(easel_.hand().medium, UseMedium{"thinner"});
}

TEST_F(EaselTest, AWashGoesBackToWhatWasThickerBefore) {
    easel_.thin_to_wash(true);
    EXPECT_EQ(easel_.hand().medium.paint_share, 0.08);
    easel_.thin_to_wash(false);
    EXPECT_EQ(easel_.hand().medium.paint_share, 1.0);
    easel_.set_paint_share(0.4);
    easel_.thin_to_wash(true);
    easel_.set_paint_share(0.05);
    easel_.thin_to_wash(false);
    EXPECT_EQ(easel_.hand().medium.paint_share, 0.4);
    easel_.thin_to_wash(true);
    easel_.use_medium("ink glaze");
    easel_.thin_to_wash(false);
    EXPECT_EQ(easel_.hand().medium, UseMedium{"ink glaze"});
}

TEST_F(EaselTest, DryingEndsTheStrokeAndItsSpeedDoesNot) {
    easel_.set_reload_each_stroke(false);
    easel_.press({});
    easel_.set_drying_speed(60.0);
    easel_.dry_now();
    EXPECT_THAT(posted(), ElementsAre("down", "drying", "up", "dry"));
    EXPECT_EQ(easel_.hand().air.speed, 60.0);
}

TEST_F(EaselTest, TiltingGoesOnDuringAStroke) {
    easel_.set_reload_each_stroke(false);
    easel_.press({});
    easel_.tilt(30.0, 45.0);
    easel_.move({});
    EXPECT_THAT(posted(), ElementsAre("down", "tilt", "move"));
}

TEST_F(EaselTest, TimeStartsAtTheFirstTouchAndNeverRunsBackwards) {
    easel_.set_reload_each_stroke(false);
    easel_.press(at_ms(5000));
    easel_.move(at_ms(5020));
    easel_.move(at_ms(4000));
    easel_.move(at_ms(5030));
    std::vector<double> times_s;
    for (const Action& action : actions_) {
        if (const auto* down = std::get_if<PenDown>(&action)) times_s.push_back(down->sample.time_s);
        if (const auto* move = std::get_if<PenMove>(&action)) times_s.push_back(move->sample.time_s);
    }
    EXPECT_THAT(times_s, ElementsAre(0.0, 0.020, 0.020, 0.030));
}

TEST_F(EaselTest, WhatAPenReportsOutsideItsRangeIsBroughtBack) {
    easel_.set_reload_each_stroke(false);
    Pointer pointer;
    pointer.pressure = 1.5;
    pointer.tilt_x_deg = -120.0;
    pointer.tilt_y_deg = 95.0;
    easel_.press(pointer);
    const auto& sample = std::get<PenDown>(actions_.back()).sample;
    EXPECT_DOUBLE_EQ(sample.pressure, 1.0);
    EXPECT_DOUBLE_EQ(sample.tilt_x_deg, -90.0);
    EXPECT_DOUBLE_EQ(sample.tilt_y_deg, 90.0);
}

TEST_F(EaselTest, AStraightLineIsAskedForOnceAndTakenBack) {
    easel_.set_reload_each_stroke(false);
    for (const bool straight : {true, true, false}) {
        easel_.press({}, straight);
        EXPECT_EQ(easel_.line_start().has_value(), straight);
        easel_.release();
        EXPECT_FALSE(easel_.line_start().has_value());
    }
    EXPECT_THAT(posted(), ElementsAre("guide", "down", "up", "down", "up", "guide", "down", "up"));
}

TEST_F(EaselTest, ABrushThatTurnsWithTheStrokeStandsAcrossTheGuide) {
    easel_.set_reload_each_stroke(false);
    const auto turns_across = [&](const Pointer& pointer) {
        easel_.release();
        actions_.clear();
        easel_.press(pointer, true);
        return std::get<SetGuide>(actions_.front()).guide.turn_across;
    };
    EXPECT_TRUE(turns_across({}));
    Pointer barrel;
    barrel.rotation_deg = 20.0;
    EXPECT_FALSE(turns_across(barrel));
}

TEST_F(EaselTest, TheRulerLiesAlongTheLatestStroke) {
    easel_.set_reload_each_stroke(false);
    const brush::Ruler middle{0.0, 20.0, 60.0, 20.0};
    easel_.lay_guide({.form = easel_.ruler_along_stroke(middle)});
    EXPECT_EQ(easel_.hand().ruler(), middle);
    Pointer pointer;
    pointer.x_mm = 5.0;
    easel_.press(pointer);
    pointer.x_mm = 25.0;
    pointer.y_mm = 30.0;
    easel_.move(pointer);
    easel_.release();
    EXPECT_THAT(posted(), ElementsAre("guide", "down", "move", "up"));
    easel_.lay_guide({.form = easel_.ruler_along_stroke(middle)});
    EXPECT_EQ(easel_.hand().ruler(), (brush::Ruler{5.0, 0.0, 25.0, 30.0}));
    easel_.take_guide_away();
    easel_.press(pointer);
    EXPECT_THAT(posted(), ElementsAre("guide", "down"));
    EXPECT_EQ(easel_.hand().guide, brush::PenGuide{});
}

TEST_F(EaselTest, AGuideThatDoesNotSnapStillLies) {
    easel_.set_reload_each_stroke(false);
    const brush::PenGuide shown{.form = brush::VanishingPoints{}, .strength = 0.0};
    easel_.lay_guide(shown);
    easel_.press({});
    easel_.release();
    const document::Action first = actions_.front();
    EXPECT_THAT(posted(), ElementsAre("guide", "down", "up"));
    EXPECT_EQ(std::get<SetGuide>(first).guide, shown) << "the brush does not turn across it";
    EXPECT_EQ(hand_after({}, {{0, first}}).laid, shown);
}

TEST_F(EaselTest, WhatIsTakenAwayIsNotThereWhenThePaintingIsOpenedAgain) {
    easel_.set_reload_each_stroke(false);
    easel_.lay_guide({.form = brush::Ruler{0.0, 20.0, 60.0, 20.0}});
    easel_.press({});
    easel_.release();
    easel_.take_guide_away();
    std::vector<document::Event> painted;
    for (const Action& action : actions_)
        painted.push_back({0, action});
    EXPECT_THAT(posted(), ElementsAre("guide", "down", "up", "guide"));
    EXPECT_EQ(hand_after({}, painted).ruler(), std::nullopt);
    easel_.take_guide_away();
    EXPECT_THAT(posted(), ElementsAre()) << "there is nothing to take away";
}

TEST_F(EaselTest, ARestIsToldAsARest) {
    easel_.set_reload_each_stroke(false);
    easel_.set_turn_with_stroke(false);
    easel_.press(at_ms(1000));
    Pointer pointer = at_ms(1010);
    pointer.x_mm = 7.0;
    easel_.move(pointer);
    pointer = at_ms(61000);
    pointer.x_mm = 9.0;
    easel_.move(pointer);
    EXPECT_THAT(names(actions_), ElementsAre("down", "move", "move", "move"));
    const auto& rest = std::get<PenMove>(actions_[2]).sample;
    EXPECT_DOUBLE_EQ(rest.time_s, 59.992);
    EXPECT_EQ(rest.x_mm, 7.0);
}

TEST_F(EaselTest, ASteadiedBrushCatchesUpWithAPenThatRests) {
    easel_.set_reload_each_stroke(false);
    easel_.press(at_ms(1000));
    easel_.wait(0.025);
    EXPECT_THAT(posted(), ElementsAre("down"));
    easel_.set_stabiliser({20.0, 0.0});
    for (int i = 0; i < 100; ++i)
        easel_.wait(0.025);
    EXPECT_THAT(posted(), ElementsAre("steady", "move", "move", "move", "move"));
    easel_.move(at_ms(1050));  // the clocks differ
    easel_.wait(0.025);
    EXPECT_DOUBLE_EQ(std::get<PenMove>(actions_[0]).sample.time_s, 0.1);
    EXPECT_DOUBLE_EQ(std::get<PenMove>(actions_[1]).sample.time_s, 0.125);
    easel_.release();
    easel_.wait(0.025);
    EXPECT_THAT(posted(), ElementsAre("move", "move", "up"));
}

TEST_F(EaselTest, AnotherCanvasIsToldOfTheStabiliser) {
    easel_.set_stabiliser({100.0, 2.0});
    EXPECT_THAT(posted(), ElementsAre("steady"));
    easel_.set_up();
    EXPECT_THAT(posted(), ElementsAre("medium", "tilt", "drying", "steady", "brush", "clean", "load"));
}

TEST_F(EaselTest, ABrushWithoutSensorStandsAcrossItsPath) {
    easel_.set_reload_each_stroke(false);
    const auto move_to = [&](double x_mm, double y_mm) {
        Pointer pointer;
        pointer.x_mm = x_mm;
        pointer.y_mm = y_mm;
        easel_.move(pointer);
    };
    for (int i = 0; i <= 60; ++i)
        move_to(i, 0.0);
    // The memory of the first direction has faded to exp(-60/9) of a right angle.
    EXPECT_NEAR(std::abs(easel_.held().rotation_deg), 90.0, 0.2);
    const double there_deg = easel_.held().rotation_deg;
    for (int i = 60; i >= 0; --i)
        move_to(i, 0.0);
    EXPECT_NEAR(easel_.held().rotation_deg, there_deg, 0.2);
    EXPECT_TRUE(actions_.empty());
}

Pointer at_mm(double x_mm, double y_mm) {
    Pointer pointer;
    pointer.x_mm = x_mm;
    pointer.y_mm = y_mm;
    return pointer;
}

TEST_F(EaselTest, AFlatStartsAcrossItsPath) {
    easel_.set_reload_each_stroke(false);
    easel_.press(at_mm(10.0, 10.0));
    easel_.move(at_mm(11.0, 11.0));
    posted();
    easel_.move(at_mm(12.0, 12.0));
    ASSERT_EQ(actions_.size(), 2U);
    EXPECT_NEAR(std::remainder(std::get<TurnStroke>(actions_[0]).rotation_deg + 45.0, 180.0), 0.0, 1e-9);
    EXPECT_NEAR(std::remainder(std::get<PenMove>(actions_[1]).sample.rotation_deg + 45.0, 180.0), 0.0,
                1e-9);
    posted();
    easel_.move(at_mm(12.0, 20.0));
    EXPECT_THAT(posted(), ElementsAre("move"));
}

TEST_F(EaselTest, AStrokeThatStartedRightIsNotTurned) {
    easel_.set_reload_each_stroke(false);
    for (int i = 0; i <= 60; ++i)
        easel_.move(at_mm(i, 10.0));
    easel_.press(at_mm(60.0, 10.0));
    easel_.move(at_mm(63.0, 10.0));
    EXPECT_THAT(posted(), ElementsAre("down", "move"));
}

TEST_F(EaselTest, AMouseHoldsTheToolAslantWhenAskedTo) {
    const auto tilt_deg = [this](const Pointer& pointer) {
        easel_.press(pointer);
        easel_.release();
        return easel_.held().tilt_x_deg;
    };
    EXPECT_EQ(tilt_deg(at_mm(10.0, 10.0)), 0.0);
    easel_.set_tilted(true);
    EXPECT_EQ(tilt_deg(at_mm(10.0, 10.0)), 40.0);
    Pointer pen = at_mm(10.0, 10.0);
    pen.tells_tilt = true;
    pen.tilt_x_deg = 12.0;
    EXPECT_EQ(tilt_deg(pen), 12.0);
}

TEST_F(EaselTest, ADabStaysADab) {
    easel_.set_reload_each_stroke(false);
    easel_.press(at_mm(10.0, 10.0));
    easel_.move(at_mm(11.0, 11.0));
    easel_.release();
    EXPECT_THAT(posted(), ElementsAre("down", "move", "up"));
    easel_.move(at_mm(20.0, 12.0));
    EXPECT_TRUE(actions_.empty());
}

TEST_F(EaselTest, OnlyATipThatStandsAskewIsTurned) {
    easel_.set_reload_each_stroke(false);
    easel_.take_brush("Round bristle 12", 12.0);
    posted();
    easel_.press(at_mm(10.0, 10.0));
    easel_.move(at_mm(20.0, 20.0));
    EXPECT_THAT(posted(), ElementsAre("down", "move"));
    easel_.release();
    easel_.take_brush("Flat bristle 20", 20.0);
    posted();
    Pointer told = at_mm(10.0, 10.0);
    told.rotation_deg = 0.0;
    easel_.press(told);
    told.x_mm = told.y_mm = 20.0;
    easel_.move(told);
    EXPECT_THAT(posted(), ElementsAre("down", "move"));
}

TEST_F(EaselTest, APenThatTellsItsRotationIsBelieved) {
    easel_.set_reload_each_stroke(false);
    Pointer pointer;
    pointer.rotation_deg = 30.0;
    easel_.press(pointer);
    EXPECT_DOUBLE_EQ(std::get<PenDown>(actions_.back()).sample.rotation_deg, 30.0);
}

TEST(Heading, TurnsOnWithoutJumpsAroundACircle) {
    Heading heading;
    double previous_deg = 0.0;
    for (int i = 0; i <= 720; ++i) {
        const double angle = core::radians(i);
        heading.moved_to(40.0 * std::cos(angle), 40.0 * std::sin(angle));
        const double turn_deg = std::remainder(heading.rotation_deg() - previous_deg, 360.0);
        // A degree of arc turns the brush by about a degree; the start may turn faster from rest.
        if (i > 90) {
            EXPECT_LT(std::abs(turn_deg), 2.0) << "at " << i;
        }
        previous_deg = heading.rotation_deg();
    }
}

TEST(HandAfter, HoldsWhatTheLastEventsGave) {
    LoadPaint dip;
    dip.paint.ingredients = {{"PY35", 2.0}, {"PW6", 1.0}};
    const Hand hand = hand_after(Hand{}, {{0, TakeBrush{"Round sable 9", 5.0, 1}},
                                          {0, TakeBrush{"Filbert 14", 0.0, 2}},
                                          {3, dip},
                                          {4, UseMedium{"ink glaze"}},
                                          {5, TiltCanvas{12.0, 45.0}},
                                          {9, PenUp{}}});
    EXPECT_EQ(hand.brush, "Filbert 14");
    EXPECT_DOUBLE_EQ(hand.brush_width_mm, 14.0);
    EXPECT_EQ(hand.paint, dip.paint);
    EXPECT_EQ(hand.medium, UseMedium{"ink glaze"});
    EXPECT_EQ(hand.tilt, (TiltCanvas{12.0, 45.0}));
    EXPECT_EQ(hand_after(hand, {}).brush, hand.brush);
    const brush::Ruler ruler{1.0, 2.0, 3.0, 4.0};
    const Hand aided = hand_after(hand, {{0, SetStabiliser{{50.0, 1.0}}},
                                         {0, SetSymmetry{{.mirror = true, .count = 3}}},
                                         {0, SetGuide{{.form = ruler}}},
                                         {1, SetGuide{{.form = brush::StraightLine{}}}}});
    EXPECT_EQ(aided.stabiliser, (brush::Stabiliser{50.0, 1.0}));
    EXPECT_EQ(aided.symmetry.count, 3);
    EXPECT_EQ(aided.ruler(), ruler);
    EXPECT_EQ(hand_after(aided, {{2, SetGuide{}}}).ruler(), std::nullopt);
    const brush::PenGuide grid{
        .form = brush::Grid{}, .reach_mm = 2.0, .turn_across = true, .strength = 0.5};
    const Hand gridded = hand_after(aided, {{3, SetGuide{grid}}});
    EXPECT_EQ(gridded.guide, grid);
    EXPECT_EQ(gridded.laid, (brush::PenGuide{.form = brush::Grid{}, .reach_mm = 2.0, .strength = 0.5}));
}

TEST(BrushWidth, StepsClimbDownAgainWithinTheLimits) {
    double width_mm = 20.0;
    for (int i = 0; i < 100; ++i) {
        const double wider = stepped_brush_width_mm(width_mm, 1);
        EXPECT_TRUE(wider > width_mm || width_mm == kLargestBrush_mm);
        width_mm = wider;
    }
    EXPECT_DOUBLE_EQ(width_mm, kLargestBrush_mm);
    EXPECT_DOUBLE_EQ(stepped_brush_width_mm(width_mm, -1000), kSmallestBrush_mm);
}

TEST_F(EaselTest, WhatLiesOnTheCanvasFollowsIt) {
    easel_.move_along({{}, {10.0, -5.0}});
    EXPECT_THAT(posted(), ElementsAre()) << "nothing lies there";
    easel_.set_symmetry({.centre_x_mm = 30.0, .centre_y_mm = 20.0, .mirror = true});
    easel_.lay_guide({.form = brush::Ruler{1.0, 2.0, 30.0, 2.0}});
    easel_.press({});
    easel_.release();
    posted();
    easel_.move_along({{}, {10.0, -5.0}});
    EXPECT_EQ(std::get<SetSymmetry>(actions_.front()).symmetry.centre_x_mm, 40.0);
    EXPECT_EQ(std::get<brush::Ruler>(std::get<SetGuide>(actions_.back()).guide.form),
              (brush::Ruler{11.0, -3.0, 40.0, -3.0}));
    EXPECT_THAT(posted(), ElementsAre("symmetry", "guide"));
    easel_.press({});
    easel_.release();
    EXPECT_THAT(posted(), ElementsAre("clean", "load", "down", "up")) << "the guide is known";
}

}  // namespace
}  // namespace pastoso::tools
