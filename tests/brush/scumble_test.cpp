// A nearly dry brush over dry relief leaves its colour on the crowns, all along a stroke; over wet paint
// it drags a broken veil, and leaves what lies there.

#include "brush/seen_colour.hpp"
#include "brush/studio.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

struct Scumble {
    double angle_deg, px_per_mm;
    friend std::ostream& operator<<(std::ostream& out, const Scumble& scumble) {
        return out << scumble.angle_deg << " degrees at " << scumble.px_per_mm << " px/mm";
    }
};

/// Of dried strokes in several directions, on a ground that rises and falls by as much over the whole
/// canvas: mm.
double relief_mm(double x_mm, double y_mm) {
    const double ridges = std::sin(3.1 * x_mm + 0.9 * y_mm) + std::sin(1.3 * x_mm - 2.6 * y_mm + 1.0) +
                          std::sin(0.4 * x_mm + 4.4 * y_mm + 2.0);
    return 0.6 + 0.1 * ridges + 0.25 * std::sin(0.08 * x_mm + 0.05 * y_mm);
}

/// The relief without its great forms: the ridges alone.
double ridges_mm(double x_mm, double y_mm) {
    return relief_mm(x_mm, y_mm) - 0.25 * std::sin(0.08 * x_mm + 0.05 * y_mm);
}

constexpr double kStart_mm = 18.0, kLength_mm = 60.0, kHalfWidth_mm = 3.0;

/// One stroke of a scumbler where the test's strokes go.
void scumble_over(film::FilmState& film, const Scumble& scumble, const film::PaintCoefficients& paint,
                  double fill, double pressure) {
    Brush brush(find_preset("Dry scumbler 22"), 0.0, 5);
    brush.load(paint, fill);
    const double angle = core::radians(scumble.angle_deg);
    studio::paint(brush, film, [&](double t) {
        return PenSample{.x_mm = kStart_mm + kLength_mm * t * std::cos(angle),
                         .y_mm = kStart_mm + kLength_mm * t * std::sin(angle),
                         .pressure = pressure * studio::fade(t),
                         .rotation_deg = scumble.angle_deg + 90.0};
    });
}

film::FilmState scumbled(const Scumble& scumble) {
    film::FilmState film = studio::smooth(100.0, 100.0, scumble.px_per_mm);
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x)
            film.support_mm.set(
                x, y, static_cast<float>(relief_mm((x + 0.5) * film.cell_mm, (y + 0.5) * film.cell_mm)));
    scumble_over(film, scumble, studio::light_paint(), 0.4, 0.25);
    return film;
}

/// Shares of the cells of a piece of the stroke that are painted: of those in the upper third of the
/// ridges, and of those in the lower.
struct Cover {
    double crowns, hollows;
};

Cover cover_of(const film::FilmState& film, const Scumble& scumble, double from_mm, double to_mm) {
    constexpr double kPainted_mm = 0.002;
    struct Cell {
        double ridge_mm;
        bool painted;
    };
    std::vector<Cell> cells;
    const double angle = core::radians(scumble.angle_deg);
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x) {
            const double x_mm = (x + 0.5) * film.cell_mm, y_mm = (y + 0.5) * film.cell_mm;
            const double along_mm =
                (x_mm - kStart_mm) * std::cos(angle) + (y_mm - kStart_mm) * std::sin(angle);
            const double across_mm =
                (y_mm - kStart_mm) * std::cos(angle) - (x_mm - kStart_mm) * std::sin(angle);
            if (along_mm < from_mm || along_mm > to_mm || std::abs(across_mm) > kHalfWidth_mm) continue;
            cells.push_back({ridges_mm(x_mm, y_mm), studio::thickness_mm(film, x, y) > kPainted_mm});
        }
    std::sort(cells.begin(), cells.end(),
              [](const Cell& a, const Cell& b) { return a.ridge_mm < b.ridge_mm; });
    const auto third = static_cast<std::ptrdiff_t>(cells.size() / 3);
    const auto is_painted = [](const Cell& cell) { return cell.painted; };
    const auto lower = std::count_if(cells.begin(), cells.begin() + third, is_painted);
    const auto upper = std::count_if(cells.end() - third, cells.end(), is_painted);
    return {static_cast<double>(upper) / static_cast<double>(third),
            static_cast<double>(lower) / static_cast<double>(third)};
}

