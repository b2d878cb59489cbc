// Tools that are no brushes: what each is for, seen on the canvas.
#include "brush/brush.hpp"
#include "brush/stroke.hpp"
#include "brush/studio.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kTick_s = 1.0 / 60.0;

/// A movement of `duration_s` with time passing as in a painting.
void use(Brush& brush, film::FilmState& film, const studio::Movement& movement, double duration_s) {
    Stroke stroke(brush, film);
    const int ticks = static_cast<int>(std::lround(duration_s / kTick_s));
    const auto at = [&](int tick) {
        PenSample sample = movement(static_cast<double>(tick) / ticks);
        sample.time_s = tick * kTick_s;
        return sample;
    };
    stroke.begin(at(0));
    for (int tick = 1; tick <= ticks; ++tick) {
        stroke.add(at(tick));
        stroke.pass_time(kTick_s);
    }
    stroke.end();
}

studio::Movement held_at(double x_mm, double y_mm, double pressure) {
    return [=](double) { return PenSample{.x_mm = x_mm, .y_mm = y_mm, .pressure = pressure}; };
}

Contents everything(const Brush& brush, const film::FilmState& film) {
    Contents sum = studio::contents(film);
    sum += brush.contents();
    sum += brush.thrown_away;
    return sum;
}

class AnyTool : public testing::TestWithParam<Preset> {};

std::string test_name(const std::string& preset_name) {
    std::string name = preset_name;
    name.erase(std::remove_if(name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }),
               name.end());
    return name;
}

/// A loaded tool that is drawn through wet paint neither makes nor loses any.
TEST_P(AnyTool, KeepsTheBalance) {
    film::FilmState film = studio::linen(90.0, 60.0, 4.0);
    studio::cover(film, studio::cells_of(film, 30.0, 0.0, 60.0, 60.0), 0.6, studio::light_paint());
    Brush brush(GetParam());
    brush.load(studio::dark_paint(), 1.0);
    const Contents before = everything(brush, film);
    use(brush, film, studio::line(15.0, 30.0, 75.0, 30.0, 0.6, 90.0), 1.0);
    // Sums of 15000 cells and up to 300 bristles in double.
    EXPECT_LT(studio::balance_error(everything(brush, film), before), 1e-12);
}

TEST_P(AnyTool, DoesTheSameTwice) {
    std::uint64_t hash = 0;
    for (int run = 0; run < 2; ++run) {
        film::FilmState film = studio::linen(60.0, 30.0, 4.0);
        studio::cover(film, 0.3, studio::light_paint());
        Brush brush(GetParam());
        brush.load(studio::dark_paint(), 1.0);
        use(brush, film, studio::line(15.0, 15.0, 45.0, 15.0, 0.6, 90.0), 0.5);
        if (run > 0) {
            EXPECT_EQ(film::state_hash(film), hash);
        }
        hash = film::state_hash(film);
    }
}
INSTANTIATE_TEST_SUITE_P(Presets, AnyTool, testing::ValuesIn(bundled_presets()),
                         [](const auto& test) { return test_name(test.param.name); });

/// The mean thickness in the middle of a stroke over 0.5 mm of wet paint.
double left_by_mm(const char* tool, double pressure) {
    film::FilmState film = studio::linen(90.0, 60.0, 4.0);
    studio::cover(film, 0.5, studio::dark_paint());
    Brush brush(find_preset(tool));
    use(brush, film, studio::line(20.0, 30.0, 70.0, 30.0, pressure, 90.0), 1.0);
    return studio::mean_thickness_mm(film, studio::cells_of(film, 40.0, 28.0, 50.0, 32.0));
}

TEST(Rag, WipesMostAndLeavesAStain) {
    const double left_mm = left_by_mm("rag", 0.7);
    EXPECT_LT(left_mm, 0.06);
    EXPECT_GT(left_mm, 0.002);
}

