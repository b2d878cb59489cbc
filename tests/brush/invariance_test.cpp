// The same movement gives the same stroke: again, at another event rate, on finer cells, in the mirror.
#include "brush/stroke.hpp"
#include "brush/studio.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

PenSample wavy(double t) {
    return {.x_mm = 15.0 + 70.0 * t,
            .y_mm = 25.0 + 8.0 * std::sin(6.0 * t),
            .pressure = 0.5 * studio::fade(t),
            .tilt_x_deg = 5.7,
            .tilt_y_deg = 2.9,
            .rotation_deg = 74.5};
}

/// Paints the wavy stroke on an empty canvas of 100 x 50 mm.
film::FilmState wavy_stroke(film::FilmState film, double rate_Hz, std::uint32_t seed = 1) {
    Brush brush(studio::flat_preset(16.0), 0.0, seed);
    brush.load(studio::dark_paint(), 1.0);
    studio::paint(brush, film, wavy, rate_Hz);
    return film;
}

film::FilmState wavy_stroke_on_linen(double rate_Hz, double px_per_mm, std::uint32_t seed = 1) {
    return wavy_stroke(studio::linen(100.0, 50.0, px_per_mm), rate_Hz, seed);
}

TEST(Stroke, ReplaysToTheSameBits) {
    const auto first = film::state_hash(wavy_stroke_on_linen(250.0, 4.0));
    EXPECT_EQ(film::state_hash(wavy_stroke_on_linen(250.0, 4.0)), first);
    EXPECT_NE(film::state_hash(wavy_stroke_on_linen(250.0, 4.0, 2)), first);
}

TEST(Stroke, DoesNotDependOnTheEventRate) {
    const film::FilmState fast = wavy_stroke_on_linen(1000.0, 8.0);
    const film::FilmState slow = wavy_stroke_on_linen(125.0, 8.0);
    EXPECT_NEAR(studio::volume_mm3(slow) / studio::volume_mm3(fast), 1.0, 1e-3);
    EXPECT_LT(studio::relative_difference(fast, slow, fast.cell_mm), 0.005);
}

class EveryTool : public testing::TestWithParam<const char*> {
  protected:
    static film::FilmState stroke(double rate_Hz, double px_per_mm) {
        film::FilmState film = studio::linen(100.0, 50.0, px_per_mm);
        Brush brush(resized(find_preset(GetParam()), 12.0));
        brush.load(studio::dark_paint(), 1.0);
        studio::paint(brush, film, wavy, rate_Hz);
        return film;
    }
};

TEST_P(EveryTool, DoesNotDependOnTheEventRate) {
    const film::FilmState fast = stroke(1000.0, 4.0), slow = stroke(125.0, 4.0);
    EXPECT_NEAR(studio::volume_mm3(slow) / studio::volume_mm3(fast), 1.0, 1e-3);
    // The design asks for 1 %; the round, whose stroke is the narrowest, has 0.4 %, the others 0.15 %.
    EXPECT_LT(studio::relative_difference(fast, slow, fast.cell_mm), 0.005);
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryTool, testing::Values("flat", "round", "filbert", "fan", "knife"));

void expect_alike(const film::FilmState& coarse, const film::FilmState& fine) {
    EXPECT_NEAR(studio::volume_mm3(coarse) / studio::volume_mm3(fine), 1.0, 0.005);
    EXPECT_LT(studio::relative_difference(fine, coarse, 1.0), 0.03);
}

TEST(Stroke, HardlyDependsOnTheCellSize) {
    expect_alike(wavy_stroke_on_linen(250.0, 8.0), wavy_stroke_on_linen(250.0, 16.0));
    // Cells of a quarter of a millimetre flatten the threads of a linen by an eighth, so the same on
    // panels.
    expect_alike(wavy_stroke(studio::smooth(100.0, 50.0, 4.0), 250.0),
                 wavy_stroke(studio::smooth(100.0, 50.0, 8.0), 250.0));
}

TEST(Stroke, IsMirroredByAMirroredHand) {
    constexpr double kWidth_mm = 64.0;
    const auto down = [](double t) {
        return PenSample{.x_mm = 28.0 + 6.0 * std::sin(5.0 * t),
                         .y_mm = 8.0 + 44.0 * t,
                         .pressure = 0.5 * studio::fade(t),
                         .tilt_x_deg = 15.0,
                         .rotation_deg = 20.0};
    };
    const auto down_mirrored = [&](double t) {
        PenSample sample = down(t);
        sample.x_mm = kWidth_mm - sample.x_mm;
        sample.tilt_x_deg = -sample.tilt_x_deg;
        sample.rotation_deg = -sample.rotation_deg;
        return sample;
    };
    film::FilmState film = studio::smooth(kWidth_mm, 60.0), reflected = film;
    Brush brush(studio::flat_preset(16.0));
    brush.load(studio::dark_paint(), 0.8);
    Brush reflection = brush;
    reflection.tip = mirrored(brush.tip);
    studio::paint(brush, film, down);
    studio::paint(reflection, reflected, down_mirrored);
    double difference = 0.0, sum = 0.0;
    for (int y = 0; y < film.shape.height; ++y) {
        for (int x = 0; x < film.shape.width; ++x) {
            const double h = studio::thickness_mm(film, x, y);
            difference += std::abs(h - studio::thickness_mm(reflected, film.shape.width - 1 - x, y));
            sum += h;
        }
    }
    EXPECT_LT(difference / sum, 1e-4);  // single precision of places within a footprint
}

