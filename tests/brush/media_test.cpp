// Tools take media from a film of several and lay them, each with its own paint.
#include "brush/seen_colour.hpp"
#include "brush/stroke.hpp"
#include "brush/studio.hpp"
#include "film/medium.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

using studio::oil;

film::FilmNumbers numbers(double tension_N_m) {
    film::Medium medium = film::find_medium("heavy-body oil");
    medium.surface_tension_N_m = tension_N_m;
    return film::film_numbers_of(medium);
}
const film::FilmNumbers kLying = numbers(0.03), kLaid = numbers(0.04), kSeldom = numbers(0.05);

film::FilmState wet_film() {
    film::FilmState film = studio::smooth(60.0, 30.0);
    film.media.numbers = {kLying};
    studio::cover(film, studio::cells_of(film, 0.0, 0.0, 45.0, 30.0), 0.3, oil("PBk9"));
    return film;
}

Brush loaded(const Preset& preset, const film::FilmNumbers& medium, double fill = 1.0) {
    Brush brush(preset, 0.0, 3);
    brush.load({.first = oil("PW6"), .medium = medium}, fill);
    return brush;
}

/// Of a medium in the whole film, mm3; checks that no cell holds more than its paint.
double volume_of(const film::FilmState& film, const film::FilmNumbers& medium) {
    const auto& list = film.media.numbers;
    const auto place = std::find(list.begin(), list.end(), medium) - list.begin();
    std::int64_t sum = 0;
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x) {
            const film::MediaCell amounts =
                film::media_in(film, film.shape.tile_at(x, y), grid::Shape::cell_in_tile(x, y));
            EXPECT_EQ(std::accumulate(amounts.begin(), amounts.end(), std::int64_t{0}),
                      film.thickness.at(x, y));
            sum += amounts[static_cast<std::size_t>(place)];
        }
    return film::volume_mm3(sum, film.cell_mm);
}

double held(const Brush& brush, const film::FilmNumbers& medium) {
    for (std::size_t k = 0; k < brush.media.numbers.size(); ++k)
        if (brush.media.numbers[k] == medium) return brush.media.volume_mm3[k];
    return 0.0;
}

const studio::Movement kAcross = studio::line(8.0, 9.0, 54.0, 21.0, 0.6, 60.0);

TEST(BrushMedia, AreKeptInSumByEveryTool) {
    for (const char* name : {"Flat bristle 20", "Round bristle 12", "Palette knife 17", "Comb 25",
                             "Dropper", "Fan 26", "Impasto flat 18"}) {
        film::FilmState film = wet_film();
        const Preset* preset = &find_preset(name);
        Brush brush = loaded(*preset, kLaid);
        const double lying = volume_of(film, kLying), in_brush = brush.contents().volume_mm3;
        studio::paint(brush, film, kAcross);
        const double all_lying = volume_of(film, kLying) + held(brush, kLying);
        const double all_laid = volume_of(film, kLaid) + held(brush, kLaid);
        EXPECT_NEAR(all_lying, lying, 0.01 * in_brush) << name;
        EXPECT_NEAR(all_laid, in_brush, 0.01 * in_brush) << name;
        EXPECT_GT(volume_of(film, kLaid), 0.01 * in_brush) << name;
    }
}

TEST(BrushMedia, ASprayCanKeepsThemAsTimePasses) {
    film::FilmState film = wet_film();
    Brush can = loaded(find_preset("Spray can 35"), kLaid);
    const double lying = volume_of(film, kLying), in_can = can.contents().volume_mm3;
    Stroke stroke(can, film);
    stroke.begin(kAcross(0.5));
    for (int tick = 0; tick < 30; ++tick)
        stroke.pass_time(1.0 / 60.0);
    stroke.end();
    const double sprayed = in_can - can.contents().volume_mm3;
    EXPECT_GT(sprayed, 1.0);
    EXPECT_NEAR(volume_of(film, kLaid), sprayed, 0.01 * sprayed);
    EXPECT_NEAR(volume_of(film, kLying), lying, 0.01 * sprayed);
    EXPECT_EQ(held(can, kLying), 0.0);
}

TEST(BrushMedia, FreshPaintOnBareCanvasIsOfItsOwnMedium) {
    film::FilmState film = wet_film();
    Brush brush = loaded(studio::flat_preset(8.0), kLaid);
    studio::paint(brush, film, studio::line(52.0, 5.0, 52.0, 25.0, 0.6, 0.0));
    const int x = static_cast<int>(52.0 / film.cell_mm), y = film.shape.height / 2;
    const int tile = film.shape.tile_at(x, y), cell = grid::Shape::cell_in_tile(x, y);
    ASSERT_GT(film.thickness.at(x, y), 0);
    EXPECT_NEAR(film::mixed_number(film, tile, cell, &film::FilmNumbers::surface_tension_N_m), 0.04,
                1e-6);
    EXPECT_NEAR(film::mixed_number(film, 0, 5, &film::FilmNumbers::surface_tension_N_m), 0.03, 1e-9);
}

TEST(BrushMedia, ACleanBrushCarriesWhatItPicksUp) {
    film::FilmState film = wet_film();
    Brush brush(find_preset("Flat bristle 20"), 0.0, 3);
    ASSERT_GE(film::add_medium(film, kSeldom), 0);
    studio::paint(brush, film, kAcross);
    ASSERT_GT(brush.contents().volume_mm3, 0.1);
    EXPECT_NEAR(held(brush, kLying), brush.contents().volume_mm3, 1e-6);
}

TEST(BrushMedia, AreTheSameOnAnyNumberOfThreads) {
    const auto painted = [](core::ThreadPool* pool) {
        film::FilmState film = wet_film();
        Brush brush = loaded(find_preset("Flat bristle 20"), kLaid);
        Stroke stroke(brush, film, {}, {}, nullptr, pool);
        studio::paint(stroke, kAcross, 100.0);
        EXPECT_TRUE(film.media.are_several());
        return film::state_hash(film);
    };
    core::ThreadPool three(3);
    EXPECT_EQ(painted(nullptr), painted(&three));
}

TEST(BrushMedia, PaintIsTheSameWhetherTheMediaDifferOrNot) {
    film::FilmState film = wet_film(), other = wet_film();
    Brush brush = loaded(find_preset("Flat bristle 20"), kLaid),
          same = loaded(find_preset("Flat bristle 20"), kLying);
    studio::paint(brush, film, kAcross);
    studio::paint(same, other, kAcross);
    EXPECT_FALSE(other.media.are_several());
    film.media = other.media;
    EXPECT_EQ(film::state_hash(film), film::state_hash(other));
    EXPECT_EQ(brush.contents(), same.contents());
}

TEST(BrushMedia, ALoadOfAnotherMediumJoinsWhatIsHeld) {
    Brush brush = loaded(studio::flat_preset(12.0), kLying, 0.5);
    const double first_mm3 = brush.contents().volume_mm3;
    brush.load({.first = oil("PW6"), .medium = kLaid}, 1.0);
    EXPECT_NEAR(held(brush, kLying), first_mm3, 1e-9);
    EXPECT_NEAR(held(brush, kLaid), brush.contents().volume_mm3 - first_mm3, 1e-9);
    brush.clean(0.5);
    EXPECT_NEAR(held(brush, kLying), 0.5 * first_mm3, 1e-9);
}

}  // namespace
}  // namespace pastoso::brush
