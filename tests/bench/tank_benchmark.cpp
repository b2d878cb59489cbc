// Cost of a step of a tank a quarter full, as its dam breaks.
#include "tank/liquid_tank.hpp"

#include <benchmark/benchmark.h>

namespace pastoso::tank {
namespace {

TankScene dam(int cells, Method method) {
    TankScene scene;
    scene.cells = glm::ivec3(cells);
    scene.cell_m = 1.0 / cells;
    scene.method = method;
    scene.liquids = {{{Block{glm::vec3(0.0F), {0.5F, 1.0F, 0.5F}}}, glm::vec3(0.0F), 0.0F}};
    return scene;
}

/// From where the water has begun to run; microseconds of a cell of liquid as a counter.
void break_dam(benchmark::State& run) {
    const int cells = static_cast<int>(run.range(0));
    core::ThreadPool pool(static_cast<int>(run.range(1)));
    LiquidTank tank(dam(cells, static_cast<Method>(run.range(2))));
    tank.advance_to(0.1, pool);
    int iterations = 0;
    for (auto _ : run)
        iterations += tank.step(1.0, pool).pressure.iterations;
    const double steps = static_cast<double>(run.iterations());
    run.counters["iterations"] = iterations / steps;
    run.counters["s_per_cell"] =
        benchmark::Counter(0.25 * cells * cells * cells,
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(break_dam)
    ->ArgNames({"cells", "threads", "method"})
    ->ArgsProduct({{32, 64, 128}, {1, 2}, {static_cast<int>(Method::Particles)}})
    ->ArgsProduct({{64},
                   {2},
                   {static_cast<int>(Method::LevelSet), static_cast<int>(Method::ParticleLevelSet)}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// What a moment costs that is drawn or written.
void take_frame(benchmark::State& run) {
    core::ThreadPool pool(2);
    LiquidTank tank(dam(64, Method::Particles));
    tank.advance_to(0.1, pool);
    for (auto _ : run)
        benchmark::DoNotOptimize(tank.frame(static_cast<int>(run.range(0)), pool));
}
BENCHMARK(take_frame)->ArgName("parts")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pastoso::tank