TEST(Stroke, TapLeavesAMark) {
    for (const char* name : {"flat", "round", "knife", "fan", "filbert"}) {
        film::FilmState film = studio::linen(40.0, 40.0, 4.0);
        Brush brush(find_preset(name));
        brush.load(studio::dark_paint(), 1.0);
        Stroke stroke(brush, film);
        stroke.begin({.x_mm = 20.0, .y_mm = 20.0, .pressure = 0.5});
        EXPECT_FALSE(name != std::string("knife") && stroke.take_changed_cells().empty()) << name;
        stroke.end();
        EXPECT_GT(studio::volume_mm3(film), 0.5) << name;
    }
}

TEST(Stroke, WithoutPressureLeavesNone) {
    film::FilmState film = studio::linen(40.0, 40.0, 4.0);
    Brush brush(find_preset("flat"));
    brush.load(studio::dark_paint(), 1.0);
    studio::paint(brush, film, studio::line(5.0, 20.0, 35.0, 20.0, 0.0, 90.0));
    EXPECT_EQ(studio::volume_mm3(film), 0.0);
}

TEST(Stroke, RestingPenDoesNothingMore) {
    film::FilmState film = studio::linen(40.0, 40.0, 4.0);
    Brush brush(find_preset("flat"));
    brush.load(studio::dark_paint(), 1.0);
    Stroke stroke(brush, film);
    PenSample sample{.x_mm = 20.0, .y_mm = 20.0, .pressure = 0.5};
    stroke.begin(sample);
    for (int i = 0; i < 20; ++i)
        stroke.add(sample);  // equal times as well
    const auto hash = film::state_hash(film);
    (void)stroke.take_changed_cells();
    for (int i = 0; i < 100; ++i) {
        sample.time_s += 0.05;
        stroke.add(sample);
    }
    EXPECT_EQ(film::state_hash(film), hash);
    EXPECT_TRUE(stroke.take_changed_cells().empty());
    stroke.end();
}

TEST(Stroke, ReportsTheCellsItChanged) {
    film::FilmState film = studio::linen(60.0, 40.0, 4.0);
    const film::FilmState before = film;
    Brush brush(find_preset("flat"));
    brush.load(studio::dark_paint(), 1.0);
    Stroke stroke(brush, film);
    stroke.begin({.x_mm = 20.0, .y_mm = 20.0, .pressure = 0.5, .rotation_deg = 90.0});
    for (int i = 1; i <= 30; ++i) {
        stroke.add({.time_s = 0.01 * i,
                    .x_mm = 20.0 + 0.5 * i,
                    .y_mm = 20.0,
                    .pressure = 0.5,
                    .rotation_deg = 90.0});
    }
    stroke.end();
    const grid::Rect changed = stroke.take_changed_cells();
    for (int y = 0; y < film.shape.height; ++y) {
        for (int x = 0; x < film.shape.width; ++x) {
            if (film.thickness.at(x, y) == 0) continue;
            EXPECT_TRUE(x >= changed.x0 && x < changed.x1 && y >= changed.y0 && y < changed.y1);
        }
    }
    EXPECT_LT(changed.width(), 40 * 4);
    EXPECT_TRUE(stroke.take_changed_cells().empty());
}

TEST(Stroke, EndsWhereThePenDoes) {
    film::FilmState film = studio::smooth(60.0, 20.0);
    Preset preset = studio::round_preset(3.0);
    preset.flex.bend = 0.0;  // the tip stays below the ferrule
    Brush brush(preset);
    brush.load(studio::dark_paint(), 1.0);
    Stroke stroke(brush, film);
    stroke.begin({.x_mm = 10.0, .y_mm = 10.0, .pressure = 0.6});
    for (int i = 1; i <= 20; ++i) {
        stroke.add({.time_s = 0.008 * i, .x_mm = 10.0 + 2.0 * i, .y_mm = 10.0, .pressure = 0.6});
    }
    stroke.end();
    EXPECT_GT(studio::thickness_mm(film, 50 * 8, 10 * 8), 0.01);
    EXPECT_EQ(studio::thickness_mm(film, 54 * 8, 10 * 8), 0.0);
}

}  // namespace
}  // namespace pastoso::brush
