#include "shade/tile_colour.hpp"

#include "canvas.hpp"
#include "pigment/colour.hpp"
#include "pigment/kubelka_munk.hpp"
#include "pigment/viewing.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace pastoso::shade {
namespace {

pigment::LinearRgb colour_of(const pigment::Bands& internal) {
    pigment::Bands reflectance{};
    for (int band = 0; band < pigment::kBands; ++band) {
        reflectance[band] = pigment::through_surface(internal[band]);
    }
    return pigment::linear_srgb(reflectance);
}

void expect_colour(const CellColour& actual, const pigment::LinearRgb& expected, float tolerance) {
    EXPECT_NEAR(actual.red, expected[0], tolerance);
    EXPECT_NEAR(actual.green, expected[1], tolerance);
    EXPECT_NEAR(actual.blue, expected[2], tolerance);
}

TEST(TileColours, BareCanvasShowsTheGround) {
    const film::FilmState film(grid::Shape{64, 64}, 0.25);
    std::vector<CellColour> colours(grid::kTileCells);
    tile_colours(film, 0, test::kGround, colours.data());
    for (const CellColour& colour : colours) {
        expect_colour(colour, colour_of(test::kGround), 1e-6F);
        EXPECT_EQ(colour.wetness, 0.0F);
    }
}

TEST(TileColours, AreSeenInTheLightThatIsGiven) {
    const film::FilmState film = test::random_canvas({64, 64}, 3);
    pigment::BandsToRgb single{};  // red, green and blue are the bands 1, 3 and 6
    single[0][1] = single[1][3] = single[2][5] = 1.0F;
    pigment::BandsToRgb sum{};
    for (pigment::Bands& row : sum)
        row = {0.0F, 1.0F, 0.0F, 1.0F, 0.0F, 1.0F};
    std::vector<CellColour> bands(grid::kTileCells), sums(grid::kTileCells);
    tile_colours(film, 0, test::kGround, bands.data(), single);
    tile_colours(film, 0, test::kGround, sums.data(), sum);
    for (int cell = 0; cell < grid::kTileCells; ++cell) {
        EXPECT_NEAR(sums[cell].red, bands[cell].red + bands[cell].green + bands[cell].blue, 1e-6F);
        EXPECT_EQ(sums[cell].wetness, bands[cell].wetness);
    }
}

TEST(TileColours, WithoutALightAreThoseOfDaylight) {
    const film::FilmState film = test::random_canvas({64, 64}, 3);
    std::vector<CellColour> usual(grid::kTileCells), daylight(grid::kTileCells);
    tile_colours(film, 0, test::kGround, usual.data());
    tile_colours(film, 0, test::kGround, daylight.data(),
                 pigment::viewing_under(pigment::find_illuminant("D65")).to_rgb);
    for (int cell = 0; cell < grid::kTileCells; ++cell) {
        EXPECT_EQ(usual[cell].red, daylight[cell].red);
        EXPECT_EQ(usual[cell].green, daylight[cell].green);
        EXPECT_EQ(usual[cell].blue, daylight[cell].blue);
    }
}

TEST(TileColours, ThickPaintShowsItsMasstone) {
    film::FilmState film(grid::Shape{64, 64}, 0.25);
    test::set_paint(film, 5, 7, 3.0, test::kRed);
    std::vector<CellColour> colours(grid::kTileCells);
    tile_colours(film, 0, test::kGround, colours.data());
    pigment::Bands masstone{};
    for (int band = 0; band < pigment::kBands; ++band) {
        masstone[band] =
            pigment::opaque_reflectance(test::kRed[band], test::kRed[pigment::kBands + band]);
    }
    expect_colour(colours[7 * 64 + 5], colour_of(masstone), 1e-5F);
    EXPECT_EQ(colours[7 * 64 + 5].wetness, 1.0F);
}

TEST(TileColours, FollowTheDoublePrecisionFormulaInEveryCell) {
    const film::FilmState film = test::random_canvas({64, 64}, 2);
    std::vector<CellColour> colours(grid::kTileCells);
    tile_colours(film, 0, test::kGround, colours.data());
    for (int cell = 0; cell < grid::kTileCells; ++cell) {
        const film::PaintCell& pigment = film.paint.read(0)[cell];
        pigment::Bands internal{};
        for (int band = 0; band < pigment::kBands; ++band) {
            internal[band] = static_cast<float>(pigment::layer_reflectance<double>(
                pigment[band] * film::kPaintQuantum,
                pigment[pigment::kBands + band] * film::kPaintQuantum, test::kGround[band]));
        }
        // The largest error of the single-precision layer formula, 3e-5, through the surface (slope 1 to
        // 3).
        expect_colour(colours[cell], colour_of(internal), 1e-4F);
    }
}

TEST(TileColours, WetPaintLiesOverDissolvablePaintOverItsOwnGround) {
    film::FilmState film(grid::Shape{64, 64}, 0.25);
    test::set_paint(film, 5, 7, 0.05, test::kRed);
    film::PigmentCell soluble{};
    for (int k = 0; k < pigment::kChannels; ++k)
        soluble[k] = static_cast<std::int32_t>(0.03F * test::kBlue[k] / film::kPaintQuantum);
    film.strata.soluble_pigment.set(5, 7, soluble);
    film::PigmentCell fixed{};
    for (int k = 0; k < pigment::kChannels; ++k)
        fixed[k] = static_cast<std::int32_t>(0.02F * test::kRed[k] / film::kPaintQuantum);
    film.strata.optics.set(5, 7, film::laid_over(fixed.data(), film::kClearStrata));
    std::vector<CellColour> colours(grid::kTileCells);
    tile_colours(film, 0, test::kGround, colours.data());
    pigment::Bands internal{};
    for (int band = 0; band < pigment::kBands; ++band) {
        const int scattering = pigment::kBands + band;
        const double ground = pigment::layer_reflectance<double>(
            0.02 * test::kRed[band], 0.02 * test::kRed[scattering], test::kGround[band]);
        const double below = pigment::layer_reflectance<double>(0.03 * test::kBlue[band],
                                                                0.03 * test::kBlue[scattering], ground);
        internal[band] = static_cast<float>(pigment::layer_reflectance<double>(
            0.05 * test::kRed[band], 0.05 * test::kRed[scattering], below));
    }
    // As below, and as much again for each of the other layers.
    expect_colour(colours[7 * 64 + 5], colour_of(internal), 2e-4F);
}

TEST(TileColours, WetPaintInTwoStrataIsSeenAsTwoLayers) {
    film::FilmState film(grid::Shape{64, 64}, 0.25);
    test::set_paint(film, 5, 7, 0.03, test::kBlue);
    film.lower.thickness.set(5, 7, film.thickness.at(5, 7));
    film.lower.paint.set(5, 7, film.paint.at(5, 7));
    test::set_paint(film, 5, 7, 0.05, test::kRed);
    film::PaintCell both = film.paint.at(5, 7);
    for (int k = 0; k < film::kPaintChannels; ++k)
        both[k] += film.lower.paint.at(5, 7)[k];
    film.paint.set(5, 7, both);
    test::set_paint(film, 6, 7, 0.05, test::kRed);
    std::vector<CellColour> colours(grid::kTileCells);
    tile_colours(film, 0, test::kGround, colours.data());
    pigment::Bands two{}, one{};
    for (int band = 0; band < pigment::kBands; ++band) {
        const int scattering = pigment::kBands + band;
        const double below = pigment::layer_reflectance<double>(
            0.03 * test::kBlue[band], 0.03 * test::kBlue[scattering], test::kGround[band]);
        const auto over = [&](double ground) {
            return static_cast<float>(pigment::layer_reflectance<double>(
                0.05 * test::kRed[band], 0.05 * test::kRed[scattering], ground));
        };
        two[band] = over(below);
        one[band] = over(test::kGround[band]);
    }
    expect_colour(colours[7 * 64 + 5], colour_of(two), 2e-4F);
    expect_colour(colours[7 * 64 + 6], colour_of(one), 2e-4F);
}

TEST(TileColours, WetnessGrowsSmoothlyWithThickness) {
    film::FilmState film(grid::Shape{64, 64}, 0.25);
    for (int x = 0; x < 64; ++x)
        test::set_paint(film, x, 0, kGlossyThickness_mm * x / 32.0, test::kBlue);
    std::vector<CellColour> colours(grid::kTileCells);
    tile_colours(film, 0, test::kGround, colours.data());
    for (int x = 1; x < 64; ++x) {
        const float step = colours[x].wetness - colours[x - 1].wetness;
        EXPECT_GE(step, 0.0F);
        EXPECT_LE(step, 1.5F / 32.0F + 1e-5F);
    }
    EXPECT_EQ(colours[32].wetness, 1.0F);
    EXPECT_EQ(colours[63].wetness, 1.0F);
}

TEST(CellColours, OfARectangleAreThoseOfItsTiles) {
    const film::FilmState film = test::random_canvas({100, 70}, 3);
    const grid::Rect cells{60, -1, 102, 70};
    std::vector<CellColour> part(static_cast<std::size_t>(cells.width()) * cells.height());
    cell_colours(film, cells, test::kGround, part.data(), cells.width());
    std::vector<CellColour> tile(grid::kTileCells);
    for (int index = 0; index < film.shape.tile_count(); ++index) {
        tile_colours(film, index, test::kGround, tile.data());
        const grid::Rect inside = grid::intersection(film.shape.tile_cells(index), cells);
        for (int y = inside.y0; y < inside.y1; ++y) {
            for (int x = inside.x0; x < inside.x1; ++x) {
                const CellColour& expected = tile[grid::Shape::cell_in_tile(x, y)];
                const CellColour& actual = part[(y - cells.y0) * cells.width() + x - cells.x0];
                ASSERT_EQ(actual.red, expected.red);
                ASSERT_EQ(actual.wetness, expected.wetness);
            }
        }
    }
    EXPECT_EQ(part[40].blue, part[cells.width() + 39].blue) << "the corner beyond the canvas";
}

TEST(DryColours, AreThoseOfTheCanvasWithoutItsWetPaint) {
    film::FilmState film = test::random_canvas({100, 70}, 5);
    for (int x = 70; x < 90; ++x) {
        film::PigmentCell dissolved{};
        dissolved[0] = 1000 * x;
        film.strata.soluble_pigment.set(x, 30, dissolved);
    }
    film::FilmState dry(film.shape, film.cell_mm);
    dry.strata = film.strata;
    const grid::Rect cells{-2, -2, 102, 72};
    std::vector<CellColour> seen(static_cast<std::size_t>(cells.width()) * cells.height());
    std::vector<CellColour> expected = seen;
    dry_colours(film, cells, test::kGround, seen.data(), cells.width());
    cell_colours(dry, cells, test::kGround, expected.data(), cells.width());
    for (std::size_t i = 0; i < seen.size(); ++i) {
        ASSERT_EQ(seen[i].red, expected[i].red);
        ASSERT_EQ(seen[i].green, expected[i].green);
        ASSERT_EQ(seen[i].blue, expected[i].blue);
        ASSERT_EQ(seen[i].wetness, 0.0F);
    }
    EXPECT_LT(seen[32 * 104 + 82].blue, seen[0].blue);
}

}  // namespace
}  // namespace pastoso::shade
