// Where a film ends within a cell, and what its contact line does: it stands between the receding and
// the advancing angle, and moves beyond them as Cox and Voinov have it.
#include "film/face/film_end.hpp"
#include "film/film_bench.hpp"
#include "film/schemes.hpp"
#include "film/validation/laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

using std::numbers::pi;

/// A surface of that slope and bend, in cells, whose contact line has the normal (cos, sin) of an angle
/// and is so far from the middle cell's centre.
struct StraightEnd {
    double angle_deg, line, slope, bend;

    double height(double x, double y) const {
        const double angle = angle_deg * pi / 180;
        const double way = x * std::cos(angle) + y * std::sin(angle) + line;
        return way > 0 ? slope * way - 0.5 * bend * way * way : 0.0;
    }
    /// The mean over a cell.
    float mean(int cell_x, int cell_y) const {
        constexpr int kPoints = 64;
        double sum = 0;
        for (int i = 0; i < kPoints * kPoints; ++i)
            sum += height(cell_x + (i % kPoints + 0.5) / kPoints - 0.5,
                          cell_y + (static_cast<double>(i / kPoints) + 0.5) / kPoints - 0.5);
        return static_cast<float>(sum / (kPoints * kPoints));
    }
};

FilmEnd<float> found(const StraightEnd& film) {
    StepConstants step;
    step.tan_advancing = 0.5F;
    return film_end<float>([&](int x, int y) { return film.mean(x, y); }, step.tan_advancing, step);
}

// From cell means alone the slope at the line, and what part of the cell is covered.
TEST(FilmEnd, FindsAStraightContactLineAtAnyAngle) {
    for (const double angle : {0.0, 90.0, 180.0, 13.0, -31.0, 45.0, 128.0, 225.0})
        for (const double line : {-0.31, -0.1, 0.07, 0.24})
            for (const double bend : {0.0, 0.03}) {
                const StraightEnd film{angle, line, 0.43, bend};
                const FilmEnd<float> end = found(film);
                SCOPED_TRACE(testing::Message()
                             << angle << " degrees, line at " << line << ", bend " << bend);
                // The Sobel filter's normal, where the line cuts cells, is up to 4 degrees off.
                EXPECT_NEAR(end.contact_slope / film.slope, 1.0, 0.04);  // reached 3 %
                EXPECT_LT(end.covered, 1.0F);
                if (std::fmod(angle, 90.0) == 0.0) {
                    EXPECT_NEAR(end.contact_slope / film.slope, 1.0, 2e-3);
                    EXPECT_NEAR(end.covered, 0.5 + line, 2e-3);
                }
            }
}

TEST(FilmEnd, IsTheSameMirroredAndTurned) {
    const StraightEnd film{27.0, 0.12, 0.6, 0.05};
    StepConstants step;
    step.tan_advancing = 0.5F;
    const auto at = [&](int x, int y) { return film.mean(x, y); };
    const FilmEnd<float> end = film_end<float>(at, step.tan_advancing, step);
    const FilmEnd<float> mirrored =
        film_end<float>([&](int x, int y) { return at(-x, y); }, step.tan_advancing, step);
    const FilmEnd<float> turned =
        film_end<float>([&](int x, int y) { return at(y, -x); }, step.tan_advancing, step);
    EXPECT_EQ(mirrored.contact_slope, end.contact_slope);
    EXPECT_EQ(mirrored.depth_y_mm, end.depth_y_mm);
    EXPECT_EQ(turned.contact_slope, end.contact_slope);
    EXPECT_EQ(turned.depth_x_mm, end.depth_y_mm);
    EXPECT_EQ(turned.over_y_mm, end.over_x_mm);
}

TEST(FilmEnd, IsNoneInsideTheFilmNorWhereItIsDry) {
    EXPECT_EQ(found({20.0, 5.0, 0.4, 0.0}).contact_slope, 0.0F);
    EXPECT_EQ(found({20.0, -3.0, 0.4, 0.0}).contact_slope, 0.0F);
}

class ContactLine : public testing::TestWithParam<film::Scheme> {
  protected:
    SolverOptions options() const {
        SolverOptions options;
        options.scheme = GetParam();
        return options;
    }
    /// With mean thicknesses of 4 x 4 points a cell.
    static void fill(Bench& bench, const std::function<double(double, double)>& thickness) {
        bench.fill([&](int x, int y) {
            double sum = 0;
            for (int i = 0; i < 16; ++i)
                sum +=
                    thickness(x + 0.125 + 0.25 * (i % 4), y + 0.125 + 0.25 * static_cast<double>(i / 4));
            return sum / 16;
        });
    }
};

