// Soft hairs in a light hand are carried by wet paint: they lay their own on top, drag a little of it
// along and leave most where it lies. Pressed, they go through to the ground.

#include "brush/seen_colour.hpp"
#include "brush/studio.hpp"
#include "core/units.hpp"

#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kGround_mm = 0.25;

struct Skim {
    double angle_deg = 0.0, px_per_mm = 8.0;
    friend std::ostream& operator<<(std::ostream& out, const Skim& skim) {
        return out << skim.angle_deg << " degrees at " << skim.px_per_mm << " px/mm";
    }
};

struct Skimmed {
    film::FilmState film;
    double taken_mm3;  ///< held in the end, beyond what it held at first
};

/// One stroke of a glazing flat, 45 mm long through the middle of wet white in linseed oil on linen.
Skimmed skimmed(double pressure, double fill, const Skim& skim = {}) {
    Skimmed result{studio::linen(70.0, 70.0, skim.px_per_mm), 0.0};
    studio::cover(result.film, kGround_mm, studio::paint_in("PW6", "linseed oil"));
    Brush brush(find_preset("Soft glazing flat 16"), 0.0, 3);
    if (fill > 0.0) brush.load(studio::paint_in("PB29", "alkyd gel"), fill);
    const double before_mm3 = brush.contents().volume_mm3;
    const double angle = core::radians(skim.angle_deg);
    studio::paint(brush, result.film, [&](double t) {
        return PenSample{.x_mm = 35.0 + 45.0 * (t - 0.5) * std::cos(angle),
                         .y_mm = 35.0 + 45.0 * (t - 0.5) * std::sin(angle),
                         .pressure = pressure * studio::fade(t),
                         .rotation_deg = skim.angle_deg + 90.0};
    });
    result.taken_mm3 = brush.contents().volume_mm3 - before_mm3;
    return result;
}

/// Inside of every stroke, whatever its direction.
grid::Rect inside(const film::FilmState& film) {
    return studio::cells_of(film, 31.0, 31.0, 39.0, 39.0);
}

double left_mm(const film::FilmState& film) {
    return studio::mean_thickness_mm(film, inside(film));
}

/// Of what lay there, below the glaze.
double buried_mm(const film::FilmState& film) {
    double sum_mm = 0.0;
    const grid::Rect cells = inside(film);
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x)
            sum_mm += film::thickness_mm(film.lower.thickness.at(x, y));
    return sum_mm / (cells.width() * cells.height());
}

class SkimTest : public ::testing::TestWithParam<Skim> {};

TEST_P(SkimTest, ALightHandLeavesWetPaintWhereItLies) {
    EXPECT_GT(left_mm(skimmed(0.25, 0.0, GetParam()).film), 0.9 * kGround_mm);
    const film::FilmState glazed = skimmed(0.25, 1.0, GetParam()).film;
    EXPECT_GT(left_mm(glazed), 1.2 * kGround_mm) << "with a glaze on top";
    EXPECT_GT(buried_mm(glazed), 0.75 * kGround_mm);
}

INSTANTIATE_TEST_SUITE_P(Directions, SkimTest,
                         ::testing::Values(Skim{0.0, 8.0}, Skim{33.0, 8.0}, Skim{61.0, 8.0},
                                           Skim{33.0, 4.0}, Skim{33.0, 16.0}));

TEST(Skim, DragsALittleAlong) {
    const Skimmed clean = skimmed(0.25, 0.0);
    EXPECT_GT(clean.taken_mm3, 0.5);
    EXPECT_LT(left_mm(clean.film), 0.995 * kGround_mm);
}

TEST(Skim, GoesDeeperTheHarderItIsPressed) {
    double before_mm = kGround_mm;
    for (const double pressure : {0.25, 0.4, 0.6, 0.9}) {
        const double left = left_mm(skimmed(pressure, 0.0).film);
        EXPECT_LT(left, before_mm) << pressure;
        before_mm = left;
    }
    EXPECT_LT(before_mm, 0.4 * kGround_mm);
}

/// Those that draw lines on wet paint.
TEST(Skim, OfSablesAndRiggersLeavesMostOfThePaint) {
    for (const char* preset : {"Round sable 9", "Detail round 3", "Rigger 2"}) {
        film::FilmState film = studio::linen(70.0, 30.0);
        studio::cover(film, kGround_mm, studio::paint_in("PW6", "linseed oil"));
        Brush brush(find_preset(preset), 0.0, 3);
        studio::paint(brush, film, studio::line(12.0, 15.0, 58.0, 15.0, 0.25, 90.0));
        const grid::Rect line = studio::cells_of(film, 25.0, 14.75, 45.0, 15.25);
        EXPECT_GT(studio::mean_thickness_mm(film, line), 0.6 * kGround_mm) << preset;
    }
}

TEST(Skim, IsNoneWhereNothingIsWet) {
    const auto on_dry_ground = [](double ride) {
        film::FilmState film = studio::linen(60.0, 30.0);
        Preset preset = find_preset("Soft glazing flat 16");
        preset.flex.ride = ride;
        Brush brush(preset, 0.0, 3);
        brush.load(studio::dark_paint(), 0.5);
        studio::paint(brush, film, studio::line(15.0, 15.0, 45.0, 15.0, 0.3, 90.0));
        return film::state_hash(film);
    };
    EXPECT_EQ(on_dry_ground(1.0), on_dry_ground(0.0));
}

}  // namespace
}  // namespace pastoso::brush
