// A painter's knife on wet paint, with the hand's own curves: flat and light it lays a clean ribbon,
// pressed or tilted it scrapes to the ground, between it drags one paint into the other.

#include "brush/seen_colour.hpp"
#include "brush/studio.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

using studio::oil;

constexpr double kPxPerMm = 8.0, kGround_mm = 0.25;

struct Hold {
    double pressure = 0.2, tilt_deg = 0.0, angle_deg = 0.0, fill = 1.0;
    double px_per_mm = kPxPerMm;
};

/// One stroke of a palette knife, 45 mm long through the middle of wet ultramarine on linen.
film::FilmState knifed(const Hold& hold, const char* pigment = "PW6") {
    film::FilmState film = studio::linen(70.0, 70.0, hold.px_per_mm);
    studio::cover(film, kGround_mm, oil("PB29"));
    Brush knife(find_preset("Palette knife 17"), 0.0, 7);
    if (hold.fill > 0.0) knife.load(oil(pigment), hold.fill);
    const double along = hold.angle_deg * 3.14159265358979 / 180.0;
    studio::paint(knife, film, [&](double t) {
        return PenSample{.x_mm = 35.0 + 45.0 * (t - 0.5) * std::cos(along),
                         .y_mm = 35.0 + 45.0 * (t - 0.5) * std::sin(along),
                         .pressure = hold.pressure * studio::fade(t),
                         .tilt_x_deg = hold.tilt_deg,
                         .rotation_deg = hold.angle_deg + 90.0};
    });
    return film;
}

/// Inside of every ribbon, whatever its direction.
grid::Rect inside(const film::FilmState& film) {
    return studio::cells_of(film, 30.0, 30.0, 40.0, 40.0);
}

pigment::Lab masstone(const char* pigment) {
    film::FilmState film = studio::smooth(2.0, 2.0);
    studio::cover(film, 3.0, oil(pigment));
    return studio::seen_colour(film, {0, 0, 4, 4});
}

/// Share of the cells that look like the paint.
double share_of(const film::FilmState& film, const char* pigment) {
    const pigment::Lab wanted = masstone(pigment);
    const grid::Rect cells = inside(film);
    int alike = 0;
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x)
            if (pigment::ciede2000(pigment::lab(studio::seen_rgb(film, x, y)), wanted) < 5.0) ++alike;
    return static_cast<double>(alike) / (cells.width() * cells.height());
}

TEST(KnifePaint, FlatAndLightItLaysAnOpaqueRibbonOfItsOwnColour) {
    for (const double px_per_mm : {4.0, 8.0, 16.0})
        for (const double angle_deg : {0.0, 33.0, 61.0})
            for (const double pressure : {0.15, 0.35}) {
                const film::FilmState film =
                    knifed({.pressure = pressure, .angle_deg = angle_deg, .px_per_mm = px_per_mm});
                EXPECT_GT(share_of(film, "PW6"), 0.8)
                    << px_per_mm << " px/mm, " << angle_deg << " degrees, pressure " << pressure;
                const double laid_mm = studio::mean_thickness_mm(film, inside(film)) - kGround_mm;
                EXPECT_GT(laid_mm, 0.5);
                EXPECT_LT(laid_mm, 2.0);
            }
}

TEST(KnifePaint, PressedOrTiltedItScrapesToTheGround) {
    EXPECT_LT(studio::mean_thickness_mm(knifed({.pressure = 0.9, .fill = 0.0}),
                                        studio::cells_of(knifed({}), 30.0, 30.0, 40.0, 40.0)),
              0.1);
    EXPECT_LT(studio::mean_thickness_mm(knifed({.tilt_deg = 60.0, .fill = 0.0}),
                                        studio::cells_of(knifed({}), 30.0, 30.0, 40.0, 40.0)),
              0.15);
    EXPECT_LT(share_of(knifed({.pressure = 0.9}), "PW6"), 0.05);
    EXPECT_LT(share_of(knifed({.tilt_deg = 60.0}), "PW6"), 0.05);
}

