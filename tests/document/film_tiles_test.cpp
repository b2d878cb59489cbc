#include "document/film_tiles.hpp"

#include "core/random.hpp"
#include "film/support/support.hpp"

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

constexpr grid::Shape kShape{200, 130};
constexpr std::size_t kWordTile_bytes = sizeof(std::int32_t) * grid::kTileCells;

std::int32_t noise(int tile, int cell, int salt) {
    return static_cast<std::int32_t>(
               core::scramble(static_cast<std::uint32_t>(cell + 4096 * (tile + 100 * salt)))) &
           0xffff;
}

/// Fills a tile of every field with numbers that are like nothing else.
void fill_tile(film::FilmState& film, int tile, int salt) {
    for (int cell = 0; cell < grid::kTileCells; ++cell) {
        const std::int32_t number = noise(tile, cell, salt);
        film.thickness.write(tile)[cell] = number;
        film.paint.write(tile)[cell].fill(number / 3);
        film.lower.thickness.write(tile)[cell] = number / 2;
        film.lower.paint.write(tile)[cell].fill(number / 9);
        film.worked.thickness.write(tile)[cell] = number / 4;
        film.media.foreign.write(tile)[cell].fill(number / 20);
        film.velocity_x.write(tile)[cell] = static_cast<float>(number);
        film.velocity_y.write(tile)[cell] = -static_cast<float>(number);
        film.support_mm.write(tile)[cell] = static_cast<float>(number) * 0x1p-20F;
        film.strata.soluble_thickness.write(tile)[cell] = number / 5;
        film.strata.soluble_pigment.write(tile)[cell].fill(number / 7);
        film.strata.optics.write(tile)[cell].fill(static_cast<std::uint16_t>(number));
        film.strata.uppermost.write(tile)[cell] = {};
    }
}

/// Two films of which one came of the other: tiles that appeared, changed, went and stayed.
struct TwoFilms {
    TwoFilms() : older(kShape, 0.25) {
        older.media.numbers.resize(2);
        core::ThreadPool pool(1);
        older.support_mm = film::named_support("linen", kShape, 0.25, 0.0, pool);
        fill_tile(older, 1, 1);
        fill_tile(older, 2, 1);
        fill_tile(older, 3, 1);
        older.strata.evaporated = 7;
        newer = older;
        fill_tile(newer, 1, 2);
        fill_tile(newer, 5, 2);
        newer.thickness.reset(2);
        newer.paint.reset(2);
        newer.strata.evaporated = 9;
        newer.strata.fixed.thickness = 4;
        newer.consistencies.add(film::Consistency{5.0F, 3.0F});
        newer.media.numbers.resize(3);
        newer.media.own[1] = 2;
    }
    film::FilmState older, newer;
};

TEST(FilmTiles, AreNoneWhereAllIsShared) {
    const TwoFilms films;
    EXPECT_EQ(FilmTiles(films.older, films.older).bytes(), 0U);
    // Tiles that neither film has ever written are the same, whoever made the films.
    EXPECT_EQ(FilmTiles(film::FilmState(kShape, 0.25), film::FilmState(kShape, 0.25)).bytes(), 0U);
}

TEST(FilmTiles, CountOnlyWhatTheOlderFilmHoldsAlone) {
    film::FilmState older(kShape, 0.25);
    older.thickness.set(0, 0, 1);
    older.thickness.set(100, 0, 1);
    older.velocity_x.set(0, 0, 1.0F);
    film::FilmState newer = older;
    newer.thickness.set(0, 0, 2);
    newer.thickness.set(190, 100, 2);
    newer.velocity_x.set(1, 0, 2.0F);
    EXPECT_EQ(FilmTiles(older, newer).bytes(), 2 * kWordTile_bytes);
}

TEST(FilmTiles, GiveTheOlderFilmBack) {
    const TwoFilms films;
    film::FilmState film = films.newer;
    FilmTiles(films.older, films.newer).put_into(film);
    EXPECT_EQ(film::state_hash(film), film::state_hash(films.older));
    EXPECT_TRUE(film.thickness.is_background(5));
    EXPECT_TRUE(film.support_mm.shares_tile(films.older.support_mm, 5));
    EXPECT_NE(film::state_hash(film), film::state_hash(films.newer));
}

TEST(PackedFilmTiles, GiveTheOlderFilmBack) {
    const TwoFilms films;
    const FilmTiles tiles(films.older, films.newer);
    const PackedFilmTiles packed(tiles, films.older);
    film::FilmState film = films.newer;
    packed.put_into(film);
    EXPECT_EQ(film::state_hash(film), film::state_hash(films.older));
    EXPECT_EQ(film.consistencies, films.older.consistencies);
    EXPECT_TRUE(film.thickness.is_background(5));
    EXPECT_TRUE(film.support_mm.shares_tile(films.older.support_mm, 5)) << "the bare support's own tile";
    EXPECT_LT(packed.bytes(), tiles.bytes() / 2);
}

TEST(PackedFilmTiles, CountTheSameHoweverHeightsAreKept) {
    film::FilmState levels(kShape, 0.25), floats(kShape, 0.25);
    core::ThreadPool pool(1);
    levels.support_mm = film::named_support("panel", kShape, 0.25, 0.0, pool);
    for (int tile = 0; tile < kShape.tile_count(); ++tile)
        floats.support_mm.replace(tile, film::copied_heights(levels.support_mm.read(tile)));
    const film::FilmState bare(kShape, 0.25);
    const FilmTiles in_levels(levels, bare), in_floats(floats, bare);
    EXPECT_EQ(in_levels.bytes(), in_floats.bytes());
    EXPECT_EQ(PackedFilmTiles(in_levels, levels).bytes(), PackedFilmTiles(in_floats, floats).bytes());
}

}  // namespace
}  // namespace pastoso::document