TEST(Rag, ThrowsAwayWhatItTakes) {
    film::FilmState film = studio::linen(60.0, 60.0, 4.0);
    studio::cover(film, 0.5, studio::dark_paint());
    const double before_mm3 = studio::volume_mm3(film);
    Brush rag(find_preset("rag"));
    use(rag, film, studio::line(20.0, 30.0, 40.0, 30.0, 0.7, 90.0), 0.5);
    EXPECT_EQ(rag.contents(), Contents{});
    EXPECT_NEAR(rag.thrown_away.volume_mm3, before_mm3 - studio::volume_mm3(film), 1e-9 * before_mm3);
    EXPECT_GT(rag.take_thrown_away().volume_mm3, 50.0);
    EXPECT_EQ(rag.thrown_away, Contents{});
}

TEST(Eraser, BaresTheSupport) {
    EXPECT_LT(left_by_mm("eraser", 0.8), 0.01);
}

TEST(BlottingPad, TakesWhatStandsAboveItsFilm) {
    film::FilmState film = studio::smooth(80.0, 60.0, 4.0);
    studio::cover(film, 0.5, studio::dark_paint());
    Brush pad(find_preset("blot"));
    use(pad, film, held_at(40.0, 30.0, 0.8), 0.5);
    const double left_mm =
        studio::mean_thickness_mm(film, studio::cells_of(film, 35.0, 25.0, 45.0, 35.0));
    EXPECT_LT(left_mm, 0.35);
    EXPECT_GT(left_mm, pad.preset.paint.film_mm * 0.5);
}

/// Local maxima of the thickness across some rows of a stroke, at least 0.05 mm above the valleys beside
/// them.
int ridges_across(const film::FilmState& film, int x, int first_row, int last_row) {
    int ridges = 0;
    double valley = 1e9, peak = 0.0;
    bool rising = false;
    for (int y = first_row; y <= last_row; ++y) {
        const double h = studio::thickness_mm(film, x, y);
        peak = rising ? std::max(peak, h) : h;
        valley = rising ? valley : std::min(valley, h);
        if (!rising && h > valley + 0.05) {
            rising = true;
            peak = h;
        } else if (rising && h < peak - 0.05) {
            ++ridges;
            rising = false;
            valley = h;
        }
    }
    return ridges;
}

TEST(Comb, LeavesARidgeBetweenEachTwoTeeth) {
    film::FilmState film = studio::smooth(70.0, 50.0, 8.0);
    studio::cover(film, 0.6, studio::dark_paint());
    Brush comb(find_preset("comb"));
    use(comb, film, studio::line(15.0, 25.0, 55.0, 25.0, 0.7, 90.0), 1.0);
    // From the outermost tooth on one side to that on the other: beyond them lie the ridges at the
    // edges.
    const int half_width = static_cast<int>(8.0 * comb.tip.bristles.back().root_x_mm);
    EXPECT_EQ(ridges_across(film, 45 * 8, 25 * 8 - half_width, 25 * 8 + half_width),
              comb.preset.tip.bristles - 1);
}

TEST(Fingertip, SmudgesOneColourIntoTheOther) {
    film::FilmState film = studio::smooth(80.0, 40.0, 4.0);
    studio::cover(film, studio::cells_of(film, 0.0, 0.0, 40.0, 40.0), 0.3, studio::dark_paint());
    studio::cover(film, studio::cells_of(film, 40.0, 0.0, 80.0, 40.0), 0.3, studio::light_paint());
    Brush finger(find_preset("finger"));
    use(finger, film, studio::line(25.0, 20.0, 65.0, 20.0, 0.6, 0.0), 1.0);
    const auto dark_share = [&](double x_mm) {
        const int x = static_cast<int>(x_mm * 4.0);
        const double per_mm =
            film::optical_thickness(film.paint.at(x, 80)[0]) / studio::thickness_mm(film, x, 80);
        return (per_mm - studio::light_paint()[0]) /
               (studio::dark_paint()[0] - studio::light_paint()[0]);
    };
    EXPECT_GT(dark_share(44.0), 0.25);
    EXPECT_GT(dark_share(44.0), dark_share(52.0));
    EXPECT_LT(dark_share(75.0), 1e-3);
}

