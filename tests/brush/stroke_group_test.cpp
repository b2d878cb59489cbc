// Several brushes at one movement: each paints its exact share, and nothing is lost.
#include "brush/stroke_group.hpp"

#include "brush/studio.hpp"
#include "core/units.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kSide_mm = 64.0;

/// A curve in the left upper part of the canvas, with tilt and a turning barrel.
PenSample curve(double t) {
    return {.x_mm = 8.0 + 16.0 * t,
            .y_mm = 12.0 + 6.0 * std::sin(5.0 * t),
            .pressure = 0.6 * studio::fade(t),
            .tilt_x_deg = 15.0,
            .tilt_y_deg = -5.0,
            .rotation_deg = 20.0 + 60.0 * t};
}

void paint_group(Brush& brush, film::FilmState& film, const HandAids& aids, const Symmetry& symmetry,
                 const std::function<PenSample(double)>& movement = curve) {
    StrokeGroup group(brush, film, aids, symmetry);
    constexpr int kSamples = 125;
    for (int i = 0; i <= kSamples; ++i) {
        PenSample sample = movement(static_cast<double>(i) / kSamples);
        sample.time_s = static_cast<double>(i) / kSamples;
        if (i == 0)
            group.begin(sample);
        else
            group.add(sample);
    }
    group.end();
}

/// Sum of the differences between every cell and its image, against the sum of all.
double asymmetry(const film::FilmState& film,
                 const std::function<std::pair<int, int>(int, int)>& image) {
    double difference = 0.0, sum = 0.0;
    for (int y = 0; y < film.shape.height; ++y) {
        for (int x = 0; x < film.shape.width; ++x) {
            const auto [u, v] = image(x, y);
            const double h = studio::thickness_mm(film, x, y);
            difference += std::abs(h - studio::thickness_mm(film, u, v));
            sum += h;
        }
    }
    return difference / sum;
}

/// Places within a footprint are in single precision.
constexpr double kCellRounding = 1e-4;

const Symmetry kMirror{.centre_x_mm = 0.5 * kSide_mm, .centre_y_mm = 0.5 * kSide_mm, .mirror = true};

class MirroredTools : public testing::TestWithParam<const char*> {};

TEST_P(MirroredTools, PaintTheExactMirrorImage) {
    film::FilmState film = studio::smooth(kSide_mm, kSide_mm);
    studio::cover(film, studio::cells_of(film, 0.0, 10.0, kSide_mm, 16.0), 0.3, studio::light_paint());
    Brush brush(resized(find_preset(GetParam()), 10.0));
    brush.load(studio::dark_paint(), 1.2);  // so full that it spills
    paint_group(brush, film, {}, kMirror);
    const int last = film.shape.width - 1;
    EXPECT_LT(asymmetry(film, [&](int x, int y) { return std::pair{last - x, y}; }), kCellRounding);
}

INSTANTIATE_TEST_SUITE_P(Presets, MirroredTools, testing::Values("flat", "round", "fan", "knife"));

TEST(StrokeGroup, QuarterTurnsPaintTheSameFourTimes) {
    film::FilmState film = studio::smooth(kSide_mm, kSide_mm);
    Brush brush(studio::flat_preset(8.0));
    brush.load(studio::dark_paint(), 1.0);
    Symmetry symmetry = kMirror;
    symmetry.count = 4;
    // Within an eighth of the circle, so that no two copies meet.
    paint_group(brush, film, {}, symmetry, [](double t) {
        PenSample sample = curve(t);
        sample.x_mm = 19.0 + 6.0 * t;
        sample.y_mm = 6.0 + 2.0 * std::sin(5.0 * t);
        return sample;
    });
    const int last = film.shape.width - 1;
    EXPECT_LT(asymmetry(film, [&](int x, int y) { return std::pair{last - y, x}; }), kCellRounding);
    EXPECT_LT(asymmetry(film, [&](int x, int y) { return std::pair{y, x}; }), kCellRounding);
}

