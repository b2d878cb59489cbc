// Symmetry, guides and the stabiliser on a painting: account, undo, replay.
#include "document/actions/actions.hpp"
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/player.hpp"
#include "document/recorder.hpp"
#include "document/scenes.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

constexpr double kRounding = 1e-9;

brush::Symmetry star(int count, bool mirror) {
    return {.centre_x_mm = 20.0, .centre_y_mm = 15.0, .mirror = mirror, .count = count};
}

class HandAids : public testing::Test {
  protected:
    core::ThreadPool pool{1};
    Painting painting{small_canvas(), pool};

    void SetUp() override {
        painting.apply(TakeBrush{"flat", 6, 1});
        painting.apply(load_of("PB29"));
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
    bool wet_at(double x_mm, double y_mm) const {
        return painting.film().thickness.at(static_cast<int>(3.0 * x_mm),
                                            static_cast<int>(3.0 * y_mm)) != 0;
    }
};

TEST_F(HandAids, SymmetryKeepsTheAccount) {
    const double in_hand_mm3 = painting.account().brush.volume_mm3;
    painting.apply(SetSymmetry{star(3, true)});
    expect_balance();
    painting.apply(PenDown{wave_sample(0.0, 10.0, 0)});
    EXPECT_NEAR(painting.account().taken.volume_mm3, 6.0 * in_hand_mm3, kRounding * in_hand_mm3);
    for (int i = 1; i <= 30; ++i) {
        painting.apply(PenMove{wave_sample(0.0, 10.0, i)});
        painting.advance_tick();
        expect_balance();
    }
    painting.apply(PenUp{});
    expect_balance();
    const Account after = painting.account();
    EXPECT_LT(after.brush.volume_mm3, in_hand_mm3);
    EXPECT_GT(after.ledger.volume_mm3, 0.0);
}

TEST_F(HandAids, UndoTakesAllCopiesBack) {
    const Account before = painting.account();
    const std::uint64_t hash = painting.state_hash();
    painting.apply(SetSymmetry{star(4, true)});
    paint_wave(painting, 0.0, 10.0);
    const std::uint64_t after = painting.state_hash();
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), hash);
    EXPECT_EQ(painting.account().taken.volume_mm3, before.taken.volume_mm3);
    EXPECT_EQ(painting.account().brush.volume_mm3, before.brush.volume_mm3);
    EXPECT_EQ(painting.account().ledger.volume_mm3, before.ledger.volume_mm3);
    expect_balance();
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), after);
    expect_balance();
}

TEST_F(HandAids, UndoInTheMiddleOfASymmetricStroke) {
    const std::uint64_t hash = painting.state_hash();
    painting.apply(SetSymmetry{star(2, false)});
    painting.apply(PenDown{wave_sample(0.0, 10.0, 0)});
    for (int i = 1; i <= 15; ++i)
        painting.apply(PenMove{wave_sample(0.0, 10.0, i)});
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), hash);
    expect_balance();
    painting.apply(TakeBrush{"round", 0, 1});
    expect_balance();
}

TEST_F(HandAids, ManyStrokesUnderSymmetryCanBeUndone) {
    painting.apply(SetSymmetry{star(1, true)});
    const std::uint64_t hash = painting.state_hash();
    for (int i = 0; i < 10; ++i)
        paint_wave(painting, i, 5.0 + 0.9 * i);
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(painting.can_undo());
        painting.apply(Undo{});
    }
    EXPECT_EQ(painting.state_hash(), hash);
}

TEST_F(HandAids, AidsHoldFromTheNextStrokeOn) {
    painting.apply(PenDown{wave_sample(0.0, 8.0, 0)});
    painting.apply(SetSymmetry{star(2, false)});
    for (int i = 1; i <= 30; ++i)
        painting.apply(PenMove{wave_sample(0.0, 8.0, i)});
    EXPECT_TRUE(painting.stroke_in_progress());
    painting.apply(PenUp{});
    EXPECT_TRUE(wet_at(20.0, 8.0));
    EXPECT_FALSE(wet_at(20.0, 22.0));
    paint_wave(painting, 1.0, 8.0);
    EXPECT_TRUE(wet_at(20.0, 22.0));
}