TEST(Dropper, LetsOneDropOfItsVolumeFallAtATouch) {
    film::FilmState film = studio::smooth(40.0, 40.0, 8.0);
    Preset preset = find_preset("dropper");
    preset.droplets.variation = 0.0;
    Brush dropper(preset);
    dropper.load(studio::dark_paint(), 1.0);
    use(dropper, film, held_at(20.0, 20.0, 1.0), kTick_s);
    // A cap's volume is exact but for the last quantum of every cell.
    EXPECT_NEAR(studio::volume_mm3(film), preset.droplets.drop_mm3, 1e-4);
    const double radius_mm = std::cbrt(2.0 * preset.droplets.drop_mm3 / (3.14159265 * 0.35));
    EXPECT_NEAR(studio::thickness_mm(film, 160, 160), 0.35 * radius_mm, 0.05);
}

TEST(Dropper, GoesOnDrippingWhileThePenIsHeld) {
    film::FilmState film = studio::smooth(40.0, 40.0, 4.0);
    Preset preset = find_preset("dropper");
    preset.droplets.variation = 0.0;
    Brush dropper(preset);
    dropper.load(studio::dark_paint(), 1.0);
    use(dropper, film, held_at(20.0, 20.0, 1.0), 3.0);
    const auto drops = std::lround(studio::volume_mm3(film) / preset.droplets.drop_mm3);
    // One at the touch, and 25 mm3 every second; the last may be about to fall.
    EXPECT_GE(drops, 3);
    EXPECT_LE(drops, 4);
}

TEST(SprayCan, SpraysItsRateOverItsWidth) {
    film::FilmState film = studio::smooth(80.0, 80.0, 4.0);
    Brush can(find_preset("spray"));
    can.load(studio::dark_paint(), 1.0);
    use(can, film, held_at(40.0, 40.0, 1.0), 2.0);
    const double expected_mm3 = 2.0 * can.preset.droplets.rate_mm3_s;
    // The pressure is followed to one part in 200.
    EXPECT_NEAR(studio::volume_mm3(film), expected_mm3, 0.01 * expected_mm3);
    double beyond_mm = 0.0;
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x)
            if (std::hypot(x / 4.0 - 40.0, y / 4.0 - 40.0) > 19.0)
                beyond_mm += studio::thickness_mm(film, x, y);
    EXPECT_EQ(beyond_mm, 0.0);
    const double middle_mm =
        studio::mean_thickness_mm(film, studio::cells_of(film, 37.0, 37.0, 43.0, 43.0));
    const double outer_mm =
        studio::mean_thickness_mm(film, studio::cells_of(film, 52.0, 37.0, 57.0, 43.0));
    EXPECT_GT(middle_mm, 2.0 * outer_mm);
    EXPECT_GT(outer_mm, 0.0);
}

TEST(SprayCan, EmptyItSpraysNothing) {
    film::FilmState film = studio::smooth(40.0, 40.0, 4.0);
    Brush can(find_preset("spray"));
    use(can, film, held_at(20.0, 20.0, 1.0), 0.5);
    EXPECT_EQ(studio::volume_mm3(film), 0.0);
}

