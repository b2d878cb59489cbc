#include "film/laboratory/simulation.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::film {
namespace {

/// Paint in the units of the analytic solutions: cells of one millimetre, density 1000.
Scene in_cells(int width, int height) {
    Scene scene;
    scene.cell_mm = 1.0;
    scene.shape = {width, height};
    scene.medium.density_kg_m3 = 1000;
    scene.medium.viscosity_m2_s = 1e-6;
    scene.medium.surface_tension_N_m = 4e-6;
    scene.medium.advancing_angle_deg = 30;
    scene.medium.receding_angle_deg = 10;
    scene.solver.edge_x = scene.solver.edge_y = Edge::Periodic;
    scene.solver.sleeping = false;
    scene.gravity = {1.0, 0.0, 0.0};
    scene.duration_s = 2.0;
    return scene;
}

TEST(Simulation, IsTheSolverRunOnTheSameFilm) {
    Scene scene = in_cells(80, 70);
    scene.medium.alpha_min = 0.5;
    scene.medium.alpha_max = 1.2;
    scene.gravity.x_mm_s2 = 0.5;
    scene.solver.fixed_step_s = 0.01;
    pigment::Coefficients blue{};
    blue[3] = 2.0F;
    scene.film = {{SphericalCap{{40, 30}, 12}, 5, blue}, {Box{{3, 3, 20, 20}}, 1, {}}};
    core::ThreadPool pool(1);
    Simulation simulation(scene, pool);
    simulation.advance_to(1.0);
    simulation.advance_to(2.0);

    FilmState film = make_film(scene);
    Solver solver(film, scene.medium, scene.solver, pool);
    solver.set_gravity(scene.gravity);
    for (int i = 0; i < 200; ++i)
        solver.step(0.01);
    EXPECT_EQ(simulation.report().steps, 200);
    EXPECT_EQ(state_hash(simulation.film()), state_hash(film));
}

TEST(Simulation, IsPutBackWhereItIsCancelled) {
    Scene scene = in_cells(80, 70);
    scene.gravity.x_mm_s2 = 0.5;
    scene.film = {{SphericalCap{{40, 30}, 12}, 5, {}}};
    core::ThreadPool pool(1);
    Simulation simulation(scene, pool), whole(scene, pool);
    EXPECT_TRUE(simulation.advance_to_unless([] { return false; }, 0.5));
    const std::uint64_t before = state_hash(simulation.film());
    int asked = 0;
    EXPECT_FALSE(simulation.advance_to_unless([&] { return ++asked > 3; }, 2.0));
    EXPECT_EQ(simulation.time_s(), 0.5);
    EXPECT_EQ(state_hash(simulation.film()), before);
    EXPECT_TRUE(simulation.advance_to_unless([] { return false; }, 1.0));
    whole.advance_to(0.5);
    whole.advance_to(1.0);
    EXPECT_EQ(state_hash(simulation.film()), state_hash(whole.film()));
    EXPECT_EQ(simulation.report().steps, whole.report().steps);
}

TEST(Simulation, ThreadsDoNotShow) {
    Scene scene = in_cells(150, 140);
    scene.gravity.y_mm_s2 = 0.7;
    scene.solver.edge_y = Edge::Open;
    scene.film = {{WhiteNoise{5}, 2, {}}, {SphericalCap{{70, 60}, 30}, 6, {}}};
    std::uint64_t hashes[2];
    for (int threads : {1, 3}) {
        core::ThreadPool pool(threads);
        Simulation simulation(scene, pool);
        simulation.advance_to(0.5);
        hashes[threads / 2] = state_hash(simulation.film());
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(Simulation, ASlabRunsAtNusseltsSpeed) {
    Scene scene = in_cells(20, 20);
    scene.medium.surface_tension_N_m = 0;
    scene.medium.slip_cells = 0;
    scene.gravity = {1.0, 0.3, 0.4};
    scene.film = {{Slab{}, 2.0, {}}};
    core::ThreadPool pool(1);
    Simulation simulation(scene, pool);
    // The start decays with 3 nu / h^2 = 0.75 per second: 1e-7 is left.
    simulation.advance_to(22.0);
    const auto profile = simulation.profile(Axis::X, 7.3);
    // F h^2 / (3 nu); float velocities keep 1e-7 a step, the tolerance is that of the film's tests.
    EXPECT_NEAR(profile[3].velocity_x_mm_s / (0.3 * 4 / 3), 1.0, 1e-4);
    EXPECT_NEAR(profile[3].velocity_y_mm_s / (0.4 * 4 / 3), 1.0, 1e-4);
    EXPECT_EQ(simulation.measures().volume_mm3, 800.0);
    EXPECT_NEAR(simulation.measures().kinetic_energy_J, 0.5e-9 * 800 * 4.0 / 9.0 * 1e-3, 1e-13);
}

TEST(Simulation, ASymmetricDropStaysSymmetric) {
    Scene scene = in_cells(64, 50);
    scene.gravity.y_mm_s2 = 0.6;
    scene.film = {{SphericalCap{{32, 18}, 12}, 5, {}}};
    core::ThreadPool pool(1);
    Simulation simulation(scene, pool);
    simulation.advance_to(4.0);
    const FilmState& film = simulation.film();
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 32; ++x)
            // Mirrored sums of floats differ by a few parts in 1e7 a step.
            ASSERT_NEAR(thickness_mm(film.thickness.at(x, y)),
                        thickness_mm(film.thickness.at(63 - x, y)), 2e-3)
                << x << " " << y;
    EXPECT_NEAR(simulation.measures().centroid.x_mm, 32.0, 1e-4);
    EXPECT_GT(simulation.measures().centroid.y_mm, 19.0);
}

TEST(Simulation, RunoffAndFilmAreTheWholePaint) {
    Scene scene = in_cells(30, 30);
    scene.solver.edge_x = Edge::Open;
    scene.gravity.x_mm_s2 = 1.0;
    scene.film = {{Box{{15, 5, 28, 25}}, 3, {}}};
    core::ThreadPool pool(1);
    Simulation simulation(scene, pool);
    const double before = simulation.measures().volume_mm3;
    simulation.advance_to(6.0);
    EXPECT_GT(simulation.runoff_mm3(), 10.0);
    EXPECT_EQ(simulation.measures().volume_mm3 + simulation.runoff_mm3(), before);
}

}  // namespace
}  // namespace pastoso::film
