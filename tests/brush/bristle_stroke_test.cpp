// What strokes of bristle brushes look like, in numbers: the acceptance figures of the brush design.
#include "brush/brush.hpp"
#include "brush/studio.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kPxPerMm = 8.0;

/// A straight stroke of 60 mm to the right along y = 25 on a linen of 100 x 50 mm.
film::FilmState stroke_of(const Preset& preset, double fill, double pressure, double length_mm = 60.0,
                          std::uint32_t seed = 1) {
    film::FilmState film = studio::linen(100.0, 50.0, kPxPerMm);
    Brush brush(preset, 0.0, seed);
    brush.load(studio::dark_paint(), fill);
    studio::paint(brush, film, studio::line(15.0, 25.0, 15.0 + length_mm, 25.0, pressure, 90.0));
    return film;
}

double surface_mm(const film::FilmState& film, int x, int y) {
    return studio::thickness_mm(film, x, y) + film.support_mm.at(x, y);
}

/// Mean thickness of every row between two places along the stroke.
std::vector<double> profile_across(const film::FilmState& film, double x0_mm, double x1_mm) {
    std::vector<double> rows;
    const grid::Rect columns = studio::cells_of(film, x0_mm, 0.0, x1_mm, 0.0);
    for (int y = 0; y < film.shape.height; ++y) {
        rows.push_back(studio::mean_thickness_mm(film, {columns.x0, y, columns.x1, y + 1}));
    }
    return rows;
}

/// Correlation of the surface with itself moved by some cells.
double self_correlation(const film::FilmState& film, const grid::Rect& cells, int dx, int dy) {
    double sx = 0.0, sy = 0.0, sxx = 0.0, syy = 0.0, sxy = 0.0, n = 0.0;
    for (int y = cells.y0; y < cells.y1 - dy; ++y) {
        for (int x = cells.x0; x < cells.x1; ++x) {
            const double a = surface_mm(film, x, y), b = surface_mm(film, x + dx, y + dy);
            sx += a, sy += b, sxx += a * a, syy += b * b, sxy += a * b, n += 1.0;
        }
    }
    return (sxy / n - sx / n * sy / n) /
           std::sqrt((sxx / n - sx / n * sx / n) * (syy / n - sy / n * sy / n));
}

TEST(LoadedFlat, CoversWithoutPinholes) {
    Preset preset = studio::flat_preset(20.0);
    preset.paint.film_mm = 0.3;
    const film::FilmState film = stroke_of(preset, 1.0, 0.4);
    EXPECT_GE(studio::coverage(film, studio::cells_of(film, 30.0, 17.0, 55.0, 33.0)), 0.9999);
}

TEST(LoadedFlat, LeavesRidgesAlongItsEdges) {
    // Clumps at the edges differ from brush to brush: the mean of a few.
    double edge_mm = 0.0, inner_mm = 0.0;
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        Preset preset = studio::flat_preset(20.0);
        preset.paint.film_mm = 0.3;
        const std::vector<double> rows =
            profile_across(stroke_of(preset, 1.0, 0.4, 60.0, seed), 30.0, 55.0);
        const auto wet = [](double h) { return h >= 0.05; };
        const auto first = std::find_if(rows.begin(), rows.end(), wet) - rows.begin();
        const auto last = rows.rend() - std::find_if(rows.rbegin(), rows.rend(), wet) - 1;
        double edge_sum = 0.0, inner_sum = 0.0, edges = 0.0, inners = 0.0;
        for (auto y = first; y <= last; ++y) {
            const double side =
                std::abs(2.0 * static_cast<double>(y - first) / static_cast<double>(last - first) - 1.0);
            if (side > 0.82 && side < 0.96) edge_sum += rows[y], edges += 1.0;
            if (side <= 0.82) inner_sum += rows[y], inners += 1.0;
        }
        edge_mm += edge_sum / edges;
        inner_mm += inner_sum / inners;
    }
    EXPECT_GE(edge_mm / inner_mm, 1.05);
    EXPECT_LE(edge_mm / inner_mm, 1.5);
}

TEST(LoadedFlat, IsStreakedAlongTheStroke) {
    Preset preset = studio::flat_preset(20.0);
    preset.paint.film_mm = 0.3;
    const film::FilmState film = stroke_of(preset, 1.0, 0.4);
    const grid::Rect inner = studio::cells_of(film, 30.0, 17.0, 52.0, 33.0);
    const auto correlation_length = [&](int dx, int dy) {
        int cells = 1;
        while (cells < 160 && self_correlation(film, inner, cells * dx, cells * dy) > 0.5)
            ++cells;
        return cells;
    };
    EXPECT_GE(correlation_length(1, 0), 10 * correlation_length(0, 1));
    double sum = 0.0, squares = 0.0, n = 0.0;
    for (int y = inner.y0; y < inner.y1; ++y) {
        for (int x = inner.x0; x < inner.x1; ++x) {
            const double z = surface_mm(film, x, y);
            sum += z, squares += z * z, n += 1.0;
        }
    }
    EXPECT_GE(std::sqrt(squares / n - sum / n * sum / n), 0.03);
}

TEST(WellFilledFlat, HasNoPinholes) {
    for (const double fill : {0.6, 0.8, 1.0}) {
        const film::FilmState film = stroke_of(studio::flat_preset(20.0), fill, 0.4);
        EXPECT_GE(studio::coverage(film, studio::cells_of(film, 30.0, 18.0, 55.0, 32.0)), 0.999) << fill;
    }
}

