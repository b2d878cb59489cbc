// A moving tip passes momentum to the runny paint below it.
#include "brush/drag.hpp"

#include "brush/brush.hpp"
#include "brush/studio.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kPool_mm = 0.5;

/// Ink of 1e-4 m2/s is light_paint(); dark_paint() is oil of 0.3 m2/s.
film::FilmState pool(const film::PaintCoefficients& paint, double width_mm = 60.0,
                     double height_mm = 40.0) {
    film::FilmState film = studio::smooth(width_mm, height_mm);
    studio::cover(film, kPool_mm, paint);
    return film;
}

Brush dragging_brush(double momentum) {
    Preset preset = studio::flat_preset(16.0, 200);
    preset.exchange.momentum = momentum;
    return Brush(preset);
}

struct Speeds {
    double mean_x = 0.0, mean_y = 0.0, fastest = 0.0;
};
/// Over the faces of the cells given; the fastest of the whole canvas.
Speeds speeds_of(const film::FilmState& film, const grid::Rect& cells) {
    Speeds speeds;
    for (int y = 0; y < film.shape.height; ++y) {
        for (int x = 0; x < film.shape.width; ++x) {
            const double u = film.velocity_x.at(x, y), v = film.velocity_y.at(x, y);
            speeds.fastest = std::max(speeds.fastest, std::hypot(u, v));
            const bool within = x >= cells.x0 && x < cells.x1 && y >= cells.y0 && y < cells.y1;
            if (within) speeds.mean_x += u, speeds.mean_y += v;
        }
    }
    const double count = static_cast<double>(cells.width()) * cells.height();
    speeds.mean_x /= count;
    speeds.mean_y /= count;
    return speeds;
}

TEST(Drag, GivesTheMomentumThatTheRuleSays) {
    // One bristle pressed on a pool: u = 0 before, so that rho h dx^2 sum(u) is what it gave.
    Preset preset = studio::flat_preset(2.0, 4);
    preset.exchange.momentum = 0.7;
    const Brush brush(preset);
    film::FilmState film = pool(studio::light_paint(), 8.0, 8.0);
    const HandPose hand = {.travel_x = 0.6, .travel_y = 0.8, .speed_mm_s = 200.0};
    const double step_mm = 0.2;
    const ResolvedTip tip = resolve(brush.tip, brush.preset.paint, film.cell_mm);
    const StepRates rates = step_rates(brush, tip, hand, step_mm);
    Contact contact;
    contact.x_mm = 4.03, contact.y_mm = 3.98;
    const ExchangeRule rule = exchange_rule(brush, 0, contact, rates);
    CellBatch touched;
    touched.gather(film, contact.x_mm, contact.y_mm, tip.radius_mm);
    PaintDrag drag;
    const DragRates drag_by = drag_rates(brush, tip, hand, step_mm, film.consistencies);
    if (drag.find(rule, drag_by, touched, film)) drag.apply(drag_by, film);

    // chi = 1 in a pool that deep; at a face the mean of both cells within the footprint counts.
    const double share = 0.7 * (1.0 - std::exp(-step_mm / brush.tip.radius_mm)) * tip.share;
    const auto weight = [&](int x, int y) {
        const double dx = (x + 0.5) * film.cell_mm - contact.x_mm;
        const double dy = (y + 0.5) * film.cell_mm - contact.y_mm;
        const double rho2 = (dx * dx + dy * dy) / (tip.radius_mm * tip.radius_mm);
        return std::max(0.0, 1.0 - rho2) * (1.0 + tip.crown * rho2);
    };
    double expected_x = 0.0, expected_y = 0.0, given_x = 0.0, given_y = 0.0;
    for (int y = 0; y + 1 < film.shape.height; ++y) {
        for (int x = 0; x + 1 < film.shape.width; ++x) {
            const double here = weight(x, y), right = weight(x + 1, y), below = weight(x, y + 1);
            if (here > 0.0 && right > 0.0) expected_x += share * 0.5 * (here + right) * 120.0;
            if (here > 0.0 && below > 0.0) expected_y += share * 0.5 * (here + below) * 160.0;
            given_x += film.velocity_x.at(x, y);
            given_y += film.velocity_y.at(x, y);
        }
    }
    EXPECT_GT(expected_x, 0.0);
    EXPECT_NEAR(given_x / expected_x, 1.0, 1e-5);  // single precision
    EXPECT_NEAR(given_y / expected_y, 1.0, 1e-5);
}

