#include "document/history.hpp"

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

constexpr std::size_t kTileBytes = sizeof(std::int32_t) * grid::kTileCells;

/// A moment told by the thickness of one cell; every call writes the same single tile of 4 x 4.
Moment moment_of(film::FilmState& film, std::int32_t value) {
    film.thickness.set(0, 0, value);
    Moment moment;
    moment.film = film;
    return moment;
}

std::int32_t value_of(const Moment& moment) {
    return moment.film.thickness.at(0, 0);
}

film::FilmState empty_film() {
    return film::FilmState({256, 256}, 0.25);
}

TEST(History, GoesBackAndForth) {
    film::FilmState film = empty_film();
    History history;
    EXPECT_FALSE(history.can_undo());
    history.remember(moment_of(film, 1));
    history.remember(moment_of(film, 2));
    EXPECT_EQ(value_of(history.step_back(moment_of(film, 3))), 2);
    EXPECT_EQ(value_of(history.step_back(moment_of(film, 2))), 1);
    EXPECT_FALSE(history.can_undo());
    EXPECT_EQ(value_of(history.step_forward(moment_of(film, 1))), 2);
    EXPECT_EQ(value_of(history.step_forward(moment_of(film, 2))), 3);
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(value_of(history.step_back(moment_of(film, 3))), 2);
}

TEST(History, ANewChangeForgetsWhatWasUndone) {
    film::FilmState film = empty_film();
    History history;
    history.remember(moment_of(film, 1));
    history.step_back(moment_of(film, 2));
    history.remember(moment_of(film, 1));
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.moments(), 1U);
}

TEST(History, CountsOnlyTilesThatAreNotShared) {
    film::FilmState older = empty_film();
    older.thickness.set(0, 0, 1);
    older.thickness.set(100, 0, 1);
    older.velocity_x.set(0, 0, 1.0F);
    film::FilmState newer = older;
    EXPECT_EQ(unshared_bytes(older, newer), 0U);
    newer.thickness.set(0, 0, 2);
    newer.thickness.set(200, 200, 2);
    newer.velocity_x.set(1, 0, 2.0F);
    EXPECT_EQ(unshared_bytes(older, newer), 2 * kTileBytes);
}

TEST(History, DropsTheOldestBeyondTheBudget) {
    film::FilmState film = empty_film();
    History history;
    history.set_budget(3 * kTileBytes);
    for (int value = 1; value <= 10; ++value)
        history.remember(moment_of(film, value));
    // The newest moment is free, three older ones fit.
    EXPECT_EQ(history.moments(), 4U);
    EXPECT_EQ(value_of(history.step_back(moment_of(film, 11))), 10);
    EXPECT_EQ(value_of(history.step_back(moment_of(film, 11))), 9);
    EXPECT_EQ(value_of(history.step_back(moment_of(film, 11))), 8);
    EXPECT_EQ(value_of(history.step_back(moment_of(film, 11))), 7);
    EXPECT_FALSE(history.can_undo());
}

TEST(History, KeepsAtLeastThirtyStrokesOfACommonCanvas) {
    // 200 x 150 mm at 4 px/mm, every stroke touching a tenth of the tiles in all fields.
    film::FilmState film({800, 600}, 0.25);
    History history;
    for (int stroke = 0; stroke < 40; ++stroke) {
        for (int tile = 0; tile < film.shape.tile_count() / 10; ++tile) {
            film.thickness.write(tile)[0] = stroke + 1;
            film.paint.write(tile)[0][0] = stroke + 1;
            film.velocity_x.write(tile)[0] = 1.0F;
            film.velocity_y.write(tile)[0] = 1.0F;
        }
        Moment moment;
        moment.film = film;
        history.remember(moment);
    }
    EXPECT_GE(history.moments(), 30U);
}

TEST(History, ABudgetOfZeroKeepsNothing) {
    film::FilmState film = empty_film();
    History history;
    history.remember(moment_of(film, 1));
    history.set_budget(0);
    EXPECT_FALSE(history.can_undo());
    history.remember(moment_of(film, 2));
    EXPECT_FALSE(history.can_undo());
}

}  // namespace
}  // namespace pastoso::document
