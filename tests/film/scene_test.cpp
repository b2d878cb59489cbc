#include "film/laboratory/scene.hpp"

#include "core/error.hpp"
#include "core/units.hpp"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>

namespace pastoso::film {
namespace {

using testing::HasSubstr;

/// A dry flat canvas of 40 x 30 mm.
Scene bare(double cell_mm = 0.5) {
    Scene scene;
    scene.cell_mm = cell_mm;
    scene.shape = {static_cast<int>(40.0 / cell_mm), static_cast<int>(30.0 / cell_mm)};
    return scene;
}

double volume_of(const Form& form, double thickness_mm, double cell_mm = 0.5) {
    Scene scene = bare(cell_mm);
    scene.film = {{form, thickness_mm, {}}};
    return volume_mm3(totals(make_film(scene)).thickness, cell_mm);
}

/// Half a quantum a cell.
double rounding_mm3(double cell_mm) {
    return 0.5 * kThicknessQuantum_mm * 40.0 * 30.0 / (cell_mm * cell_mm) * cell_mm * cell_mm;
}

TEST(SceneVolumes, SlabAndBoxAreExact) {
    EXPECT_NEAR(volume_of(Slab{}, 0.7), 0.7 * 40 * 30, rounding_mm3(0.5));
    // Sides that cut cells, and one beyond the canvas.
    EXPECT_NEAR(volume_of(Box{{1.13, 2.27, 11.46, 9.01}}, 0.3), 0.3 * 10.33 * 6.74, rounding_mm3(0.5));
    EXPECT_NEAR(volume_of(Box{{-5, 10, 7.25, 12}}, 0.3), 0.3 * 7.25 * 2, rounding_mm3(0.5));
}

TEST(SceneVolumes, RoundFormsAreSampled) {
    const Point centre{19.3, 14.2};
    // Outlines: 16 x 16 samples a cell leave an error of some samples along a circle of 1400.
    EXPECT_NEAR(volume_of(Disc{centre, 7}, 0.4) / (0.4 * core::kPi * 49), 1.0, 5e-4);
    const double cap = core::kPi * 2.5 / 6.0 * (3 * 49 + 2.5 * 2.5);
    EXPECT_NEAR(volume_of(SphericalCap{centre, 7}, 2.5) / cap, 1.0, 5e-4);
    // Smooth forms: the midpoint rule is exact to rounding where the form fades within the canvas.
    const double gaussian = 2.0 * core::kPi * 1.5 * 2.0 * 2.0;
    EXPECT_NEAR(volume_of(Gaussian{centre, 2.0}, 1.5) / gaussian, 1.0, 1e-6);
}

TEST(SceneVolumes, CosineNoiseAndImageHaveTheirMeans) {
    // Whole waves: the mean is half the thickness.
    EXPECT_NEAR(volume_of(Cosine{10, 0, 30}, 0.8), 0.4 * 1200, rounding_mm3(0.5) + 1e-9);
    EXPECT_NEAR(volume_of(Cosine{15, 90, 0}, 0.8), 0.4 * 1200, rounding_mm3(0.5) + 1e-9);
    // 4800 cells: the mean of uniform numbers is 1/2 +- 1/sqrt(12 * 4800) = 0.004; three times that.
    EXPECT_NEAR(volume_of(WhiteNoise{7}, 1.0) / 1200, 0.5, 0.0125);
    const GreyMap half{2, 2, {0.5F, 0.5F, 0.5F, 0.5F}};
    // Image heights are multiples of the support's quantum, rounded down.
    EXPECT_NEAR(volume_of(half, 1.0), 600.0, 1200 * kSupportQuantum_mm);
}

TEST(SceneFilm, NoiseFollowsItsSeed) {
    Scene scene = bare();
    scene.film = {{WhiteNoise{3}, 0.5, {}}};
    const std::uint64_t first = state_hash(make_film(scene));
    EXPECT_EQ(state_hash(make_film(scene)), first);
    scene.film = {{WhiteNoise{4}, 0.5, {}}};
    EXPECT_NE(state_hash(make_film(scene)), first);
}

TEST(SceneFilm, MirroredFormsMakeMirroredFilms) {
    Scene scene = bare();
    scene.film = {{SphericalCap{{12, 15}, 6}, 2, {}}, {Gaussian{{28, 15}, 2}, 1, {}}};
    Scene mirrored = scene;
    mirrored.film = {{SphericalCap{{28, 15}, 6}, 2, {}}, {Gaussian{{12, 15}, 2}, 1, {}}};
    const FilmState film = make_film(scene), mirror = make_film(mirrored);
    for (int y = 0; y < scene.shape.height; ++y)
        for (int x = 0; x < scene.shape.width; ++x)
            // The sums over samples run the other way round, which may round the other way.
            ASSERT_NEAR(film.thickness.at(x, y), mirror.thickness.at(scene.shape.width - 1 - x, y), 1);
}

TEST(SceneFilm, PigmentsAddUpByThickness) {
    Scene scene = bare();
    pigment::Coefficients first{}, second{};
    first[0] = 2.0F;
    second[0] = 8.0F;
    second[7] = 1.0F;
    scene.film = {{Slab{}, 0.25, first, {}}, {Slab{}, 0.5, second, {}}, {Slab{}, 0.25, {}, {}}};
    const FilmState film = make_film(scene);
    EXPECT_EQ(film.thickness.at(3, 3), static_cast<std::int32_t>(1.0 / kThicknessQuantum_mm));
    EXPECT_FLOAT_EQ(optical_thickness(film.paint.at(3, 3)[0]), 0.25F * 2.0F + 0.5F * 8.0F);
    EXPECT_FLOAT_EQ(optical_thickness(film.paint.at(3, 3)[7]), 0.5F);
    EXPECT_EQ(film.paint.at(3, 3)[1], 0);
}

// Half house paint, half oil: the mean yield stress, and the mean logarithm of the viscosity.
TEST(SceneFilm, FormsOfTwoPaintsMix) {
    Scene scene = bare();
    scene.medium = find_medium("house paint");
    const Medium oil = find_medium("heavy-body oil");
    scene.film = {{Slab{}, 0.25, {}}, {Box{{0, 0, 20, 30}}, 0.25, {}, oil}};
    const FilmState film = make_film(scene);
    EXPECT_TRUE(film.consistencies.are_several());
    const auto per_mm = [&film](int x, int channel) {
        return film.paint.at(x, 3)[channel] * kPaintQuantum / thickness_mm(film.thickness.at(x, 3));
    };
    // Two quanta of 2^-17 on a quarter of a millimetre.
    constexpr double kRounding = 1e-4;
    EXPECT_NEAR(per_mm(70, kYieldChannel), 0.5, kRounding);
    EXPECT_NEAR(per_mm(10, kYieldChannel), 0.5 * (0.5 + 80.0), kRounding);
    const double mixed_m2_s = std::sqrt(scene.medium.viscosity_m2_s * oil.viscosity_m2_s);
    EXPECT_NEAR(per_mm(10, kViscosityChannel), std::log(mixed_m2_s / kThinnest_m2_s), kRounding);
}

TEST(SceneFilm, TooMuchPaintNamesTheCell) {
    Scene scene = bare();
    scene.film = {{Slab{}, 10, {}, {}}, {Box{{5, 5, 6, 6}}, 5.5, {}, {}}};
    try {
        make_film(scene);
        FAIL();
    } catch (const core::InputError& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("thickness of the film is 15.5 in cell (10, 10), but must lie between 0 "
                              "and 15"));
    }
}

TEST(SceneSupport, ReliefsAddUpOnTheQuantumGrid) {
    Scene scene = bare();
    scene.support = {Ramp{0.1, 0}, Bump{{20, 15}, 1.0, 3.0}, BundledRelief{"linen", 0.0}};
    const auto heights = make_support(scene);
    scene.support = {BundledRelief{"linen", 0.0}};
    const auto linen = make_support(scene);
    // Far from the bump (r = 15.7 mm, exp(-13.7) = 1e-6) the ramp alone stands under the linen.
    EXPECT_NEAR(heights.at(9, 2) - linen.at(9, 2), 0.1 * 4.75, 3e-6);
    EXPECT_NEAR(heights.at(40, 30) - linen.at(40, 30), 0.1 * 20.25 + 1.0, 0.02);
    for (int x = 0; x < scene.shape.width; ++x) {
        const double quanta = heights.at(x, 17) / kSupportQuantum_mm;
        ASSERT_EQ(quanta, std::floor(quanta));
    }
}

TEST(SceneSupport, ARampRisesFromItsLowestCorner) {
    Scene scene = bare();
    scene.support = {Ramp{0.2, 180}};
    const auto heights = make_support(scene);
    EXPECT_NEAR(heights.at(79, 10), 0.2 * 0.25, 1e-6);
    EXPECT_NEAR(heights.at(0, 50), 0.2 * 39.75, 2e-6);
    scene.support = {Bump{{20, 15}, -1.0, 3.0}};
    EXPECT_THROW(make_support(scene), core::InputError);
}

TEST(SceneFilm, ValuesOfCellsAreTakenAsTheyAre) {
    Scene scene = bare(10.0);  // 4 x 3 cells
    std::vector<float> values(12);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = 0.125F * static_cast<float>(i);
    scene.film = {{CellValues{values}, 2.0, {}}};
    scene.support = {CellHeights{{values}}};
    const FilmState film = make_film(scene);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) {
            const float value = values[static_cast<std::size_t>(4 * y + x)];
            EXPECT_EQ(thickness_mm(film.thickness.at(x, y)), 2.0F * value);
            EXPECT_EQ(film.support_mm.at(x, y), value);
        }
    }
}

TEST(SceneFilm, ValuesOfCellsAreAsManyAsThereAreCells) {
    Scene scene = bare(10.0);
    const std::vector<float> values(11, 0.5F);
    scene.film = {{CellValues{values}, 1.0, {}}};
    EXPECT_THROW(make_film(scene), core::InputError);
    scene.film.clear();
    scene.support = {CellHeights{{values}}};
    EXPECT_THROW(make_film(scene), core::InputError);
    const std::vector<float> negative(12, -0.5F);
    scene.support.clear();
    scene.film = {{CellValues{negative}, 1.0, {}}};
    EXPECT_THROW(make_film(scene), core::InputError);
}

TEST(SceneSupport, AnImageSpansItsHeights) {
    Scene scene = bare();
    scene.support = {ImageRelief{{2, 1, {0.0F, 1.0F}}, 0.25, 1.25}};
    const auto heights = make_support(scene);
    EXPECT_NEAR(heights.at(0, 0), 0.25, 0.05);
    EXPECT_NEAR(heights.at(79, 0), 1.25, 0.05);
}

}  // namespace
}  // namespace pastoso::film
