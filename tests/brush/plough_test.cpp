// A fast stroke through thick wet paint drags it along and leaves ridges at its edges.
#include "brush/plough.hpp"

#include "brush/brush.hpp"
#include "brush/studio.hpp"
#include "brush/symmetry.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kGround_mm = 0.5;
constexpr double kMiddle_mm = 25.0;

Preset ploughing_flat(double momentum) {
    Preset preset = studio::flat_preset(16.0, 200);
    preset.exchange.momentum = momentum;
    return preset;
}

/// An empty flat brush pulled at a speed over 60 mm of wet oil.
film::FilmState pulled(const Preset& preset, double speed_mm_s, double px_per_mm = 8.0,
                       double rate_Hz = 500.0) {
    film::FilmState film = studio::linen(100.0, 50.0, px_per_mm);
    studio::cover(film, kGround_mm, studio::dark_paint());
    Brush brush(preset);
    studio::paint(brush, film, studio::line(20.0, kMiddle_mm, 80.0, kMiddle_mm, 0.5, 90.0), rate_Hz,
                  60.0 / speed_mm_s);
    return film;
}

/// Of the row means along the middle of the stroke, as heights above the ground before it.
struct Ridge {
    double height_mm, area_mm2, width_mm;
};
Ridge ridge_of(const film::FilmState& film, double sign) {
    Ridge ridge{};
    for (double off_mm = 0.0; off_mm < 20.0; off_mm += film.cell_mm) {
        const double y_mm = kMiddle_mm + sign * off_mm - (sign < 0.0 ? film.cell_mm : 0.0);
        const double rise_mm = studio::mean_thickness_mm(
                                   film, studio::cells_of(film, 40.0, y_mm, 60.0, y_mm + film.cell_mm)) -
                               kGround_mm;
        if (rise_mm <= 0.001) continue;
        ridge.height_mm = std::max(ridge.height_mm, rise_mm);
        ridge.area_mm2 += rise_mm * film.cell_mm;
        ridge.width_mm += film.cell_mm;
    }
    return ridge;
}

TEST(Plough, PushesMoreTheFasterAndTheMoreMomentum) {
    EXPECT_EQ(pushed_share(0.5, 0.0), 0.0);
    EXPECT_EQ(pushed_share(0.0, 300.0), 0.0);
    EXPECT_NEAR(pushed_share(1.0, 100.0), 1.0 - std::exp(-1.0), 1e-15);
    EXPECT_NEAR(pushed_share(0.5, 200.0), 1.0 - std::exp(-1.0), 1e-15);
}

TEST(Plough, RaisesRidgesThatGrowWithTheSpeed) {
    // Measured on both sides: 0.02, 0.16, 0.37, 0.77 mm high on 0.5 mm of paint.
    const Ridge least[] = {{0.01, 0.005, 0.4}, {0.12, 0.06, 0.6}, {0.3, 0.17, 0.7}, {0.6, 0.4, 0.9}};
    Ridge last{};
    int row = 0;
    for (const double speed_mm_s : {10.0, 60.0, 120.0, 250.0}) {
        const film::FilmState film = pulled(ploughing_flat(0.5), speed_mm_s);
        const Ridge low = ridge_of(film, -1.0), high = ridge_of(film, 1.0);
        const Ridge lower = {std::min(low.height_mm, high.height_mm),
                             std::min(low.area_mm2, high.area_mm2),
                             std::min(low.width_mm, high.width_mm)};
        EXPECT_GT(lower.height_mm, std::max(least[row].height_mm, last.height_mm)) << speed_mm_s;
        EXPECT_GT(lower.area_mm2, std::max(least[row].area_mm2, last.area_mm2)) << speed_mm_s;
        EXPECT_GE(lower.width_mm, std::max(least[row].width_mm, last.width_mm)) << speed_mm_s;
        last = {std::max(low.height_mm, high.height_mm), std::max(low.area_mm2, high.area_mm2),
                std::min(low.width_mm, high.width_mm)};
        ++row;
    }
    // Never steeper than about 45 degrees: a ridge is at least as wide as high.
    EXPECT_LT(last.height_mm, last.width_mm);
}

/// How uneven the paint beside a stroke lies along it: the worst rms of a row of cells, from its mean.
double unevenness_mm(const film::FilmState& film) {
    double worst_mm = 0.0;
    for (double y_mm = kMiddle_mm + 10.0; y_mm < kMiddle_mm + 20.0; y_mm += film.cell_mm) {
        const grid::Rect row = studio::cells_of(film, 40.0, y_mm, 60.0, y_mm + film.cell_mm);
        const double mean_mm = studio::mean_thickness_mm(film, row);
        double squares = 0.0;
        for (int x = row.x0; x < row.x1; ++x)
            squares += std::pow(studio::thickness_mm(film, x, row.y0) - mean_mm, 2.0);
        worst_mm = std::max(worst_mm, std::sqrt(squares / row.width()));
    }
    return worst_mm;
}

TEST(Plough, RaisesRidgesNotBeads) {
    for (const double px_per_mm : {8.0, 16.0}) {
        film::FilmState film = studio::linen(100.0, 50.0, px_per_mm);
        studio::cover(film, 0.25, studio::dark_paint());
        Brush brush(find_preset("Flat bristle 20"));
        studio::paint(brush, film, studio::line(15.0, kMiddle_mm, 75.0, kMiddle_mm, 0.6, 90.0), 250.0,
                      1.2);
        // 0.024 and 0.046 mm from heaps half as wide, of ridges 0.08 mm high.
        EXPECT_LT(unevenness_mm(film), 0.02) << px_per_mm << " px/mm";
    }
}