TEST(DryBrush, CatchesTheCrownsOfTheWeave) {
    const film::FilmState film = stroke_of(studio::flat_preset(20.0), 0.1, 0.13);
    const grid::Rect cells = studio::cells_of(film, 30.0, 18.0, 55.0, 32.0);
    const double coverage = studio::coverage(film, cells);
    EXPECT_GE(coverage, 0.1);
    EXPECT_LE(coverage, 0.4);
    std::vector<float> heights;
    for (int y = cells.y0; y < cells.y1; ++y) {
        for (int x = cells.x0; x < cells.x1; ++x)
            heights.push_back(film.support_mm.at(x, y));
    }
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::nth_element(heights.begin(), middle, heights.end());
    double covered = 0.0, high = 0.0;
    for (int y = cells.y0; y < cells.y1; ++y) {
        for (int x = cells.x0; x < cells.x1; ++x) {
            if (studio::thickness_mm(film, x, y) <= 0.01) continue;
            covered += 1.0;
            high += film.support_mm.at(x, y) > *middle ? 1.0 : 0.0;
        }
    }
    EXPECT_GE(high / covered, 0.75);
}

TEST(DryBrush, CoversMoreTheMoreItHolds) {
    double last = 0.0;
    for (const double fill : {0.05, 0.1, 0.2, 0.4}) {
        const film::FilmState film = stroke_of(studio::flat_preset(20.0), fill, 0.13);
        const double coverage = studio::coverage(film, studio::cells_of(film, 30.0, 18.0, 55.0, 32.0));
        EXPECT_GT(coverage, 1.2 * last) << fill;
        last = coverage;
    }
    EXPECT_GT(last, 0.7);
}

/// Width of the stroke that a round brush of 10 mm leaves, mean of six brushes: few hairs touch at light
/// pressure.
double round_width_mm(double pressure) {
    double wet_rows = 0.0;
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        const film::FilmState film = stroke_of(studio::round_preset(10.0), 1.0, pressure, 40.0, seed);
        const std::vector<double> rows = profile_across(film, 30.0, 45.0);
        wet_rows += static_cast<double>(
            std::count_if(rows.begin(), rows.end(), [](double h) { return h > 0.01; }));
    }
    return wet_rows / 6.0 / kPxPerMm;
}

TEST(Round, WidensWithPressure) {
    for (const auto& [pressure, width_mm] : {std::pair{0.05, 1.5}, {0.3, 5.2}, {0.9, 10.6}}) {
        EXPECT_NEAR(round_width_mm(pressure), width_mm, 0.15 * width_mm) << "pressure " << pressure;
    }
}

TEST(Run, ThinsAsTheBrushEmpties) {
    film::FilmState film = studio::linen(300.0, 30.0, kPxPerMm);
    Brush brush(studio::flat_preset(12.0, 200));
    brush.load(studio::dark_paint(), 1.0);
    studio::paint(brush, film, studio::line(10.0, 15.0, 290.0, 15.0, 0.4, 90.0));
    std::vector<double> films_mm;
    for (double x = 15.0; x < 270.0; x += 30.0) {
        films_mm.push_back(
            studio::mean_thickness_mm(film, studio::cells_of(film, x, 12.0, x + 5.0, 18.0)));
    }
    EXPECT_TRUE(std::is_sorted(films_mm.rbegin(), films_mm.rend()));
    EXPECT_GE(films_mm[5] / films_mm[0], 0.1);
    EXPECT_LE(films_mm[5] / films_mm[0], 0.4);
}

TEST(OverfilledBrush, LeavesNoHaloOnWetPaint) {
    film::FilmState film = studio::linen(80.0, 40.0, kPxPerMm);
    studio::cover(film, 0.4, studio::light_paint());
    Brush brush(studio::flat_preset(15.0));
    brush.load(studio::dark_paint(), 1.2);
    studio::paint(brush, film, studio::line(10.0, 20.0, 70.0, 20.0, 0.5, 90.0));
    // The bristles reach 7.5 mm (1 + splay) + their own radius to both sides.
    const double reach_mm = 7.5 * 1.22 + 0.3 + brush.tip.radius_mm;
    for (const double side : {-1.0, 1.0}) {
        const int y = static_cast<int>((20.0 + side * (reach_mm + 0.3)) * kPxPerMm);
        for (int x = 15 * 8; x < 65 * 8; ++x) {
            const double dark_per_mm =
                film::optical_thickness(film.paint.at(x, y)[0]) / studio::thickness_mm(film, x, y);
            ASSERT_LT(dark_per_mm, 0.01 * studio::dark_paint()[0]) << x << ", " << y;
        }
    }
}

TEST(DirtyBrush, CarriesColourOn) {
    film::FilmState film = studio::linen(80.0, 30.0, kPxPerMm);
    studio::cover(film, studio::cells_of(film, 0.0, 0.0, 30.0, 30.0), 0.3, studio::light_paint());
    Brush brush(studio::flat_preset(12.0));
    brush.load(studio::dark_paint(), 0.6);
    studio::paint(brush, film, studio::line(10.0, 15.0, 70.0, 15.0, 0.5, 90.0));
    const auto light_share = [&](double x_mm) {
        Contents sum;
        const grid::Rect cells = studio::cells_of(film, x_mm, 12.0, x_mm + 3.0, 18.0);
        for (int y = cells.y0; y < cells.y1; ++y) {
            for (int x = cells.x0; x < cells.x1; ++x) {
                sum.volume_mm3 += studio::thickness_mm(film, x, y);
                sum.paint[6] += film::optical_thickness(film.paint.at(x, y)[6]);
            }
        }
        return (sum.paint[6] / sum.volume_mm3 - studio::dark_paint()[6]) /
               (studio::light_paint()[6] - studio::dark_paint()[6]);
    };
    EXPECT_GT(light_share(34.0), 0.1);  // just beyond the wet paint
    EXPECT_GT(light_share(62.0), 0.1);  // a bristle has one load, mixed as it goes
}

}  // namespace
}  // namespace pastoso::brush