constexpr double kTension = 25000.0;

/// The height of a spherical cap of that volume and contact angle: V = pi h^2 (3 r - h) / 3.
double cap_height(double volume, double angle) {
    const double flat = 1 - std::cos(angle);
    return std::cbrt(3 * volume * flat * flat * flat / (pi * flat * flat * (3 - flat)));
}

struct RestingDrop {
    double start_angle_deg, advancing_deg, receding_deg, rests_deg;
};

TEST_P(ContactLine, ADropRestsAtTheAngleThatItReachesFirst) {
    for (const auto& [start_deg, advancing_deg, receding_deg, rests_deg] :
         {RestingDrop{47, 31, 12, 31}, RestingDrop{15, 52, 28, 28}}) {
        constexpr int kSide = 44;
        Bench bench({.width = kSide,
                     .height = kSide,
                     .viscosity = 60,
                     .tension = kTension,
                     .tan_advancing = std::tan(advancing_deg * pi / 180),
                     .tan_receding = std::tan(receding_deg * pi / 180),
                     .slip_cells = 0.2,
                     .full_curvature = true,
                     .solver = options()});
        const double angle = start_deg * pi / 180, radius = 14.3, sphere = radius / std::sin(angle);
        fill(bench, [&](double x, double y) {
            const double r2 = (x - 22.3) * (x - 22.3) + (y - 21.8) * (y - 21.8);
            return std::max(0.0,
                            std::sqrt(std::max(0.0, sphere * sphere - r2)) - sphere * std::cos(angle));
        });
        bench.pass(4.0);
        const double height = cap_height(bench.volume(), rests_deg * pi / 180);
        EXPECT_NEAR(bench.max_h() / height, 1.0, 0.02) << rests_deg;  // reached 1.5 %
    }
}

// Furmidge: a planar drop runs down where rho F A > sigma (cos theta_R - cos theta_A).
TEST_P(ContactLine, APlanarDropIsHeldByBothItsAngles) {
    for (const auto& [advancing, receding, width] :
         {std::array{0.9, 0.35, 22.0}, std::array{0.9, 0.7, 42.0}, std::array{0.5, 0.17, 22.0}}) {
        const double slope = 0.5 * (advancing + receding), area = slope * width * width / 6;
        const double holds =
            kTension * (std::cos(std::atan(receding)) - std::cos(std::atan(advancing))) / area;
        const auto way = [&](double force) {
            Bench bench({.width = static_cast<int>(2 * width),
                         .height = 1,
                         .force_x = force,
                         .viscosity = 100,
                         .tension = kTension,
                         .tan_advancing = advancing,
                         .tan_receding = receding,
                         .slip_cells = 0.2,
                         .edge_x = Edge::Wall,
                         .full_curvature = true,
                         .solver = options()});
            fill(bench, [&](double x, double) {
                const double part = 2 * (x - 8) / width - 1;
                return std::max(0.0, slope * width / 4 * (1 - part * part));
            });
            const auto rear = [&] {
                int x = 0;
                while (bench.h(x, 0) < 0.05)
                    ++x;
                return x;
            };
            const int start = rear();
            bench.pass(1.2 * width);
            return rear() - start;
        };
        SCOPED_TRACE(testing::Message() << "slopes " << advancing << ", " << receding);
        EXPECT_EQ(way(0.85 * holds), 0);
        EXPECT_GE(way(1.15 * holds), 1);
    }
}

/// How long a strip takes to draw back from one half-width to another, s.
double retraction_s(const validation::RetractingStrip& strip, double from, double to) {
    constexpr int kParts = 10000;
    const double part = (from - to) / kParts;
    double seconds = 0;
    for (int i = 0; i < kParts; ++i)
        seconds += part / strip.retreat_speed(from - (i + 0.5) * part);
    return seconds;
}

