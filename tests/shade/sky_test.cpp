#include "shade/sky.hpp"

#include "canvas.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace pastoso::shade {
namespace {

std::vector<float> shares(const film::FilmState& film) {
    std::vector<float> result(static_cast<std::size_t>(film.shape.width) * film.shape.height);
    sky_shares(film, film.shape.cells(), result.data(), film.shape.width);
    return result;
}

TEST(SkyShares, ALevelCanvasSeesAllOfTheSky) {
    film::FilmState film(grid::Shape{30, 20}, 0.25);
    test::set_support(film, [](int, int) { return 0.4; });
    for (const float share : shares(film))
        EXPECT_EQ(share, 1.0F);
}

TEST(SkyShares, ATiltedPlaneSeesWhatItsTiltLeaves) {
    for (const double slope : {0.2, 0.5, 1.0}) {
        film::FilmState film(grid::Shape{41, 41}, 0.25);
        test::set_support(film, [slope](int x, int y) { return slope * 0.25 * (0.6 * x + 0.8 * y); });
        const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
        // Eight directions stand for all.
        EXPECT_NEAR(shares(film)[20 * 41 + 20], 0.5 * (1.0 + cosine), 0.005) << slope;
    }
}

TEST(SkyShares, APitSeesLessThanItsRim) {
    film::FilmState film(grid::Shape{41, 41}, 0.25);
    test::set_support(film, [](int x, int y) { return std::hypot(x - 20, y - 20) < 3 ? 0.0 : 1.0; });
    const std::vector<float> sky = shares(film);
    // The wall is first met at 1 mm along the axes and at 1.41 mm along the diagonals.
    EXPECT_NEAR(sky[20 * 41 + 20], 0.5 * (1.0 / (1.0 + 1.0) + 1.0 / (1.0 + 0.5)), 1e-6);
    EXPECT_EQ(sky[20 * 41 + 30], 1.0F);
}

TEST(SkyShares, HaveTheSymmetryOfTheRelief) {
    const film::FilmState film = test::random_canvas({50, 40}, 9);
    const std::vector<float> sky = shares(film), reflected = shares(test::mirrored(film));
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 50; ++x) {
            // The eight directions are added in another order.
            EXPECT_NEAR(sky[y * 50 + x], reflected[y * 50 + 49 - x], 1e-6F);
        }
    }
}

}  // namespace
}  // namespace pastoso::shade