TEST_F(HandAids, ALineIsPaintedWhenThePenLiftsHoweverItWandered) {
    painting.apply(SetGuide{{.form = brush::StraightLine{}}});
    painting.apply(PenDown{{0.0, 5.0, 15.0, 0.5}});
    for (int i = 1; i <= 30; ++i)
        painting.apply(PenMove{wave_sample(0.0, i < 30 ? 5.0 : 15.0 - 2.0 * std::sin(12.0), i)});
    EXPECT_EQ(painting.account().canvas.volume_mm3, 0.0);
    EXPECT_TRUE(painting.stroke_in_progress());
    painting.apply(PenUp{});
    EXPECT_TRUE(wet_at(20.0, 15.0));
    EXPECT_FALSE(wet_at(20.0, 5.0));
    expect_balance();
}

TEST_F(HandAids, ALineThatSomethingElseEndsIsPaintedToo) {
    painting.apply(SetGuide{{.form = brush::StraightLine{}}});
    painting.apply(PenDown{{0.0, 5.0, 15.0, 0.5}});
    painting.apply(PenMove{{0.5, 35.0, 15.0, 0.5}});
    painting.apply(CleanBrush{});
    EXPECT_TRUE(wet_at(20.0, 15.0));
    expect_balance();
}

TEST_F(HandAids, UnderAPerspectiveNothingIsPaintedBeforeItsDirectionIsKnown) {
    const std::uint64_t hash = painting.state_hash();
    painting.apply(
        SetGuide{{.form = brush::VanishingPoints{.count = 1, .x1_mm = 300.0, .y1_mm = 15.0}}});
    painting.apply(PenDown{{0.0, 5.0, 15.0, 0.5}});
    painting.apply(PenMove{{0.01, 6.5, 15.5, 0.5}});
    EXPECT_EQ(painting.account().canvas.volume_mm3, 0.0);
    painting.apply(PenMove{{0.5, 35.0, 25.0, 0.5}});
    painting.apply(PenUp{});
    EXPECT_TRUE(wet_at(20.0, 15.0));
    EXPECT_FALSE(wet_at(20.0, 21.0));
    expect_balance();
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), hash);
}

TEST_F(HandAids, AGuideWithoutStrengthPaintsTheSameBits) {
    Painting free(small_canvas(), pool);
    free.apply(TakeBrush{"flat", 6, 1});
    free.apply(load_of("PB29"));
    painting.apply(SetGuide{{.form = brush::Grid{}, .strength = 0.0}});
    for (Painting* each : {&painting, &free}) {
        paint_wave(*each, 0.0, 10.0);
        each->apply(SetGuide{});
    }
    EXPECT_EQ(painting.state_hash(), free.state_hash());
}

TEST_F(HandAids, StrokesAreNeverJoined) {
    painting.apply(SetStabiliser{{400.0, 6.0}});
    painting.apply(SetSymmetry{star(1, true)});
    for (const double y_mm : {5.0, 25.0}) {
        const double start_s = y_mm;
        painting.apply(PenDown{{start_s, 5.0, y_mm, 0.5}});
        for (int i = 1; i <= 20; ++i)
            painting.apply(PenMove{{start_s + 0.01 * i, 5.0 + 0.4 * i, y_mm, 0.5}});
        painting.apply(PenUp{});
    }
    for (int y = 13; y <= 17; ++y) {
        for (int x = 0; x < 40; ++x)
            EXPECT_FALSE(wet_at(x, y));
    }
    EXPECT_TRUE(wet_at(12.0, 25.0));
    EXPECT_TRUE(wet_at(28.0, 25.0));
}

TEST_F(HandAids, PaintTimeThatStandsStillLeavesTheStrokeAlone) {
    // The clock on the wall runs on while paint time is paused: the samples' stamps have a gap.
    Painting paused(small_canvas(), pool);
    paused.apply(TakeBrush{"flat", 6, 1});
    paused.apply(load_of("PB29"));
    for (Painting* each : {&painting, &paused}) {
        each->apply(PenDown{wave_sample(0.0, 10.0, 0)});
        for (int i = 1; i <= 30; ++i) {
            brush::PenSample sample = wave_sample(0.0, 10.0, i);
            if (each == &paused && i > 15) sample.time_s += 120.0;
            each->apply(PenMove{sample});
        }
        each->apply(PenUp{});
    }
    const double plain_mm3 = painting.account().canvas.volume_mm3;
    EXPECT_NEAR(paused.account().canvas.volume_mm3 / plain_mm3, 1.0, 2e-3);  // one event of lag less
}