TEST_P(ContactLine, AFlatStripDrawsBackInTheTimeOfCoxAndVoinov) {
    constexpr double kSlope = 0.15, kReceding = 0.6, kWidth = 40, kViscosity = 150, kPart = 0.6;
    Bench bench({.width = 60,
                 .height = 1,
                 .viscosity = kViscosity,
                 .tension = kTension,
                 .tan_advancing = 1.0,
                 .tan_receding = kReceding,
                 .slip_cells = 0.2,
                 .edge_x = Edge::Wall,
                 .solver = options()});
    fill(bench, [](double x, double) {
        const double part = 2 * (x - 30.2) / kWidth;
        return std::max(0.0, kSlope * kWidth / 4 * (1 - part * part));
    });
    const double unit = kViscosity * kWidth / kTension;
    double time = 0;
    // Of a parabola, the width is 3/2 of its area over its height.
    while (1.5 * bench.volume() / bench.max_h() > kPart * kWidth && time < 300) {
        bench.pass(0.5 * unit);
        time += 0.5;
    }
    const validation::RetractingStrip strip{.section = kSlope * kWidth * kWidth / 6,
                                            .receding = kReceding,
                                            .tension = kTension,
                                            .viscosity = kViscosity,
                                            .slip = 0.2};
    const double exact = retraction_s(strip, 0.5 * kWidth, 0.5 * kPart * kWidth) / unit;
    EXPECT_GT(time, exact / 1.5);
    EXPECT_LT(time, exact * 1.5);
    bench.pass(100 * unit);
    EXPECT_NEAR(bench.max_h() / (std::sqrt(kSlope * kReceding) * kWidth / 4), 1.0, 0.02);
}

/// Until a flat strip is as narrow as 0.6 of its width, in ticks of 1/60 s.
int ticks_to_draw_back(film::Scheme scheme, double viscosity) {
    constexpr double kSlope = 0.15, kWidth = 40;
    Bench bench({.width = 60,
                 .height = 1,
                 .viscosity = viscosity,
                 .tension = kTension,
                 .tan_advancing = 1.0,
                 .tan_receding = 0.6,
                 .slip_cells = 0.2,
                 .edge_x = Edge::Wall,
                 .inertia = false,
                 .lateral = false,
                 .solver = {.scheme = scheme}});
    bench.fill([](int x, int) {
        const double part = 2 * (x + 0.5 - 30.2) / kWidth;
        return std::max(0.0, kSlope * kWidth / 4 * (1 - part * part));
    });
    int ticks = 0;
    for (; 1.5 * bench.volume() / bench.max_h() > 0.6 * kWidth && ticks < 300; ++ticks)
        bench.pass(1.0 / 60.0);
    return ticks;
}

// An end that goes further than a quarter of a cell in a step has shorter ones. The quicker goes 0.6
// cells a tick.
TEST(QuickContactLine, DrawsBackInLargeStepsAsInExplicitOnes) {
    for (const double viscosity : {20.0, 10.0}) {
        const int exact = ticks_to_draw_back(film::Scheme::Explicit, viscosity);
        const int large = ticks_to_draw_back(film::Scheme::LargeStep, viscosity);
        EXPECT_NEAR(static_cast<double>(large) / exact, 1.0, 0.2) << viscosity;  // reached 17 %
    }
}

// Where paint of a deep valley thins out between two slopes, the parabola through its end bends up from
// the line: a wedge of less than no thickness would push what it should drag.
TEST_P(ContactLine, AnEndThatBendsUpDragsAsAnyOther) {
    constexpr double kThickness[3][5] = {{1.2436, 0.3624, 0.0034, 0.4968, 1.2083},
                                         {1.6213, 0.6902, 0.2507, 0.5094, 1.3582},
                                         {1.7708, 1.2186, 0.9439, 1.1074, 1.5716}};
    constexpr double kSurface[3][5] = {{2.9708, 3.2022, 3.4326, 3.7149, 3.5141},
                                       {3.3485, 3.3938, 3.4716, 3.5449, 3.5931},
                                       {3.4980, 3.5470, 3.5907, 3.6401, 3.6113}};
    const Scene scene{.width = 5,
                      .height = 3,
                      .gravity = 0.4226,
                      .viscosity = 0.02417,
                      .tension = 0.4178,
                      .tan_advancing = 0.2417,
                      .tan_receding = 0.05745,
                      .slip_cells = 0.2,
                      .edge_x = Edge::Open,
                      .edge_y = Edge::Open,
                      .solver = {.scheme = GetParam()}};
    for (int i = 1; i <= 100; ++i) {
        Bench bench(scene);
        bench.set_support([&](int x, int y) { return kSurface[y][x] - kThickness[y][x]; });
        bench.fill([&](int x, int y) { return kThickness[y][x]; });
        const double step_s = 0.002 * i;
        bench.solver->step(step_s);
        // From rest it gains no more than the paint's weight on the support's slope of 0.6 gives.
        EXPECT_LT(std::abs(bench.u(1, 0)), 0.6 * scene.gravity * step_s) << step_s;
    }
}

INSTANTIATE_TEST_SUITE_P(Schemes, ContactLine,
                         testing::Values(film::Scheme::Explicit, film::Scheme::LargeStep),
                         [](const auto& test) {
                             return test.param == film::Scheme::Explicit ? "Explicit" : "LargeStep";
                         });

}  // namespace
}  // namespace pastoso::film::test
