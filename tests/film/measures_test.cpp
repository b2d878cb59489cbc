#include "film/laboratory/measures.hpp"

#include "core/units.hpp"
#include "film/laboratory/front.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::film {
namespace {

constexpr Gravity kFlat{9806.65, 0, 0};

Scene with(std::vector<Primitive> film, double cell_mm = 0.5) {
    Scene scene;
    scene.cell_mm = cell_mm;
    scene.shape = {static_cast<int>(40 / cell_mm), static_cast<int>(30 / cell_mm)};
    scene.film = std::move(film);
    scene.medium.density_kg_m3 = 1200;
    scene.medium.surface_tension_N_m = 0.03;
    scene.medium.advancing_angle_deg = 0;
    return scene;
}

Measures measures_of(const Scene& scene) {
    return measure(make_film(scene), scene.medium, kFlat, scene.solver);
}

TEST(Measures, ADryCanvasHasNoPlaces) {
    const Measures dry = measures_of(with({}));
    EXPECT_EQ(dry.volume_mm3, 0.0);
    EXPECT_TRUE(std::isnan(dry.centroid.x_mm));
    EXPECT_TRUE(std::isnan(dry.wet_box.x0_mm));
    EXPECT_EQ(dry.surface_energy_J, 0.0);
}

TEST(Measures, ABoxIsExact) {
    Scene scene = with({{Box{{10, 5, 20, 25}}, 0.5, {}}});
    scene.support = {Ramp{0.0, 0}};
    FilmState film = make_film(scene);
    for (int y = 0; y < scene.shape.height; ++y) {
        for (int x = 0; x < scene.shape.width; ++x) {
            film.velocity_x.set(x, y, 3.0F);
            film.velocity_y.set(x, y, 4.0F);
        }
    }
    const Measures box = measure(film, scene.medium, kFlat, scene.solver);
    EXPECT_EQ(box.volume_mm3, 100.0);
    EXPECT_EQ(box.max_h_mm, 0.5);
    EXPECT_DOUBLE_EQ(box.centroid.x_mm, 15.0);
    EXPECT_DOUBLE_EQ(box.centroid.y_mm, 15.0);
    EXPECT_EQ(box.wet_box.x0_mm, 10.0);
    EXPECT_EQ(box.wet_box.x1_mm, 20.0);
    EXPECT_EQ(box.wet_box.y0_mm, 5.0);
    EXPECT_EQ(box.wet_box.y1_mm, 25.0);
    // 1/2 m |u|^2 and m g (h / 2) with m = 1200 kg/m3 * 100e-9 m3.
    EXPECT_NEAR(box.kinetic_energy_J, 0.5 * 1.2e-4 * 25e-6, 1e-15);
    EXPECT_NEAR(box.gravity_energy_J, 1.2e-4 * 9.80665 * 0.25e-3, 1e-12);
}

TEST(Measures, LiftedPaintHasMoreGravityEnergy) {
    Scene scene = with({{Slab{}, 0.5, {}}});
    const double low = measures_of(scene).gravity_energy_J;
    scene.support = {ImageRelief{{1, 1, {1.0F}}, 0.0, 2.0}};
    // 600 mm3 lifted by 2 mm.
    EXPECT_NEAR(measures_of(scene).gravity_energy_J - low, 7.2e-4 * 9.80665 * 2e-3, 1e-9);
}

TEST(Measures, ACapsSurfaceEnergyIsItsExtraArea) {
    // Area of a cap pi (R^2 + t^2), of its base pi R^2; the staircase of the edge costs some per cent.
    const Scene scene = with({{SphericalCap{{20, 15}, 10}, 4, {}}}, 0.125);
    EXPECT_NEAR(measures_of(scene).surface_energy_J / (0.03e-6 * core::kPi * 16), 1.0, 0.04);
}

TEST(Measures, WettingGivesEnergyBack) {
    Scene scene = with({{Slab{}, 0.5, {}}});
    scene.medium.advancing_angle_deg = 60;
    scene.solver.edge_x = scene.solver.edge_y = Edge::Periodic;
    EXPECT_NEAR(measures_of(scene).surface_energy_J, 0.03e-6 * 1200 * 0.5, 1e-12);
}

TEST(Measures, SmallSlopesAreTheLimitOfLargeOnes) {
    Scene scene = with({{Slab{}, 1.0, {}}, {Cosine{20, 0, 0}, 0.02, {}}});
    scene.solver.edge_x = scene.solver.edge_y = Edge::Periodic;
    const double full = measures_of(scene).surface_energy_J;
    scene.solver.full_curvature = false;
    // sigma/2 * mean slope^2 = sigma/2 * (0.01 * 2 pi / 20)^2 / 2; second order in the cell.
    const double slope = 0.01 * 2 * core::kPi / 20;
    EXPECT_NEAR(measures_of(scene).surface_energy_J / (0.03e-6 * 1200 * slope * slope / 4), 1.0, 0.01);
    EXPECT_NEAR(full / measures_of(scene).surface_energy_J, 1.0, 1e-4);
}

TEST(Profiles, RunAlongEitherAxisBetweenTheCells) {
    Scene scene = with({{Box{{10, 5, 20, 25}}, 0.5, {}}, {Box{{0, 0, 40, 15}}, 0.25, {}}});
    const FilmState film = make_film(scene);
    const auto along_x = profile_along(Axis::X, 15.0, film, scene.solver);
    ASSERT_EQ(along_x.size(), 80U);
    EXPECT_EQ(along_x[0].along_mm, 0.25);
    EXPECT_DOUBLE_EQ(along_x[0].thickness_mm, 0.125);  // half-way between the rows at 14.75 and 15.25
    EXPECT_DOUBLE_EQ(along_x[25].thickness_mm, 0.625);
    const auto along_y = profile_along(Axis::Y, 12.25, film, scene.solver);
    ASSERT_EQ(along_y.size(), 60U);
    EXPECT_DOUBLE_EQ(along_y[0].thickness_mm, 0.25);
    EXPECT_DOUBLE_EQ(along_y[20].thickness_mm, 0.75);
    EXPECT_DOUBLE_EQ(profile_along(Axis::Y, 40.0, film, scene.solver)[0].thickness_mm, 0.25);
}

/// A strip 10 mm wide with an end of its own, running to the right.
Front front_with(const Primitive& end, const Gravity& gravity) {
    const Scene scene = with({{Box{{5, 10, 20, 20}}, 0.5, {}}, end}, 0.25);
    return front_of(make_film(scene), gravity).value();
}

TEST(Front, ASemicircleIsRoundAndFull) {
    const Scene disc = with({{Disc{{20, 15}, 5}, 0.5, {}}}, 0.25);
    for (const double turn_deg : {0.0, 90.0, 180.0, 30.0}) {
        const double turn = core::radians(turn_deg);
        const Gravity gravity{0, std::cos(turn), std::sin(turn)};
        const Front front = front_of(make_film(disc), gravity).value();
        // Cells that the outline cuts count as wet, which moves it out by a quarter of a cell of
        // 0.25 mm or a half; strips that lie askew cut the rows of cells unevenly.
        EXPECT_NEAR(front.width_mm, 10.0, 0.4) << turn_deg;
        EXPECT_NEAR(front.roundness, 1.0, 0.08) << turn_deg;
        EXPECT_NEAR(front.fullness, 1.0, 0.06) << turn_deg;
        const double centre = 20 * std::cos(turn) + 15 * std::sin(turn);
        EXPECT_NEAR(front.tip_mm, centre + 5.0, 0.2) << turn_deg;
        EXPECT_NEAR(front.thickness_mm, 0.5, 1e-9);
    }
}

TEST(Front, ABlockIsFullerAndASlimEndLess) {
    const Front block = front_with({Box{{20, 10, 25, 20}}, 0.5, {}}, {0, 1, 0});
    EXPECT_NEAR(block.tip_mm, 25.0, 0.3);
    EXPECT_NEAR(block.fullness, 4 / core::kPi, 0.05);
    const Front slim = front_with({Box{{20, 13, 30, 17}}, 0.5, {}}, {0, 1, 0});
    EXPECT_NEAR(slim.tip_mm, 30.0, 0.5);
    EXPECT_LT(slim.fullness, 0.6);
}

TEST(Front, NeedsPaintAndAForce) {
    const Scene dry = with({});
    EXPECT_FALSE(front_of(make_film(dry), {0, 1, 0}));
    const Scene disc = with({{Disc{{20, 15}, 5}, 0.5, {}}});
    EXPECT_FALSE(front_of(make_film(disc), kFlat));
}

}  // namespace
}  // namespace pastoso::film
