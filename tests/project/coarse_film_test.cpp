#include "project/coarse_film.hpp"

#include <gtest/gtest.h>

namespace pastoso::project {
namespace {

TEST(CoarseFilm, IsTheMeanOfTheCellsOnTheCanvas) {
    core::ThreadPool pool(2);
    film::FilmState film({131, 67}, 0.25);
    film.thickness.set(130, 66, 1000);  // alone on the canvas, of the last 2 x 2
    film.thickness.set(0, 0, 400);
    film.thickness.set(1, 1, 800);
    film.support_mm.set(64, 1, 1.0F);
    film.paint.set(2, 0, {4, 8});
    film.strata.optics.set(0, 0, {800});
    const film::FilmState coarse = coarse_film(film, 2, pool);
    EXPECT_EQ(coarse.shape, (grid::Shape{66, 34}));
    EXPECT_EQ(coarse.cell_mm, 0.5);
    EXPECT_EQ(coarse.thickness.at(65, 33), 1000);
    EXPECT_EQ(coarse.thickness.at(0, 0), 300);
    EXPECT_EQ(coarse.support_mm.at(32, 0), 0.25F);
    EXPECT_EQ(coarse.paint.at(1, 0)[1], 2);
    EXPECT_TRUE(coarse.paint.is_background(1));
    EXPECT_EQ(coarse.strata.optics.at(0, 0)[0], 200);
}

TEST(CoarseFilm, TilesWithoutStrataAreClear) {
    core::ThreadPool pool(1);
    film::FilmState film({128, 64}, 0.25);
    auto block = grid::TileBlock<film::StrataOptics>::filled({});
    film.strata.optics.replace(0, block);
    const film::FilmState coarse = coarse_film(film, 2, pool);
    EXPECT_EQ(coarse.strata.optics.at(31, 0), film::StrataOptics{});
    EXPECT_EQ(coarse.strata.optics.at(32, 0), film::kClearStrata);
}

}  // namespace
}  // namespace pastoso::project