class ScumbleTest : public ::testing::TestWithParam<Scumble> {};

TEST_P(ScumbleTest, IsOnTheCrownsAllAlongTheStroke) {
    const film::FilmState film = scumbled(GetParam());
    for (double from_mm = 6.0; from_mm < 54.0; from_mm += 12.0) {
        const Cover cover = cover_of(film, GetParam(), from_mm, from_mm + 12.0);
        EXPECT_GT(cover.crowns, 0.15) << from_mm << " mm";
        EXPECT_GE(cover.crowns, 3.0 * cover.hollows) << from_mm << " mm";
    }
}

constexpr double kWet_mm = 0.25;

/// White scumbled over wet ultramarine on linen.
film::FilmState scumbled_wet(const Scumble& scumble, double pressure) {
    film::FilmState film = studio::linen(100.0, 100.0, scumble.px_per_mm);
    studio::cover(film, kWet_mm, studio::oil("PB29"));
    scumble_over(film, scumble, studio::oil("PW6"), 0.2, pressure);
    return film;
}

/// What the cells along the middle of a stroke show of it.
struct Veil {
    double thickness_mm = 0.0, covered = 0.0, lightness = 0.0;
};
Veil veil_of(const film::FilmState& film, const Scumble& scumble) {
    constexpr double kSeen_mm = 0.002;
    const double angle = core::radians(scumble.angle_deg);
    Veil veil;
    double count = 0.0;
    for (double along_mm = 15.0; along_mm < 45.0; along_mm += film.cell_mm)
        for (double across_mm = -kHalfWidth_mm; across_mm < kHalfWidth_mm; across_mm += film.cell_mm) {
            const int x = static_cast<int>(
                (kStart_mm + along_mm * std::cos(angle) - across_mm * std::sin(angle)) / film.cell_mm);
            const int y = static_cast<int>(
                (kStart_mm + along_mm * std::sin(angle) + across_mm * std::cos(angle)) / film.cell_mm);
            const double lower_mm = film::thickness_mm(film.lower.thickness.at(x, y));
            const double whole_mm = studio::thickness_mm(film, x, y);
            veil.thickness_mm += whole_mm;
            veil.covered += lower_mm > 0.0 && whole_mm - lower_mm > kSeen_mm ? 1.0 : 0.0;
            veil.lightness += pigment::lab(studio::seen_rgb(film, x, y)).lightness;
            count += 1.0;
        }
    return {veil.thickness_mm / count, veil.covered / count, veil.lightness / count};
}

TEST_P(ScumbleTest, DragsABrokenVeilOverWetPaint) {
    const film::FilmState film = scumbled_wet(GetParam(), 0.25);
    const Veil veil = veil_of(film, GetParam());
    EXPECT_GT(veil.thickness_mm, 0.95 * kWet_mm);
    EXPECT_GT(veil.covered, 0.4);
    EXPECT_LT(veil.covered, 0.97);
    EXPECT_GT(veil.lightness, 35.0) << "of wet ultramarine: 11";
    // A little rough; the beads along its sides were twice as high.
    EXPECT_LT(studio::highest_mm(film, film.shape.cells()), kWet_mm + 0.07);
}

TEST_P(ScumbleTest, FurrowsWetPaintSoftlyWhenPressed) {
    const film::FilmState film = scumbled_wet(GetParam(), 0.8);
    const Veil veil = veil_of(film, GetParam());
    EXPECT_GT(veil.thickness_mm, 0.5 * kWet_mm);
    EXPECT_LT(veil.thickness_mm, 0.9 * kWet_mm);
    EXPECT_LT(studio::highest_mm(film, film.shape.cells()), kWet_mm + 0.16);
}

INSTANTIATE_TEST_SUITE_P(Directions, ScumbleTest,
                         ::testing::Values(Scumble{0.0, 8.0}, Scumble{33.0, 8.0}, Scumble{71.0, 8.0},
                                           Scumble{33.0, 4.0}, Scumble{0.0, 16.0}));

}  // namespace
}  // namespace pastoso::brush
