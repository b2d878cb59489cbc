// What following a surface costs and how much volume it loses, in one turn of a sphere and in Enright's
// deformation; and the cost of the pieces.
#include "tank/extension.hpp"
#include "tank/level_cases.hpp"
#include "tank/liquid_volume.hpp"

#include <cmath>

#include <benchmark/benchmark.h>
#include <glm/geometric.hpp>

namespace pastoso::tank {
namespace {

using cases::Flow;
using cases::Following;
using liquid::Interpolation;

struct Way {
    const char* name;
    Following how;
};
const Way kWays[] = {
    {"upwind", {.scheme = LevelSetScheme::Upwind, .steps_per_reinitialisation = 0}},
    {"upwind, reinitialised", {.scheme = LevelSetScheme::Upwind}},
    {"limited cubic", {.interpolation = Interpolation::LimitedCubic, .steps_per_reinitialisation = 0}},
    {"limited cubic, reinitialised", {.interpolation = Interpolation::LimitedCubic}},
    {"cubic", {.steps_per_reinitialisation = 0}},
    {"cubic, reinitialised", {}},
    {"cubic, reinitialised with care", {.kept_within_cells = kKeptWithin_cells}},
    {"32 particles",
     {.steps_per_reinitialisation = 0, .particles_per_cell = 32, .steps_per_reseeding = 0}},
    {"32 particles, reinitialised", {.particles_per_cell = 32, .steps_per_reseeding = 0}},
    {"32 particles, reinitialised, reseeded", {.particles_per_cell = 32}},
    {"8 particles, reinitialised, reseeded", {.particles_per_cell = 8}},
    {"upwind, 32 particles, reinitialised, reseeded",
     {.scheme = LevelSetScheme::Upwind, .particles_per_cell = 32}},
};

void follow(benchmark::State& run) {
    const Way& way = kWays[run.range(2)];
    core::ThreadPool pool(1);
    cases::Followed result;
    for (auto _ : run)
        result = cases::follow(static_cast<Flow>(run.range(0)), static_cast<int>(run.range(1)), way.how,
                               pool);
    run.SetLabel(way.name);
    run.counters["volume_%"] = 100.0 * result.volume_error;
    run.counters["shape"] = result.shape_error;
    run.counters["ms_a_step"] = 1e3 * result.seconds / result.steps;
    run.counters["particles"] = static_cast<double>(result.particles);
    run.counters["escaped"] = static_cast<double>(result.escaped);
}
BENCHMARK(follow)
    ->ArgNames({"flow", "cells", "way"})
    ->ArgsProduct({{0, 1, 2}, {48, 64}, benchmark::CreateDenseRange(0, std::size(kWays) - 1, 1)})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

/// A wavy surface over a quarter of a box, and a ball above it.
struct Water {
    grid::BoxShape shape;
    grid::BoxField phi;
    liquid::VelocityField velocity, known;
    float dt_s;

    explicit Water(int cells)
        : shape(cases::unit_box(cells)),
          phi(cases::sampled(shape,
                             [](const glm::vec3& p) {
                                 const float wave = 0.05F * std::sin(9.0F * p.x) * std::cos(7.0F * p.y);
                                 return std::min(p.z - 0.23F + wave,
                                                 glm::distance(p, glm::vec3(0.5F, 0.5F, 0.6F)) - 0.12F);
                             })),
          velocity(cases::velocity_at_start(Flow::Enright, shape)),
          known(shape),
          dt_s(0.25F * shape.cell_m) {
        core::ThreadPool pool(1);
        Reinitialisation(shape).apply(phi, kLevelSetReach_cells, 0.0F, pool);
        for (const int axis : liquid::kAxes) {
            const std::ptrdiff_t back = liquid::stride(shape, axis);
            for (int k = 0; k < shape.nz; ++k)
                for (int j = 0; j < shape.ny; ++j)
                    for (int i = 0; i < shape.nx; ++i)
                        known.along(axis).at(i, j, k) =
                            std::min(phi.at(i, j, k), (phi.row(j, k) + i)[-back]) < 0.0F ? 1.0F : 0.0F;
        }
    }
};

void advect(benchmark::State& run) {
    core::ThreadPool pool(static_cast<int>(run.range(1)));
    Water water(static_cast<int>(run.range(0)));
    LevelSetAdvection advection(water.shape);
    // To and fro.
    for (auto _ : run)
        advection.advect(water.phi, water.velocity, water.dt_s = -water.dt_s, kLevelSetReach_cells,
                         LevelSetScheme::SemiLagrangian, pool);
}
void reinitialise(benchmark::State& run) {
    core::ThreadPool pool(static_cast<int>(run.range(1)));
    Water water(static_cast<int>(run.range(0)));
    Reinitialisation reinitialisation(water.shape);
    for (auto _ : run)
        reinitialisation.apply(water.phi, kLevelSetReach_cells, 0.0F, pool);
}
void extend(benchmark::State& run) {
    core::ThreadPool pool(static_cast<int>(run.range(1)));
    Water water(static_cast<int>(run.range(0)));
    VelocityExtension extension(water.shape);
    for (auto _ : run)
        extension.extend(water.phi, water.known, kLevelSetReach_cells, water.velocity, pool);
}
void measure_volume(benchmark::State& run) {
    core::ThreadPool pool(static_cast<int>(run.range(1)));
    const Water water(static_cast<int>(run.range(0)));
    for (auto _ : run)
        benchmark::DoNotOptimize(liquid_volume_m3(water.phi, pool));
}

/// With 32 particles a cell, as range 2 says: 0 carries them, 1 mends phi, 2 adjusts radii, 3 reseeds.
void particles(benchmark::State& run) {
    core::ThreadPool pool(static_cast<int>(run.range(1)));
    Water water(static_cast<int>(run.range(0)));
    SurfaceParticles particles(water.shape);
    particles.seed(water.phi, pool);
    for (auto _ : run) {
        if (run.range(2) == 0) particles.carry(water.velocity, water.dt_s = -water.dt_s, pool);
        if (run.range(2) == 1) particles.mend(water.phi, pool);
        if (run.range(2) == 2) particles.adjust_radii(water.phi, pool);
        if (run.range(2) == 3) particles.reseed(water.phi, pool);
    }
    run.counters["particles"] = static_cast<double>(particles.positions_m().size());
}

void sizes(benchmark::internal::Benchmark* piece) {
    piece->ArgNames({"cells", "threads"})
        ->ArgsProduct({{64, 128}, {1, 2}})
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
}
BENCHMARK(advect)->Apply(sizes);
BENCHMARK(reinitialise)->Apply(sizes);
BENCHMARK(extend)->Apply(sizes);
BENCHMARK(measure_volume)->Apply(sizes);
BENCHMARK(particles)
    ->ArgNames({"cells", "threads", "stage"})
    ->ArgsProduct({{64}, {1, 2}, {0, 1, 2, 3}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pastoso::tank
