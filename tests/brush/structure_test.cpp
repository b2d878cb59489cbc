// Tools work the thixotropic paint that they touch, and no other.
#include "brush/seen_colour.hpp"
#include "brush/stroke.hpp"
#include "brush/studio.hpp"

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

using studio::oil;

struct Easel {
    explicit Easel(bool followed) {
        studio::cover(film, 0.3, oil("PBk9"));
        film.worked.is_followed = followed;
        before = film;
        Brush brush(studio::flat_preset(12.0), 3);
        brush.load(oil("PW6"), 1.0);
        studio::paint(brush, film, studio::line(12.0, 9.0, 48.0, 21.0, 0.6, 60.0));
    }
    film::FilmState film = studio::smooth(60.0, 30.0), before;
};

TEST(StructureStroke, WorksWhatItTouches) {
    const Easel easel(true);
    int touched = 0;
    for (int y = 0; y < easel.film.shape.height; ++y)
        for (int x = 0; x < easel.film.shape.width; ++x) {
            const std::int32_t worked = easel.film.worked.thickness.at(x, y);
            const bool changed = easel.film.paint.at(x, y) != easel.before.paint.at(x, y);
            ASSERT_TRUE(worked == 0 || worked == easel.film.thickness.at(x, y)) << x << ", " << y;
            ASSERT_TRUE(!changed || worked > 0) << x << ", " << y;
            touched += worked > 0 ? 1 : 0;
        }
    EXPECT_GT(touched, 7000);  // 36 mm by 3 at least, at 8 cells a millimetre
    EXPECT_EQ(easel.film.worked.thickness.at(1, 1), 0);
}

TEST(StructureStroke, IsTheSamePaintWhetherItIsFollowedOrNot) {
    const Easel followed(true);
    Easel other(false);
    EXPECT_FALSE(other.film.worked.is_anywhere());
    other.film.worked = followed.film.worked;
    EXPECT_EQ(film::state_hash(other.film), film::state_hash(followed.film));
}

TEST(StructureStroke, StaysWithinASelection) {
    film::FilmState film = studio::smooth(60.0, 30.0);
    film.worked.is_followed = true;
    const grid::Mask chosen = grid::polygon_mask(film.shape, {{100, 0}, {300, 0}, {240, 240}});
    Brush brush(studio::flat_preset(12.0), 3);
    brush.load(oil("PW6"), 1.0);
    Stroke stroke(brush, film, {}, {}, &chosen);
    studio::paint(stroke, studio::line(6.0, 15.0, 54.0, 15.0, 0.6, 90.0), 100.0);
    EXPECT_TRUE(film.worked.is_anywhere());
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x)
            ASSERT_TRUE(chosen.at(x, y) != 0 || film.worked.thickness.at(x, y) == 0) << x << ", " << y;
}

}  // namespace
}  // namespace pastoso::brush
