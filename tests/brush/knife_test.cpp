#include "brush/brush.hpp"
#include "brush/studio.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kPxPerMm = 8.0;

/// A blade that holds little and always scrapes.
Preset knife_preset(double width_mm, int elements) {
    Preset preset = studio::linear(find_preset("knife"));
    preset.tip.width_mm = preset.tip.length_mm = width_mm;
    preset.tip.bristles = elements;
    preset.flex.ride = 0.0;
    preset.paint.film_mm = 0.04;
    preset.paint.run_mm = 250.0;
    return preset;
}

TEST(Knife, ScrapesWetPaintIntoSideRidges) {
    film::FilmState film = studio::linen(100.0, 50.0, kPxPerMm);
    studio::cover(film, 0.5, studio::dark_paint());
    const Contents before = studio::contents(film);
    Brush knife(knife_preset(20.0, 80));
    studio::paint(knife, film, studio::line(20.0, 25.0, 70.0, 25.0, 0.6, 90.0));
    EXPECT_LE(studio::mean_thickness_mm(film, studio::cells_of(film, 35.0, 17.0, 60.0, 33.0)), 0.2);
    double ridge_mm = 0.0;
    for (int y = 0; y < film.shape.height; ++y) {
        for (int x = 0; x < film.shape.width; ++x)
            ridge_mm = std::max(ridge_mm, studio::thickness_mm(film, x, y));
    }
    EXPECT_GE(ridge_mm, 1.0);
    EXPECT_LE(ridge_mm, 4.0);
    for (const double y_mm : {13.5, 35.5}) {  // on both sides
        EXPECT_GT(studio::mean_thickness_mm(film, studio::cells_of(film, 45.0, y_mm, 60.0, y_mm + 1.0)),
                  0.8);
    }
    Contents after = knife.contents();
    after += studio::contents(film);
    EXPECT_LT(studio::balance_error(after, before), 1e-12);
}

TEST(Knife, SpreadsAnEvenFilmThatEndsInARidge) {
    film::FilmState film = studio::linen(80.0, 40.0, kPxPerMm);
    Brush knife(studio::linear(find_preset("knife")));
    knife.load(studio::dark_paint(), 1.0);
    studio::paint(knife, film, [](double t) {
        return PenSample{.x_mm = 15.0 + 40.0 * t, .y_mm = 20.0, .pressure = 0.5, .rotation_deg = 90.0};
    });
    EXPECT_GT(studio::coverage(film, studio::cells_of(film, 20.0, 13.0, 50.0, 27.0)), 0.85);
    EXPECT_GT(studio::mean_thickness_mm(film, studio::cells_of(film, 54.5, 13.0, 55.5, 27.0)),
              1.2 * studio::mean_thickness_mm(film, studio::cells_of(film, 30.0, 13.0, 50.0, 27.0)));
    EXPECT_EQ(studio::mean_thickness_mm(film, studio::cells_of(film, 58.0, 0.0, 80.0, 40.0)), 0.0);
}

TEST(Knife, LeavesNoStripesOfItsElements) {
    Preset even = knife_preset(17.0, 70);
    even.paint.streak = even.paint.hair = even.paint.gather = 0.0;
    for (const double px_per_mm : {4.0, 8.0, 16.0}) {
        SCOPED_TRACE(px_per_mm);
        film::FilmState film = studio::smooth(60.0, 30.0, px_per_mm);
        Brush knife(even);
        knife.load(studio::dark_paint(), 1.0);
        studio::paint(knife, film, studio::line(15.0, 15.0, 45.0, 15.0, 0.2, 90.0));
        const grid::Rect inner = studio::cells_of(film, 30.0, 10.0, 35.0, 20.0);
        double least_mm = 1.0, most_mm = 0.0;
        for (int y = inner.y0; y < inner.y1; ++y) {
            const double mean_mm = studio::mean_thickness_mm(film, {inner.x0, y, inner.x1, y + 1});
            least_mm = std::min(least_mm, mean_mm), most_mm = std::max(most_mm, mean_mm);
        }
        EXPECT_GT(least_mm, 0.02);
        EXPECT_LT(most_mm - least_mm, 0.0005 * most_mm);
    }
}

TEST(Knife, KeepsColourBoundariesCrisp) {
    film::FilmState film = studio::linen(100.0, 50.0, kPxPerMm);
    studio::cover(film, studio::cells_of(film, 0.0, 0.0, 100.0, 25.0), 0.5, studio::dark_paint());
    studio::cover(film, studio::cells_of(film, 0.0, 25.0, 100.0, 50.0), 0.5, studio::light_paint());
    Brush knife(knife_preset(20.0, 80));
    studio::paint(knife, film, studio::line(20.0, 25.0, 70.0, 25.0, 0.6, 90.0));
    const auto light_share = [&](double y_mm) {
        const int x = 60 * 8, y = static_cast<int>(y_mm * kPxPerMm);
        const double per_mm =
            film::optical_thickness(film.paint.at(x, y)[6]) / studio::thickness_mm(film, x, y);
        return (per_mm - studio::dark_paint()[6]) / (studio::light_paint()[6] - studio::dark_paint()[6]);
    };
    // After 40 mm of scraping along the boundary it is still less than a millimetre wide.
    EXPECT_LT(light_share(24.5), 0.1);
    EXPECT_GT(light_share(25.5), 0.9);
}

TEST(Knife, HeldAslantPushesPaintToItsTrailingEnd) {
    film::FilmState film = studio::linen(100.0, 60.0, kPxPerMm);
    studio::cover(film, 0.5, studio::dark_paint());
    Brush knife(knife_preset(20.0, 80));
    // The edge runs from upper left to lower right: its upper end trails.
    studio::paint(knife, film, studio::line(25.0, 30.0, 75.0, 30.0, 0.6, 60.0));
    const double upper_mm =
        studio::mean_thickness_mm(film, studio::cells_of(film, 55.0, 18.0, 65.0, 21.5));
    const double lower_mm =
        studio::mean_thickness_mm(film, studio::cells_of(film, 55.0, 38.5, 65.0, 42.0));
    EXPECT_GT(upper_mm, 1.3 * lower_mm);
}

}  // namespace
}  // namespace pastoso::brush
