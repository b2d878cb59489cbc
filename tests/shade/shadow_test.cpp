#include "shade/shadow.hpp"

#include "canvas.hpp"
#include "core/units.hpp"
#include "grid/bspline.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::shade {
namespace {

std::vector<float> shadows(const film::FilmState& film, const grid::Rect& cells, double azimuth_deg,
                           double elevation_deg) {
    Lighting lighting;
    lighting.azimuth_deg = azimuth_deg;
    lighting.elevation_deg = elevation_deg;
    std::vector<float> result(static_cast<std::size_t>(cells.width()) * cells.height());
    shadow_heights(film, cells, lighting, surface_range(film), result.data(), cells.width());
    return result;
}

/// What a ray of light drops over a step of cells.
float drop_mm(double azimuth_deg, double elevation_deg) {
    const double x = std::abs(std::cos(core::radians(azimuth_deg)));
    const double y = std::abs(std::sin(core::radians(azimuth_deg)));
    return static_cast<float>(0.25 / std::max(x, y) * std::tan(core::radians(elevation_deg)));
}

TEST(ShadowHeights, OfALevelCanvasAreAStepOfLightBelowIt) {
    film::FilmState film(grid::Shape{20, 20}, 0.25);
    test::set_support(film, [](int, int) { return 0.3; });
    for (const float height : shadows(film, film.shape.cells(), 123.0, 20.0))
        EXPECT_FLOAT_EQ(height, 0.3F - drop_mm(123.0, 20.0));
}

/// A wall 1 mm high across the canvas, the light behind it.
struct WallCase {
    double azimuth_deg;
    int step_x, step_y;  ///< away from the light
};

class Wall : public testing::TestWithParam<WallCase> {};

TEST_P(Wall, ThrowsAShadowThatFallsWithTheLightsSlope) {
    const auto [azimuth_deg, step_x, step_y] = GetParam();
    film::FilmState film(grid::Shape{81, 81}, 0.25);
    test::set_support(film, [step_x = step_x, step_y = step_y](int x, int y) {
        return (x - 40) * step_x + (y - 40) * step_y == 0 ? 1.0 : 0.0;
    });
    const std::vector<float> heights = shadows(film, film.shape.cells(), azimuth_deg, 30.0);
    const double distance_mm = 0.25 * std::hypot(step_x, step_y);
    for (int i = 1; i <= 20; ++i) {
        const double expected = 1.0 - i * distance_mm * std::tan(core::radians(30.0));
        // Single precision.
        const float lit_mm = -drop_mm(azimuth_deg, 30.0);
        EXPECT_NEAR(heights[(40 + i * step_y) * 81 + 40 + i * step_x],
                    std::max(expected, double{lit_mm}), 1e-6)
            << i;
        EXPECT_FLOAT_EQ(heights[(40 - i * step_y) * 81 + 40 - i * step_x], lit_mm)
            << "towards the light";
    }
}

INSTANTIATE_TEST_SUITE_P(FromEverySide, Wall,
                         testing::Values(WallCase{0, -1, 0}, WallCase{45, -1, 1}, WallCase{90, 0, 1},
                                         WallCase{135, 1, 1}, WallCase{180, 1, 0}, WallCase{225, 1, -1},
                                         WallCase{270, 0, -1}, WallCase{315, -1, -1}));

TEST(ShadowHeights, OfAWallAcrossAnObliqueLightAreExactToo) {
    film::FilmState film(grid::Shape{60, 60}, 0.25);
    test::set_support(film, [](int x, int) { return x == 20 ? 1.0 : 0.0; });
    const std::vector<float> heights = shadows(film, film.shape.cells(), 180.0 - 25.0, 30.0);
    const double drop_mm = 0.25 / std::cos(core::radians(25.0)) * std::tan(core::radians(30.0));
    for (int i = 1; i <= 6; ++i)
        EXPECT_NEAR(heights[30 * 60 + 20 + i], 1.0 - i * drop_mm, 1e-6);
}

TEST(ShadowHeights, TellBetweenTheCellsWhereAShadowEnds) {
    film::FilmState film(grid::Shape{60, 9}, 0.25);
    test::set_support(film, [](int x, int) { return x < 20 ? 1.0 : 0.0; });
    const std::vector<float> heights = shadows(film, film.shape.cells(), 180.0, 30.0);
    const float* row = heights.data() + 4 * 60;
    // The last cell of the wall has its middle at 19.5: its light comes down 1 mm / 0.144 mm = 6.93
    // cells on.
    const double end = 19.5 + 1.0 / (0.25 * std::tan(core::radians(30.0)));
    const auto spline = [&](double x) {
        const int cell = static_cast<int>(x - 0.5);
        const auto weights = grid::bspline_weights(static_cast<float>(x - 0.5 - cell));
        double sum = 0.0;
        for (int k = 0; k < 4; ++k)
            sum += weights.value[k] * row[cell - 1 + k];
        return sum;
    };
    EXPECT_GT(spline(end - 0.1), 0.0);
    EXPECT_LT(spline(end + 0.1), 0.0);
}

TEST(ShadowHeights, OfPartsAreThoseOfTheWhole) {
    const film::FilmState film = test::random_canvas({90, 80}, 7);
    for (const double azimuth_deg : {10.0, 100.0, 200.0, 290.0, 135.0}) {
        const std::vector<float> whole = shadows(film, film.shape.cells(), azimuth_deg, 12.0);
        const grid::Rect part{33, 21, 50, 47};
        const std::vector<float> values = shadows(film, part, azimuth_deg, 12.0);
        for (int y = part.y0; y < part.y1; ++y) {
            for (int x = part.x0; x < part.x1; ++x) {
                ASSERT_EQ(values[(y - part.y0) * part.width() + x - part.x0], whole[y * 90 + x])
                    << azimuth_deg << " " << x << " " << y;
            }
        }
    }
}

TEST(ShadowHeights, VanishUnderALightFromAbove) {
    const film::FilmState film = test::random_canvas({40, 40}, 8);
    const float lowest = surface_range(film).lowest_mm;
    for (const float height : shadows(film, film.shape.cells(), 77.0, 90.0))
        EXPECT_LT(height, lowest);
}

}  // namespace
}  // namespace pastoso::shade