Recording aided_session(std::uint64_t& hash) {
    core::ThreadPool pool(1);
    Painting painting(small_canvas(), pool);
    Recorder recorder(painting.settings());
    const auto act = [&](const Action& action) {
        painting.apply(action);
        recorder.add(painting.tick(), action);
    };
    act(UseMedium{"soft-body acrylic"});
    act(TakeBrush{"flat", 6, 3});
    act(load_of("PR254"));
    act(SetStabiliser{{30.0, 1.0}});
    act(SetSymmetry{star(3, true)});
    const brush::PenGuide guides[] = {
        {},
        {.form = brush::StraightLine{}, .turn_across = true},
        {.form = brush::Ruler{0.0, 12.0, 40.0, 14.0}},
        {.form = brush::EllipseCurve{20.0, 15.0, 15.0, 8.0, 10.0}, .turn_across = true},
        {.form = brush::VanishingPoints{.count = 2, .x1_mm = -30.0, .x2_mm = 90.0}, .strength = 0.7},
        {.form = brush::Grid{.x_mm = 1.0, .y_mm = 2.0, .direction_deg = 30.0}, .turn_across = true}};
    double start_s = 0.0;
    for (const brush::PenGuide& guide : guides) {
        act(SetGuide{guide});
        act(PenDown{wave_sample(start_s, 11.0, 0)});
        for (int i = 1; i <= 30; ++i) {
            act(PenMove{wave_sample(start_s, 11.0, i)});
            if (i % 7 == 3) painting.advance_tick();
        }
        act(PenUp{});
        start_s += 1.0;
    }
    painting.advance_tick();
    hash = painting.state_hash();
    recorder.note_tick(painting.tick());
    return recorder.recording();
}

TEST(HandAidsReplay, GivesTheSameBitsOnAnyNumberOfThreads) {
    std::uint64_t hash = 0;
    const Recording recording = aided_session(hash);
    for (const int threads : {1, 3}) {
        core::ThreadPool pool(threads);
        Painting painting(recording.canvas, pool);
        Player player(painting, recording);
        while (!player.finished())
            player.play_tick();
        EXPECT_EQ(painting.state_hash(), hash);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
}

TEST(HandAidsChecks, RefuseWhatIsOutOfRange) {
    const auto refused = [](const Action& action) { return error_of([&] { check_action(action); }); };
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refused(SetSymmetry{star(0, false)}),
              "the number of the symmetry's copies is 0, but must lie between 1 and 16.");
    EXPECT_THAT(refused(SetSymmetry{star(17, false)}), HasSubstr("copies is 17"));
    EXPECT_THAT(refused(SetSymmetry{{.centre_x_mm = kNan}}),
                HasSubstr("the x of the centre of the symmetry in mm is nan"));
    EXPECT_THAT(refused(SetSymmetry{{.axis_deg = 1000.0}}), HasSubstr("axis of the symmetry in degrees is 1000"));
    EXPECT_THAT(refused(SetStabiliser{{-1.0, 0.0}}), HasSubstr("smoothing of the stabiliser in ms"));
    EXPECT_THAT(refused(SetStabiliser{{0.0, kNan}}), HasSubstr("string of the stabiliser in mm is nan"));
    EXPECT_THAT(refused(SetGuide{{.form = brush::Ruler{1.0, 1.0, 1.0, 1.0}}}),
                HasSubstr("distance of the ruler's points in mm is 0"));
    EXPECT_THAT(refused(SetGuide{{.form = brush::EllipseCurve{0.0, 0.0, 0.0, 5.0, 0.0}}}),
                HasSubstr("half width of the ellipse in mm is 0"));
    EXPECT_THAT(refused(SetGuide{{.reach_mm = -1.0}}), HasSubstr("reach of the guide"));
    EXPECT_THAT(refused(SetGuide{{.strength = 1.5}}), HasSubstr("strength of the guide is 1.5"));
    EXPECT_THAT(refused(SetGuide{{.strength = kNan}}), HasSubstr("strength of the guide is nan"));
    EXPECT_THAT(refused(SetGuide{{.form = brush::VanishingPoints{.count = 4}}}),
                HasSubstr("number of vanishing points is 4"));
    EXPECT_THAT(refused(SetGuide{{.form = brush::VanishingPoints{.x1_mm = 1e9}}}),
                HasSubstr("x of the first vanishing point in mm is 1e+09"));
    EXPECT_THAT(refused(SetGuide{{.form = brush::Grid{.spacing_mm = 0.0}}}),
                HasSubstr("spacing of the grid's first lines in mm is 0"));
    EXPECT_EQ(error_of([] { check_action(SetSymmetry{star(16, true)}); }), "");
}

}  // namespace
}  // namespace pastoso::document