TEST(KnifePaint, AnEmptyBladeHeldFlatLeavesWhatLiesThere) {
    const film::FilmState film = knifed({.fill = 0.0});
    EXPECT_NEAR(studio::mean_thickness_mm(film, inside(film)), kGround_mm, 0.05);
}

TEST(KnifePaint, ItGetsDarkerAndDarkerTheHarderItIsPressed) {
    const film::FilmState lightest = knifed({.pressure = 0.15});
    const double clean = studio::seen_colour(lightest, inside(lightest)).lightness;
    double before = clean;
    for (const double pressure : {0.35, 0.5, 0.6, 0.7, 0.9}) {
        const film::FilmState film = knifed({.pressure = pressure});
        const double lightness = studio::seen_colour(film, inside(film)).lightness;
        EXPECT_LT(lightness, before + 0.5) << pressure;
        before = lightness;
    }
    EXPECT_LT(before, clean - 15.0);
}

/// Root mean square of the difference of what is seen from its mean, along lines of one direction.
double unevenness(const film::FilmState& film, bool across) {
    const grid::Rect cells = inside(film);
    std::vector<double> means;
    for (int i = 0; i < cells.width(); ++i) {
        const grid::Rect line = across ? grid::Rect{cells.x0, cells.y0 + i, cells.x1, cells.y0 + i + 1}
                                       : grid::Rect{cells.x0 + i, cells.y0, cells.x0 + i + 1, cells.y1};
        means.push_back(studio::seen_colour(film, line).lightness);
    }
    double mean = 0.0, square = 0.0;
    for (const double value : means)
        mean += value / static_cast<double>(means.size());
    for (const double value : means)
        square += (value - mean) * (value - mean) / static_cast<double>(means.size());
    return std::sqrt(square);
}

TEST(KnifePaint, BetweenItDragsOnePaintIntoTheOtherInStreaks) {
    const film::FilmState film = knifed({.pressure = 0.6});
    EXPECT_GT(unevenness(film, true), 1.0);
    EXPECT_GT(unevenness(film, true), 1.5 * unevenness(film, false));
}

/// Wet white with ridges of an earlier stroke across the knife's way, and a wet glaze of ultramarine on
/// it.
film::FilmState glazed() {
    constexpr double kRidges_mm = 0.15, kGlaze_mm = 0.12, kSpacing_mm = 7.0;
    film::FilmState film = studio::linen(70.0, 70.0, kPxPerMm);
    for (int x = 0; x < film.shape.width; ++x) {
        const double wave = std::sin(2.0 * core::kPi * x * film.cell_mm / kSpacing_mm);
        studio::cover(film, {x, 0, x + 1, film.shape.height},
                      kGround_mm + kRidges_mm * std::max(0.0, wave), oil("PW6"));
    }
    studio::lay_over(film, kGlaze_mm, studio::paint_in("PB29", "alkyd gel"));
    return film;
}

/// An empty knife drawn over that.
film::FilmState drawn_over_glaze(double pressure, std::uint32_t piece = 7) {
    film::FilmState film = glazed();
    Brush knife(find_preset("Palette knife 17"), 0.0, piece);
    studio::paint(knife, film, studio::line(12.0, 35.0, 58.0, 35.0, pressure, 90.0));
    return film;
}

TEST(KnifePaint, ABladeOverAGlazeRidesDragsItOrTakesIt) {
    const film::FilmState before = glazed();
    const pigment::Lab glaze = studio::seen_colour(before, inside(before));
    const auto change = [&](double pressure) {
        const film::FilmState film = drawn_over_glaze(pressure);
        return pigment::ciede2000(studio::seen_colour(film, inside(film)), glaze);
    };
    EXPECT_LT(change(0.2), 6.0);
    EXPECT_GT(change(0.6), change(0.2));
    EXPECT_GT(change(0.9), change(0.6));
}

TEST(KnifePaint, ABladeOverAGlazeDragsItInStreaks) {
    // Where stripes ride is chance: the mean of a few pieces.
    double across = 0.0, along = 0.0;
    for (std::uint32_t piece = 1; piece <= 6; ++piece) {
        const film::FilmState film = drawn_over_glaze(0.6, piece);
        across += unevenness(film, true) / 6.0;
        along += unevenness(film, false) / 6.0;
    }
    EXPECT_GT(across, 3.0);
    EXPECT_GT(across, 2.0 * along);
}

