#include "project/coarse_film.hpp"

#include <gtest/gtest.h>

namespace pastoso::project {
namespace {

constexpr pigment::Bands kBare = {0.9F, 0.9F, 0.9F, 0.9F, 0.9F, 0.9F};

TEST(CoarseFilm, IsTheMeanOfTheCellsOnTheCanvas) {
    core::ThreadPool pool(2);
    film::FilmState film({131, 67}, 0.25);
    film.thickness.set(130, 66, 1000);  // alone on the canvas, of the last 2 x 2
    film.thickness.set(0, 0, 400);
    film.thickness.set(1, 1, 800);
    film.support_mm.set(64, 1, 1.0F);
    film.paint.set(2, 0, {4, 8});
    film.strata.ground.set(0, 0, {0.5F, 0.9F, 0.9F, 0.9F, 0.9F, 0.9F});
    const film::FilmState coarse = coarse_film(film, 2, kBare, pool);
    EXPECT_EQ(coarse.shape, (grid::Shape{66, 34}));
    EXPECT_EQ(coarse.cell_mm, 0.5);
    EXPECT_EQ(coarse.thickness.at(65, 33), 1000);
    EXPECT_EQ(coarse.thickness.at(0, 0), 300);
    EXPECT_EQ(coarse.support_mm.at(32, 0), 0.25F);
    EXPECT_EQ(coarse.paint.at(1, 0)[1], 2);
    EXPECT_TRUE(coarse.paint.is_background(1));
}

TEST(CoarseFilm, GroundThatIsBackgroundCountsAsBare) {
    core::ThreadPool pool(1);
    film::FilmState film({128, 64}, 0.25);
    auto block = grid::TileBlock<pigment::Bands>::filled({});
    film.strata.ground.replace(0, block);
    const film::FilmState coarse = coarse_film(film, 2, kBare, pool);
    EXPECT_EQ(coarse.strata.ground.at(31, 0)[0], 0.0F);
    EXPECT_EQ(coarse.strata.ground.at(32, 0)[0], 0.9F);
}

}  // namespace
}  // namespace pastoso::project