TEST(Plough, WithoutMomentumNothingIsPushedAtAnySpeed) {
    Preset preset = ploughing_flat(0.0);
    preset.stroke.smoothing_ms = 0.0;  // or a slower hand would be followed more closely
    preset.dynamics.clear();
    const film::FilmState slow = pulled(preset, 30.0), fast = pulled(preset, 480.0, 8.0, 8000.0);
    EXPECT_EQ(ridge_of(fast, 1.0).height_mm, 0.0);
    EXPECT_EQ(ridge_of(fast, -1.0).height_mm, 0.0);
    EXPECT_EQ(film::state_hash(slow), film::state_hash(fast));
}

TEST(Plough, MovesWholeQuantaWithTheirPigment) {
    // What is neither taken up nor swapped is only moved: all that leaves the canvas is what clings.
    Preset preset = ploughing_flat(1.0);
    preset.exchange.pickup = preset.exchange.mix = 0.0;
    film::FilmState film = studio::linen(60.0, 40.0);
    studio::cover(film, studio::cells_of(film, 0.0, 0.0, 60.0, 20.0), 0.6, studio::dark_paint());
    studio::cover(film, studio::cells_of(film, 0.0, 20.0, 60.0, 40.0), 0.4, studio::light_paint());
    Contents before = studio::contents(film);
    Brush brush(preset);
    studio::paint(brush, film, studio::line(10.0, 20.0, 55.0, 22.0, 0.5, 90.0), 500.0, 0.2);
    Contents after = studio::contents(film);
    after += brush.contents();
    EXPECT_GT(ridge_of(pulled(preset, 250.0), 1.0).height_mm, 0.5);
    // Sums of doubles over some 1e5 exchanges; what lies on the canvas is counted in integers.
    EXPECT_LT(studio::balance_error(after, before), 1e-13);
}

TEST(Plough, DoesNotDependOnTheEventRate) {
    for (const double speed_mm_s : {60.0, 250.0}) {
        const film::FilmState rare = pulled(ploughing_flat(0.5), speed_mm_s, 8.0, 125.0);
        const film::FilmState dense = pulled(ploughing_flat(0.5), speed_mm_s, 8.0, 1000.0);
        // The tolerance of all strokes; measured 0.1 and 0.6 %.
        EXPECT_LT(studio::relative_difference(dense, rare, dense.cell_mm), 0.01) << speed_mm_s;
    }
}

TEST(Plough, HardlyDependsOnTheCellSize) {
    const film::FilmState fine = pulled(ploughing_flat(0.5), 250.0, 16.0);
    const film::FilmState coarse = pulled(ploughing_flat(0.5), 250.0, 8.0);
    // Measured 0.2 % in 1-mm blocks (3 % for all strokes), ridges 3 % higher and 0.4 % larger: a cell is
    // an eighth of their width.
    EXPECT_LT(studio::relative_difference(fine, coarse, 1.0), 0.01);
    EXPECT_NEAR(ridge_of(coarse, 1.0).height_mm / ridge_of(fine, 1.0).height_mm, 1.0, 0.06);
    EXPECT_NEAR(ridge_of(coarse, 1.0).area_mm2 / ridge_of(fine, 1.0).area_mm2, 1.0, 0.02);
}

TEST(Plough, MirroredHandLeavesTheMirrorImage) {
    film::FilmState film = studio::smooth(64.0, 40.0);
    studio::cover(film, 0.5, studio::dark_paint());
    film::FilmState reflected = film;
    Brush brush(ploughing_flat(0.8));
    Brush reflection = brush;
    reflection.tip = mirrored(brush.tip);
    const auto sweep = [](double side) {
        return [side](double t) {
            return PenSample{.x_mm = 32.0 + side * (6.0 + 14.0 * t * t),
                             .y_mm = 10.0 + 20.0 * t,
                             .pressure = 0.5 * studio::fade(t),
                             .tilt_x_deg = side * 10.0,
                             .rotation_deg = side * 25.0};
        };
    };
    studio::paint(brush, film, sweep(1.0), 500.0, 0.2);
    studio::paint(reflection, reflected, sweep(-1.0), 500.0, 0.2);
    double difference = 0.0;
    for (int y = 0; y < film.shape.height; ++y) {
        for (int x = 0; x < film.shape.width; ++x) {
            difference += std::abs(studio::thickness_mm(film, x, y) -
                                   studio::thickness_mm(reflected, film.shape.width - 1 - x, y));
        }
    }
    // Places within a footprint are in single precision.
    EXPECT_LT(difference / film.shape.width / film.shape.height / kGround_mm, 1e-6);
}

TEST(Plough, NeverReachesBareGround) {
    // A loaded brush on a dry canvas ploughs nothing out beyond what its bristles touch: no halo.
    film::FilmState film = studio::linen(80.0, 40.0);
    Preset preset = ploughing_flat(1.0);
    preset.flex.splay = 0.0;
    Brush brush(preset);
    brush.load(studio::dark_paint(), 1.0);
    studio::paint(brush, film, studio::line(15.0, 20.0, 65.0, 20.0, 0.5, 90.0), 500.0, 0.15);
    const double reach_mm = 0.5 * preset.tip.width_mm + 0.25 + 2.0 * brush.tip.radius_mm;
    for (const double y_mm : {20.0 - reach_mm - 1.0, 20.0 + reach_mm}) {
        EXPECT_EQ(studio::mean_thickness_mm(film, studio::cells_of(film, 0.0, y_mm, 80.0, y_mm + 1.0)),
                  0.0);
    }
}

}  // namespace
}  // namespace pastoso::brush