TEST(KnifePaint, AThirdPaintLiesCleanOverTwo) {
    film::FilmState film = knifed({.pressure = 0.2});
    Brush knife(find_preset("Diamond knife 9"), 0.0, 3);
    knife.load(oil("PR108"), 1.0);
    studio::paint(knife, film, studio::line(35.0, 15.0, 35.0, 55.0, 0.2, 0.0));
    const grid::Rect crossing = studio::cells_of(film, 33.0, 32.0, 37.0, 38.0);
    EXPECT_LT(pigment::ciede2000(studio::seen_colour(film, crossing), masstone("PR108")), 5.0);
}

struct Blade {
    const char* preset;
    double width_mm;
};

/// One light stroke of a full blade, 40 mm long, on a panel.
film::FilmState ribbon_of(const Blade& blade, double px_per_mm) {
    film::FilmState film = studio::smooth(60.0, 20.0, px_per_mm);
    Brush knife(find_preset(blade.preset), blade.width_mm, 7);
    knife.load(oil("PW6"), 1.0);
    studio::paint(knife, film, studio::line(10.0, 10.0, 50.0, 10.0, 0.2, 90.0));
    return film;
}

TEST(KnifePaint, ASmallBladeLaysAThinFlatRibbon) {
    for (const Blade& blade : {Blade{"Palette knife 17", 1.0},
                               {"Palette knife 17", 2.0},
                               {"Palette knife 17", 3.0},
                               {"Diamond knife 9", 2.0}})
        for (const double px_per_mm : {8.0, 16.0}) {
            SCOPED_TRACE(testing::Message()
                         << blade.preset << ", " << blade.width_mm << " mm, " << px_per_mm << " px/mm");
            const film::FilmState film = ribbon_of(blade, px_per_mm);
            const double half_mm = 0.5 * blade.width_mm;
            const double inside_mm = studio::mean_thickness_mm(
                film, studio::cells_of(film, 20.0, 10.0 - 0.6 * half_mm, 40.0, 10.0 + 0.6 * half_mm));
            EXPECT_GT(inside_mm, 0.4 * blade.width_mm / 8.0);
            EXPECT_LT(inside_mm, blade.width_mm / 8.0);
            EXPECT_LT(studio::highest_mm(film, studio::cells_of(film, 20.0, 0.0, 40.0, 20.0)),
                      1.5 * blade.width_mm / 8.0)
                << "thrown up along its edges";
            EXPECT_LT(studio::highest_mm(film, film.shape.cells()), 0.3 * blade.width_mm)
                << "where it lifts";
            const double beyond_mm = half_mm + 0.25;
            EXPECT_EQ(
                studio::highest_mm(film, studio::cells_of(film, 20.0, 10.0 + beyond_mm, 40.0, 20.0)),
                0.0);
            EXPECT_EQ(
                studio::highest_mm(film, studio::cells_of(film, 20.0, 0.0, 40.0, 10.0 - beyond_mm)),
                0.0);
        }
}

TEST(KnifePaint, ItsEdgesAreThrownUpUnevenly) {
    const film::FilmState film = knifed({.pressure = 0.2});
    std::vector<double> ridges_mm;
    for (double x_mm = 20.0; x_mm < 50.0; x_mm += 1.0) {
        double highest_mm = 0.0;
        for (double y_mm = 26.0; y_mm < 28.0; y_mm += 0.125)
            highest_mm = std::max(highest_mm,
                                  studio::thickness_mm(film, static_cast<int>(x_mm * kPxPerMm),
                                                       static_cast<int>(y_mm * kPxPerMm)));
        ridges_mm.push_back(highest_mm);
    }
    const auto [lowest, highest] = std::minmax_element(ridges_mm.begin(), ridges_mm.end());
    EXPECT_GT(*highest - *lowest, 0.15);
}

}  // namespace
}  // namespace pastoso::brush
