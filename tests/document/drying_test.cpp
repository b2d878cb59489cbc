#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/player.hpp"
#include "document/scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

/// As in painting_test.cpp.
constexpr double kRounding = 1e-9;

class DryingTest : public testing::Test {
  protected:
    core::ThreadPool pool{1};
    Painting painting{small_canvas(), pool};

    void paint_stroke(const char* medium, const char* pigment, double start_s, double y_mm) {
        painting.apply(CleanBrush{});
        painting.apply(UseMedium{medium});
        painting.apply(load_of(pigment));
        paint_wave(painting, start_s, y_mm);
    }
    void advance(int ticks) {
        for (int i = 0; i < ticks; ++i)
            painting.advance_tick();
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
    void SetUp() override { painting.apply(TakeBrush{"flat", 8, 1}); }
};

TEST_F(DryingTest, DryNowDriesEverythingAndKeepsTheAccount) {
    paint_stroke("soft-body acrylic", "PB29", 0.0, 10.0);
    paint_stroke("ink glaze", "PR254", 1.0, 14.0);
    const double wet_mm3 = painting.account().canvas.volume_mm3;
    painting.apply(DryNow{});
    const Account account = painting.account();
    EXPECT_EQ(account.canvas.volume_mm3, 0.0);
    EXPECT_GT(account.dried.volume_mm3, 0.1 * wet_mm3);
    EXPECT_LT(account.dried.volume_mm3, 0.66 * wet_mm3);
    expect_balance();
    paint_stroke("heavy-body oil", "PY35", 2.0, 12.0);
    advance(3);
    expect_balance();
}

TEST_F(DryingTest, DryNowCanBeUndone) {
    paint_stroke("soft-body acrylic", "PB29", 0.0, 10.0);
    const std::uint64_t wet = painting.state_hash();
    painting.apply(DryNow{});
    const std::uint64_t dry = painting.state_hash();
    EXPECT_NE(dry, wet);
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), wet);
    EXPECT_EQ(painting.account().dried.volume_mm3, 0.0);
    EXPECT_EQ(painting.account().ledger.volume_mm3, 0.0);
    expect_balance();
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), dry);
    expect_balance();
}

TEST_F(DryingTest, PaintDriesAtTheSpeedOfTheAir) {
    paint_stroke("fluid acrylic", "PB29", 0.0, 10.0);
    advance(60);
    EXPECT_EQ(painting.account().dried.volume_mm3, 0.0) << "the air stands still at first";
    painting.apply(SetDrying{{.speed = 1000.0}});
    advance(120);
    EXPECT_GT(painting.account().dried.volume_mm3, 0.0);
    EXPECT_GT(painting.account().ledger.volume_mm3, 0.0);
    expect_balance();
    advance(300);
    EXPECT_EQ(painting.account().canvas.volume_mm3, 0.0);
    expect_balance();
}

TEST_F(DryingTest, ThinnerLiftsInkButNotAcrylic) {
    const auto lifted_pigment = [&](const char* medium) {
        Painting fresh(small_canvas(), pool);
        fresh.apply(TakeBrush{"flat", 8, 1});
        fresh.apply(UseMedium{medium});
        fresh.apply(load_of("PB15:3"));
        paint_wave(fresh, 0.0, 15.0);
        fresh.apply(DryNow{});
        fresh.apply(CleanBrush{});
        fresh.apply(UseMedium{"thinner"});
        fresh.apply(LoadPaint{});
        EXPECT_EQ(fresh.account().brush.pigment[0], 0.0);
        paint_wave(fresh, 1.0, 15.0);
        for (int i = 0; i < 61; ++i)
            fresh.advance_tick();
        EXPECT_LT(fresh.account().volume_error_rel(), kRounding);
        EXPECT_LT(fresh.account().pigment_error_rel(), kRounding);
        return fresh.account().canvas.pigment[5];
    };
    // Along the edges of its stroke acrylic is too thin to bind itself.
    EXPECT_LT(lifted_pigment("soft-body acrylic"), 0.05 * lifted_pigment("ink glaze"));
}

TEST_F(DryingTest, AbsurdSpeedsAreRefused) {
    EXPECT_THAT(error_of([&] { painting.apply(SetDrying{{.speed = 1e6}}); }),
                HasSubstr("speed of drying"));
    EXPECT_THAT(error_of([&] { painting.apply(SetDrying{{.speed = NAN}}); }), HasSubstr("nan"));
    EXPECT_THAT(error_of([&] { painting.apply(SetDrying{{.fan = 0.0}}); }),
                HasSubstr("strength of the fan"));
}

Recording drying_session() {
    Recording recording = crossing_session();
    auto& events = recording.events;
    events.insert(events.begin(), {0, SetDrying{{2000, 5, 20, 15, 12}}});
    events.push_back({50, UseMedium{"thinner"}});
    events.push_back({50, LoadPaint{}});
    events.push_back({50, PenDown{wave_sample(1.0, 11.0, 0)}});
    for (int i = 1; i <= 30; ++i)
        events.push_back({50, PenMove{wave_sample(1.0, 11.0, i)}});
    events.push_back({51, PenUp{}});
    events.push_back({80, DryNow{}});
    recording.end_tick = 90;
    return recording;
}

TEST(DryingThreads, ASessionThatDriesGivesTheSameBitsOnAnyNumberOfThreads) {
    const auto hash = [](int threads) {
        const Recording recording = drying_session();
        core::ThreadPool pool(threads);
        Painting painting(recording.canvas, pool);
        Player player(painting, recording);
        while (!player.finished())
            player.play_tick();
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
        return painting.state_hash();
    };
    const std::uint64_t one = hash(1);
    EXPECT_EQ(hash(2), one);
    EXPECT_EQ(hash(3), one);
}

}  // namespace
}  // namespace pastoso::document