TEST(StrokeGroup, OfOneIsAStroke) {
    film::FilmState alone = studio::linen(kSide_mm, kSide_mm, 4.0), group = alone;
    Brush brush(studio::flat_preset(8.0));
    brush.load(studio::dark_paint(), 1.0);
    Brush same = brush;
    studio::paint(brush, alone, curve, 125.0);
    paint_group(same, group, {}, {});
    EXPECT_EQ(film::state_hash(group), film::state_hash(alone));
    EXPECT_EQ(same.contents(), brush.contents());
}

TEST(StrokeGroup, CopiesLeaveTheBrushInHandAlone) {
    film::FilmState plain = studio::smooth(kSide_mm, kSide_mm, 4.0), mirrored = plain;
    Brush brush(studio::flat_preset(8.0));
    brush.load(studio::dark_paint(), 1.0);
    Brush same = brush;
    paint_group(brush, plain, {}, {});
    paint_group(same, mirrored, {}, kMirror);
    EXPECT_EQ(same.contents(), brush.contents());
    EXPECT_NEAR(studio::volume_mm3(mirrored) / studio::volume_mm3(plain), 2.0, 1e-5);
}

TEST(StrokeGroup, ACopyPicksUpForItself) {
    film::FilmState film = studio::smooth(kSide_mm, kSide_mm, 4.0);
    const int middle = film.shape.width / 2;
    studio::cover(film, {middle, 0, film.shape.width, film.shape.height}, 0.4, studio::light_paint());
    Brush brush(studio::flat_preset(8.0));
    StrokeGroup group(brush, film, {}, kMirror);
    PenSample sample = curve(0.3);
    group.begin(sample);
    for (int i = 1; i <= 50; ++i) {
        sample.time_s = 0.01 * i;
        sample.x_mm += 0.2;
        group.add(sample);
    }
    EXPECT_EQ(brush.contents().volume_mm3, 0.0);
    EXPECT_GT(group.copied_paint().volume_mm3, 0.1);
    group.end();
}

TEST(StrokeGroup, KeepsEveryDrop) {
    film::FilmState film = studio::linen(kSide_mm, kSide_mm, 4.0);
    studio::cover(film, 0.2, studio::light_paint());
    Contents before = studio::contents(film);
    Brush brush(studio::flat_preset(8.0));
    before += brush.load(studio::dark_paint(), 1.0);
    Symmetry symmetry = kMirror;
    symmetry.count = 5;
    StrokeGroup group(brush, film, {}, symmetry);
    before += group.copied_paint();
    EXPECT_NEAR(group.copied_paint().volume_mm3 / brush.contents().volume_mm3, 9.0, 1e-12);
    for (int i = 0; i <= 100; ++i) {
        PenSample sample = curve(0.01 * i);
        sample.time_s = 0.01 * i;
        if (i == 0)
            group.begin(sample);
        else
            group.add(sample);
    }
    group.end();
    Contents after = studio::contents(film);
    after += brush.contents();
    after += group.copied_paint();
    EXPECT_LT(studio::balance_error(after, before), 1e-11);  // rounding of doubles
}

TEST(StrokeGroup, TellsWhatEveryCopyChanged) {
    film::FilmState film = studio::smooth(kSide_mm, kSide_mm, 4.0);
    Brush brush(studio::flat_preset(4.0));
    brush.load(studio::dark_paint(), 1.0);
    StrokeGroup group(brush, film, {}, kMirror);
    group.begin(curve(0.0));
    for (int i = 1; i <= 20; ++i) {
        PenSample sample = curve(0.3 * i / 20.0);
        sample.time_s = 0.01 * i;
        group.add(sample);
    }
    const std::vector<grid::Rect> changed = group.take_changed_cells();
    ASSERT_EQ(changed.size(), 2U);
    EXPECT_LT(changed[0].x1, film.shape.width / 2);
    EXPECT_GT(changed[1].x0, film.shape.width / 2);
    group.end();
}

