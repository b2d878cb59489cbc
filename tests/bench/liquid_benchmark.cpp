// Cost of the stages of a step of the liquid, in the cup and in a box.
#include "liquid/classic/periodic.hpp"
#include "liquid/flow/flow.hpp"
#include "liquid/vessel/cup.hpp"

#include <cmath>

#include <benchmark/benchmark.h>

namespace pastoso::liquid {
namespace {

grid::BoxShape box(const benchmark::State& run) {
    const int cells = static_cast<int>(run.range(0));
    return {cells, cells, cells, 0.1F / static_cast<float>(cells)};
}
float cup(const glm::vec3& point_m) {
    return tea_distance_m({}, point_m);
}

/// A swirl of some decimetres a second with a fine pattern on it.
void stir(VelocityField& velocity) {
    const grid::BoxShape& shape = velocity.shape();
    const float n = static_cast<float>(shape.nx);
    for (int k = 0; k <= shape.nz; ++k)
        for (int j = 0; j <= shape.ny; ++j)
            for (int i = 0; i <= shape.nx; ++i) {
                const float x = static_cast<float>(i) / n - 0.5F, y = static_cast<float>(j) / n - 0.5F,
                            z = static_cast<float>(k) / n;
                velocity.x.at(i, j, k) = -0.4F * y + 0.02F * std::sin(40.0F * z);
                velocity.y.at(i, j, k) = 0.4F * x + 0.02F * std::sin(50.0F * x);
                velocity.z.at(i, j, k) = 0.05F * std::sin(30.0F * x + 20.0F * y);
            }
}

/// Source of the pressure: the divergence of the stirred velocity.
void pressure(benchmark::State& run) {
    core::ThreadPool pool(static_cast<int>(run.range(1)));
    const Walls walls(box(run), cup);
    Projection projection(walls);
    VelocityField stirred(walls.shape()), velocity = stirred;
    stir(stirred);
    SolveResult result;
    for (auto _ : run) {
        run.PauseTiming();
        velocity = stirred;
        projection.start_cold();
        run.ResumeTiming();
        result = projection.project(walls, velocity,
                                    {std::pow(10.0F, -static_cast<float>(run.range(2))), 50}, pool);
    }
    run.counters["iterations"] = result.iterations;
}
BENCHMARK(pressure)
    ->ArgNames({"cells", "threads", "digits"})
    ->ArgsProduct({{64, 128}, {1, 2}, {3, 6}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void advect_velocity(benchmark::State& run) {
    core::ThreadPool pool(static_cast<int>(run.range(1)));
    VesselFlow flow(box(run), cup);
    stir(flow.velocity());
    flow.project(pool);
    for (auto _ : run)
        flow.advect_velocity(0.01F, pool);
}
BENCHMARK(advect_velocity)
    ->ArgNames({"cells", "threads"})
    ->ArgsProduct({{64, 128}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void advect_two_scalars(benchmark::State& run) {
    core::ThreadPool pool(static_cast<int>(run.range(1)));
    VesselFlow flow(box(run), cup);
    stir(flow.velocity());
    flow.project(pool);
    grid::BoxField milk(flow.shape(), 0.3F), coldness(flow.shape(), 0.2F);
    for (auto _ : run)
        flow.advect_cells(std::array{&milk, &coldness}, 0.01F, KeepSum::Yes, pool);
}
BENCHMARK(advect_two_scalars)
    ->ArgNames({"cells", "threads"})
    ->ArgsProduct({{64, 128}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void periodic_projection(benchmark::State& run) {
    core::ThreadPool pool(static_cast<int>(run.range(1)));
    PeriodicFlow flow(box(run));
    stir(flow.velocity());
    for (auto _ : run)
        flow.diffuse_and_project(0.01F, pool);
}
BENCHMARK(periodic_projection)
    ->ArgNames({"cells", "threads"})
    ->ArgsProduct({{64, 128}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// A whole step with two scalars that drive the flow.
void vessel_step(benchmark::State& run) {
    constexpr float kStep_s = 1.0F / 30.0F;
    core::ThreadPool pool(static_cast<int>(run.range(1)));
    VesselFlow flow(box(run), cup);
    stir(flow.velocity());
    const grid::BoxShape& shape = flow.shape();
    grid::BoxField milk(shape), coldness(shape);
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                milk.at(i, j, k) = k > shape.nz / 2 ? 0.5F : 0.0F;
                coldness.at(i, j, k) = i > shape.nx / 2 ? 0.4F : 0.0F;
            }
    long iterations = 0, steps = 0;
    for (auto _ : run) {
        for (int k = 1; k < shape.nz; ++k)
            for (int j = 0; j < shape.ny; ++j)
                for (int i = 0; i < shape.nx; ++i)
                    flow.velocity().z.at(i, j, k) -=
                        kStep_s * (0.3F * coldness.at(i, j, k) + 0.03F * milk.at(i, j, k));
        flow.diffuse_velocity(kStep_s, pool);
        iterations += flow.project(pool).iterations;
        flow.diffuse_cells(milk, 3e-5F, kStep_s, pool);
        flow.diffuse_cells(coldness, 2e-6F, kStep_s, pool);
        flow.advect_cells(std::array{&milk, &coldness}, kStep_s, KeepSum::Yes, pool);
        flow.advect_velocity(kStep_s, pool);
        ++steps;
    }
    run.counters["iterations"] = static_cast<double>(iterations) / static_cast<double>(steps);
}
BENCHMARK(vessel_step)
    ->ArgNames({"cells", "threads"})
    ->ArgsProduct({{64, 128}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pastoso::liquid