TEST(Spatter, FliesOnlyFromAMovingBrushAndAhead) {
    const auto volume_after = [](double reach_mm, double* mean_x_mm) {
        film::FilmState film = studio::smooth(160.0, 60.0, 4.0);
        Brush brush(find_preset("spatter"));
        brush.load(studio::dark_paint(), 1.0);
        use(brush, film, studio::line(20.0, 30.0, 20.0 + reach_mm, 30.0, 0.8, 0.0), 0.25);
        double sum = 0.0, moment = 0.0;
        for (int y = 0; y < film.shape.height; ++y)
            for (int x = 0; x < film.shape.width; ++x) {
                sum += studio::thickness_mm(film, x, y);
                moment += x / 4.0 * studio::thickness_mm(film, x, y);
            }
        *mean_x_mm = sum > 0.0 ? moment / sum : 0.0;
        return studio::volume_mm3(film);
    };
    double still_mm = 0.0, fast_mm = 0.0;
    EXPECT_EQ(volume_after(0.0, &still_mm), 0.0);
    EXPECT_GT(volume_after(60.0, &fast_mm), 10.0);
    EXPECT_GT(fast_mm, 55.0);  // the stroke's middle is at 50
}

TEST(Blow, AJetFollowsThePenAndEndsWithTheStroke) {
    film::FilmState film = studio::smooth(60.0, 40.0, 4.0);
    Brush straw(studio::linear(find_preset("blow")));
    EXPECT_EQ(straw.load(studio::dark_paint(), 1.0), Contents{});
    Stroke stroke(straw, film);
    EXPECT_EQ(stroke.air_jet(), std::nullopt);
    stroke.begin({.time_s = 0.0, .x_mm = 10.0, .y_mm = 20.0, .pressure = 0.5});
    for (int i = 1; i <= 60; ++i)
        stroke.add({.time_s = i * kTick_s,
                    .x_mm = 10.0 + 0.5 * i,
                    .y_mm = 20.0,
                    .pressure = 0.5,
                    .tilt_x_deg = 60.0});
    const auto jet = stroke.air_jet();
    ASSERT_TRUE(jet.has_value());
    EXPECT_NEAR(jet->x_mm, 40.0, 1.5 + 0.6 * jet->radius_mm);
    EXPECT_NEAR(jet->y_mm, 20.0, 0.6 * jet->radius_mm);
    EXPECT_NEAR(jet->radius_mm, 4.0, 1e-9);
    EXPECT_NEAR(jet->pressure_Pa, 0.5 * straw.preset.air.pressure_Pa,
                0.01 * straw.preset.air.pressure_Pa);
    EXPECT_NEAR(jet->lean_x, 1.0, 0.02);
    stroke.end();
    EXPECT_EQ(stroke.air_jet(), std::nullopt);
}

/// Held still it blows now here, now there, within 0.6 radii, alike in every replay; its mirror image
/// wavers in the mirror.
TEST(Blow, AJetWavers) {
    film::FilmState film = studio::smooth(60.0, 40.0, 4.0);
    Brush straw(studio::linear(find_preset("blow"))), copied(straw), mirrored(straw);
    Stroke stroke(straw, film), again(copied, film);
    Placement placement;
    placement.xx = -1.0;
    placement.x_mm = 60.0;
    placement.mirrored = true;
    Stroke mirror(mirrored, film, {}, placement);
    for (Stroke* each : {&stroke, &again, &mirror})
        each->begin({.time_s = 0.0, .x_mm = 20.0, .y_mm = 20.0, .pressure = 0.5});
    double least_mm = 60.0, most_mm = 0.0;
    for (int tick = 0; tick < 120; ++tick) {
        for (Stroke* each : {&stroke, &again, &mirror})
            each->pass_time(kTick_s);
        const film::AirJet jet = *stroke.air_jet();
        EXPECT_EQ(*again.air_jet(), jet);
        EXPECT_NEAR(mirror.air_jet()->x_mm, 60.0 - jet.x_mm, 1e-9);
        EXPECT_NEAR(mirror.air_jet()->y_mm, jet.y_mm, 1e-9);
        least_mm = std::min(least_mm, jet.x_mm);
        most_mm = std::max(most_mm, jet.x_mm);
    }
    EXPECT_GE(least_mm, 20.0 - 0.6 * 4.0);
    EXPECT_LE(most_mm, 20.0 + 0.6 * 4.0);
    EXPECT_GT(most_mm - least_mm, 2.0);
}

}  // namespace
}  // namespace pastoso::brush
