// Paint on wet paint of another colour: it lies above until it is stirred.
#include "brush/seen_colour.hpp"
#include "brush/studio.hpp"

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

using studio::oil;

/// A flat brush that goes along the middle of a small canvas.
struct Easel {
    film::FilmState film = studio::smooth(36.0, 30.0);
    grid::Rect middle = studio::cells_of(film, 13.0, 12.0, 23.0, 18.0);

    /// White as it lies when nothing has been stirred.
    void lay_white(double thickness_mm) { studio::lay_over(film, thickness_mm, oil("PW6")); }
    /// To and fro, with a brush that is clean at first.
    void brush_over(int passes) {
        for (int pass = 0; pass < passes; ++pass) {
            const bool back = pass % 2 == 1;
            studio::paint(clean, film,
                          studio::line(back ? 30.0 : 6.0, 15.0, back ? 6.0 : 30.0, 15.0, 0.4, 90.0));
        }
    }
    Brush clean{studio::flat_preset(16.0), 16.0, 2};
    pigment::Lab seen() const { return studio::seen_colour(film, middle); }
};

TEST(StrataStroke, WhiteOverWetBlackIsWhiteUntilItIsStirred) {
    Easel bare, easel, mixed;
    bare.lay_white(0.5);
    studio::cover(easel.film, 0.2, oil("PBk9"));
    easel.lay_white(0.5);
    const double white = bare.seen().lightness;
    EXPECT_LT(pigment::ciede2000(easel.seen(), bare.seen()), 4.0);

    mixed.film = easel.film;
    for (int tile = 0; tile < mixed.film.shape.tile_count(); ++tile)
        mixed.film.lower.forget(tile);
    easel.brush_over(5);
    EXPECT_LT(easel.seen().lightness, white - 12.0);
    easel.brush_over(45);
    mixed.brush_over(50);
    EXPECT_LT(pigment::ciede2000(easel.seen(), mixed.seen()), 3.0);
}

TEST(StrataStroke, KeepsAllPaint) {
    Easel easel;
    studio::cover(easel.film, 0.2, oil("PBk9"));
    Brush brush(studio::flat_preset(16.0), 3);
    brush.load(oil("PW6"), 1.0);
    Contents before = brush.contents();
    before += studio::contents(easel.film);
    studio::paint(brush, easel.film, studio::line(6.0, 10.0, 30.0, 21.0, 0.5, 90.0));
    Contents after = brush.contents();
    after += studio::contents(easel.film);
    EXPECT_LT(studio::balance_error(after, before), 1e-12);
    bool any = false;
    for (int y = 0; y < easel.film.shape.height; ++y)
        for (int x = 0; x < easel.film.shape.width; ++x) {
            const film::LowerCell lower{easel.film.lower.thickness.at(x, y),
                                        easel.film.lower.paint.at(x, y)};
            ASSERT_TRUE(film::is_part_of(lower, easel.film.thickness.at(x, y), easel.film.paint.at(x, y)))
                << x << ", " << y;
            any = any || lower.thickness > 0;
        }
    EXPECT_TRUE(any);
}

int cells_of_two_strata(const film::FilmState& film) {
    int cells = 0;
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x)
            cells += film.lower.thickness.at(x, y) > 0 ? 1 : 0;
    return cells;
}

/// Of a stroke over paint that has so much more of every pigment than the stroke's own.
int strata_over(double strength) {
    Easel easel;
    film::PaintCoefficients found = oil("PB29");
    for (int k = 0; k < film::kPigmentChannels; ++k)
        found[k] *= strength;
    studio::cover(easel.film, 0.2, found);
    Brush brush(studio::flat_preset(16.0), 3);
    brush.load(oil("PB29"), 1.0);
    studio::paint(brush, easel.film, studio::line(6.0, 10.0, 30.0, 21.0, 0.5, 90.0));
    return cells_of_two_strata(easel.film);
}

TEST(StrataStroke, PaintOfOneColourStaysOne) {
    for (const double strength : {1.0, 1.12, 1.0 / 1.12})
        EXPECT_EQ(strata_over(strength), 0) << strength;
    for (const double strength : {1.3, 1.0 / 1.3})
        EXPECT_GT(strata_over(strength), 100) << strength;
}

/// Where a stroke frays out, a film of a few roundings is left for the next one to lie on.
TEST(StrataStroke, PaintOfOneColourStaysOneOverAFrayedEdge) {
    film::FilmState film = studio::linen(60.0, 40.0);
    Brush brush(find_preset("Flat bristle 20"));
    for (const double y_mm : {8.0, 19.0, 30.0}) {
        brush.clean();
        brush.load(studio::paint_in("PW6", "linseed oil"), 1.0);
        studio::paint(brush, film, studio::line(5.0, y_mm, 55.0, y_mm, 0.4, 90.0));
    }
    EXPECT_EQ(cells_of_two_strata(film), 0);
}

}  // namespace
}  // namespace pastoso::brush