TEST(Drag, BeginsWherePaintWouldGoOnForTwoMicrometres) {
    const Brush brush = dragging_brush(1.0);
    const HandPose hand = {.travel_x = 1.0, .travel_y = 0.0, .speed_mm_s = 60.0};
    const film::PaintCoefficients paint = studio::light_paint();
    const double nu_mm2_s =
        std::exp(film::consistency_of(paint).log_viscosity) * film::kThinnest_m2_s * 1e6;
    const double least_mm = std::sqrt(0.002 * 3.0 * nu_mm2_s / 60.0);
    for (const bool several : {false, true}) {
        for (const double part : {0.99, 1.01}) {
            film::FilmState film = pool(paint, 8.0, 8.0);
            studio::cover(film, film.shape.cells(), part * least_mm, paint);
            if (several) film.consistencies = film::Consistencies::several();
            const ResolvedTip tip = resolve(brush.tip, brush.preset.paint, film.cell_mm);
            Contact contact;
            contact.x_mm = contact.y_mm = 4.0;
            CellBatch touched;
            touched.gather(film, contact.x_mm, contact.y_mm, tip.reach_mm);
            PaintDrag drag;
            EXPECT_EQ(drag.find(exchange_rule(brush, 0, contact, step_rates(brush, tip, hand, 0.2)),
                                drag_rates(brush, tip, hand, 0.2, film.consistencies), touched, film),
                      part > 1.0)
                << part << " of the least thickness" << (several ? ", several paints" : "");
        }
    }
}

TEST(Drag, LetsRunnyPaintFollowTheStroke) {
    film::FilmState film = pool(studio::light_paint());
    Brush brush = dragging_brush(0.5);
    studio::paint(
        brush, film,
        [](double t) {
            return PenSample{
                .x_mm = 10.0 + 30.0 * t, .y_mm = 20.0, .pressure = 0.5, .rotation_deg = 90.0};
        },
        1000.0, 0.15);  // 200 mm/s, and the pen is lifted in full travel
    // The bristles trail 4 to 8 mm behind the pen.
    const Speeds below = speeds_of(film, studio::cells_of(film, 31.0, 15.0, 34.0, 25.0));
    EXPECT_GT(below.mean_x, 0.75 * 200.0);  // measured 165: several bristles pass over every face
    EXPECT_LT(std::abs(below.mean_y), 0.01 * below.mean_x);
}

TEST(Drag, NeverMakesPaintFasterThanTheTip) {
    film::FilmState film = pool(studio::light_paint());
    Brush brush = dragging_brush(1.0);
    studio::paint(brush, film, studio::line(10.0, 12.0, 50.0, 28.0, 0.6, 70.0), 1000.0, 0.2);
    const double tip_mm_s = std::hypot(40.0, 16.0) / 0.2;
    const Speeds all = speeds_of(film, film.shape.cells());
    EXPECT_GT(all.fastest, 0.5 * tip_mm_s);
    // Both components of one cell lie on different faces; the smoothed curve of the hand is a straight
    // line at constant speed, but for the catching up at its end.
    EXPECT_LE(all.fastest, 1.02 * tip_mm_s);
}

TEST(Drag, WithoutMomentumNothingMoves) {
    film::FilmState film = pool(studio::light_paint());
    Brush brush = dragging_brush(0.0);
    studio::paint(brush, film, studio::line(10.0, 20.0, 50.0, 20.0, 0.6, 90.0), 500.0, 0.1);
    EXPECT_EQ(speeds_of(film, film.shape.cells()).fastest, 0.0);
}

TEST(Drag, LeavesStiffPaintAtRest) {
    // Oil of 0.3 m2/s would stop after 400 mm/s (0.5 mm)^2 / (3 0.3 m2/s) = 0.1 um.
    film::FilmState film = pool(studio::dark_paint());
    Brush brush = dragging_brush(1.0);
    studio::paint(brush, film, studio::line(10.0, 20.0, 50.0, 20.0, 0.6, 90.0), 500.0, 0.1);
    EXPECT_EQ(speeds_of(film, film.shape.cells()).fastest, 0.0);
}

TEST(Drag, TellsInkFromOilOnOneCanvas) {
    film::FilmState film = pool(studio::dark_paint());
    film.consistencies = film::Consistencies::several();
    studio::cover(film, studio::cells_of(film, 0.0, 20.0, 60.0, 40.0), kPool_mm, studio::light_paint());
    Brush brush = dragging_brush(0.8);
    brush.preset.exchange.mix = brush.preset.exchange.pickup = 0.0;
    studio::paint(
        brush, film,
        [](double t) {
            return PenSample{
                .x_mm = 10.0 + 30.0 * t, .y_mm = 20.0, .pressure = 0.5, .rotation_deg = 90.0};
        },
        1000.0, 0.15);
    EXPECT_GT(speeds_of(film, studio::cells_of(film, 31.0, 23.0, 34.0, 27.0)).mean_x, 150.0);
    EXPECT_EQ(speeds_of(film, studio::cells_of(film, 31.0, 13.0, 34.0, 16.0)).mean_x, 0.0);
}

}  // namespace
}  // namespace pastoso::brush