TEST(StrokeGroup, PaintsAStraightLineWhenThePenLifts) {
    film::FilmState film = studio::smooth(kSide_mm, kSide_mm, 4.0);
    Brush brush(studio::flat_preset(4.0));
    brush.load(studio::dark_paint(), 1.0);
    const HandAids aids{.guide = {.form = StraightLine{}, .turn_across = true}};
    StrokeGroup group(brush, film, aids, {});
    PenSample sample{.x_mm = 10.0, .y_mm = 10.0, .pressure = 0.5, .rotation_deg = 90.0};
    group.begin(sample);
    for (int i = 1; i <= 80; ++i) {
        sample.time_s = 0.01 * i;
        sample.x_mm = 10.0 + 0.5 * i;
        sample.y_mm = 10.0 + 8.0 * std::sin(core::kPi * i / 80.0);
        group.add(sample);
    }
    EXPECT_EQ(studio::volume_mm3(film), 0.0);
    group.end();
    const double on_line_mm =
        studio::mean_thickness_mm(film, studio::cells_of(film, 14.0, 9.0, 46.0, 11.0));
    EXPECT_GT(on_line_mm, 0.05);
    EXPECT_EQ(studio::coverage(film, studio::cells_of(film, 0.0, 16.0, kSide_mm, kSide_mm)), 0.0);
}

TEST(StrokeGroup, ARulerGuidesTheFilteredPenExactly) {
    film::FilmState film = studio::smooth(kSide_mm, kSide_mm, 4.0);
    Preset preset = studio::round_preset(3.0);
    preset.flex.bend = 0.0;  // the tip stays below the ferrule
    Brush brush(preset);
    brush.load(studio::dark_paint(), 1.0);
    const HandAids aids{.stabiliser = {100.0, 2.0}, .guide = {.form = Ruler{0.0, 30.0, 10.0, 30.0}}};
    paint_group(brush, film, aids, {}, [](double t) {
        return PenSample{
            .x_mm = 8.0 + 45.0 * t, .y_mm = 30.0 + 6.0 * std::sin(20.0 * t), .pressure = 0.5};
    });
    EXPECT_GT(studio::mean_thickness_mm(film, studio::cells_of(film, 12.0, 29.5, 50.0, 30.5)), 0.05);
    EXPECT_EQ(studio::coverage(film, studio::cells_of(film, 0.0, 33.0, kSide_mm, kSide_mm)), 0.0);
    EXPECT_EQ(studio::coverage(film, studio::cells_of(film, 0.0, 0.0, kSide_mm, 27.0)), 0.0);
}

TEST(StrokeGroup, UnderAPerspectiveAllOfTheStrokeIsOnTheLine) {
    film::FilmState film = studio::smooth(kSide_mm, kSide_mm, 4.0);
    Preset preset = studio::round_preset(3.0);
    preset.flex.bend = 0.0;
    Brush brush(preset);
    brush.load(studio::dark_paint(), 1.0);
    const HandAids aids{.guide = {.form = VanishingPoints{.count = 1, .x1_mm = 400.0, .y1_mm = 10.0}}};
    // Its first way is level, then it wanders off.
    paint_group(brush, film, aids, {}, [](double t) {
        return PenSample{.x_mm = 8.0 + 45.0 * t, .y_mm = 30.0 + 20.0 * t * t, .pressure = 0.5};
    });
    EXPECT_GT(studio::mean_thickness_mm(film, studio::cells_of(film, 8.0, 29.5, 50.0, 30.5)), 0.05);
    EXPECT_EQ(studio::coverage(film, studio::cells_of(film, 0.0, 33.0, kSide_mm, kSide_mm)), 0.0);
    EXPECT_EQ(studio::coverage(film, studio::cells_of(film, 0.0, 0.0, kSide_mm, 27.0)), 0.0);
}

TEST(StrokeGroup, ATapUnderAGridIsADab) {
    film::FilmState film = studio::smooth(kSide_mm, kSide_mm, 4.0);
    Brush brush(studio::round_preset(3.0));
    brush.load(studio::dark_paint(), 1.0);
    const HandAids aids{.guide = {.form = Grid{}}};
    paint_group(brush, film, aids, {}, [](double t) {
        return PenSample{.x_mm = 33.0, .y_mm = 33.0, .pressure = std::min(1.0, 2.0 * t)};
    });
    EXPECT_GT(studio::mean_thickness_mm(film, studio::cells_of(film, 32.0, 32.0, 34.0, 34.0)), 0.0);
}

}  // namespace
}  // namespace pastoso::brush
