// Cost of a film step per cell, explicit and large, all cells wet and flowing. Rates are of processor
// time, summed over the threads, so that other work on the machine counts little.
#include "core/memory.hpp"
#include "film/solver.hpp"

#include <cmath>
#include <memory>

#include <benchmark/benchmark.h>

namespace pastoso::film {
namespace {

struct Flow {
    bool alpha_range = false, yield_and_curvature = false, pigment = false, shear_thinning = false,
         varied = false;
};

Medium medium_of(const Flow& flow) {
    Medium medium;
    medium.density_kg_m3 = 1000.0;
    medium.viscosity_m2_s = 1e-6;
    medium.surface_tension_N_m = 1e-6;
    medium.yield_stress_Pa = flow.yield_and_curvature ? 1e-5 : 0.0;
    if (flow.shear_thinning) medium.flow_index = 0.5;
    if (flow.alpha_range) {
        medium.alpha_min = 0.5;
        medium.alpha_max = 1.2;
    }
    return medium;
}

FilmState wavy_film(int n, bool pigment) {
    FilmState state({n, n}, 1.0);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const double h = 1 + 0.2 * std::sin(x * 0.3) * std::cos(y * 0.2);
            state.thickness.set(x, y, static_cast<std::int32_t>(h / kThicknessQuantum_mm));
            if (!pigment) continue;
            PaintCell cell;
            for (int k = 0; k < kPaintChannels; ++k)
                cell[k] = static_cast<std::int32_t>((50 + x % 7) * h / kPaintQuantum);
            state.paint.set(x, y, cell);
        }
    return state;
}

/// Nearly the medium's own consistency, different from cell to cell.
void vary(FilmState& state) {
    for (int y = 0; y < state.shape.height; ++y)
        for (int x = 0; x < state.shape.width; ++x) {
            PaintCell cell = state.paint.at(x, y);
            cell[kViscosityChannel] = static_cast<std::int32_t>(0.1 * (x % 7) / kPaintQuantum);
            cell[kYieldChannel] = 1 + y % 2;
            state.paint.set(x, y, cell);
        }
    state.consistencies = film::Consistencies::several();
}

void step_film(benchmark::State& run, const Flow& flow) {
    core::keep_freed_memory();  // as the programs do
    const int n = static_cast<int>(run.range(0));
    core::ThreadPool pool(static_cast<int>(run.range(1)));
    FilmState state = wavy_film(n, flow.pigment);
    if (flow.varied) vary(state);
    SolverOptions options;
    options.edge_x = options.edge_y = Edge::Periodic;
    options.full_curvature = flow.yield_and_curvature;
    options.sleeping = false;
    Solver solver(state, medium_of(flow), options, pool);
    solver.set_gravity({1.0, 0.05, 0.0});
    solver.step(0.05);  // the first step also asks the system for memory
    for (auto _ : run)
        solver.step(0.05);
    run.counters["Mcell/s"] = benchmark::Counter(static_cast<double>(n) * n * 1e-6 * run.iterations(),
                                                 benchmark::Counter::kIsRate);
}

/// Pairs of canvas side in cells and threads.
void plain_sizes(benchmark::internal::Benchmark* run) {
    run->ArgNames({"side", "threads"})->Args({256, 1})->Args({1024, 1});
    run->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
}
void all_sizes(benchmark::internal::Benchmark* run) {
    plain_sizes(run);
    run->Args({2048, 1})->Args({2048, 2})->Args({4096, 1});
}

BENCHMARK_CAPTURE(step_film, alpha_range, Flow{.alpha_range = true})->Apply(plain_sizes);
BENCHMARK_CAPTURE(step_film, alpha_yield_curvature,
                  Flow{.alpha_range = true, .yield_and_curvature = true})
    ->Apply(all_sizes);
BENCHMARK_CAPTURE(step_film, alpha_yield_curvature_pigment,
                  Flow{.alpha_range = true, .yield_and_curvature = true, .pigment = true})
    ->Apply(plain_sizes);
BENCHMARK_CAPTURE(step_film, alpha_yield_curvature_pigment_varied,
                  Flow{
                      .alpha_range = true, .yield_and_curvature = true, .pigment = true, .varied = true})
    ->Apply(plain_sizes);
BENCHMARK_CAPTURE(step_film, alpha_yield_curvature_thinning,
                  Flow{.alpha_range = true, .yield_and_curvature = true, .shear_thinning = true})
    ->Apply(plain_sizes);

/// House paint running down a canvas that stands at 60 degrees, cells of 0.1 mm.
FilmState running_film(int n) {
    FilmState state({n, n}, 0.1);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const double h = 0.35 * (1 + 0.2 * std::sin(x * 0.15) * std::cos(y * 0.1) +
                                     0.1 * std::sin(x * 0.4 + y * 0.25));
            state.thickness.set(x, y, static_cast<std::int32_t>(h / kThicknessQuantum_mm));
        }
    return state;
}

/// One frame of a sixtieth of a second as one large step; ns per cell of processor time, after some
/// seconds of running.
void large_step(benchmark::State& run, bool yields, double after_s) {
    const int n = static_cast<int>(run.range(0));
    core::ThreadPool pool(static_cast<int>(run.range(1)));
    FilmState state = running_film(n);
    Medium paint = find_medium("house paint");
    if (!yields) paint.yield_stress_Pa = 0.0;
    SolverOptions options;
    options.edge_x = options.edge_y = Edge::Periodic;
    options.sleeping = false;
    options.scheme = Scheme::LargeStep;
    Solver solver(state, paint, options, pool);
    solver.set_gravity(tilted_gravity(60.0));
    if (after_s > 0.0) solver.advance(after_s);
    std::int64_t steps = 0, sweeps = 0;
    for (auto _ : run) {
        const AdvanceReport report = solver.advance(1.0 / 60);
        steps += report.steps;
        sweeps += report.sweeps;
    }
    const auto iterations = static_cast<double>(run.iterations());
    run.counters["ns/cell"] =
        benchmark::Counter(static_cast<double>(n) * n * 1e-9 * iterations,
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    run.counters["steps/frame"] = static_cast<double>(steps) / iterations;
    run.counters["sweeps/frame"] = static_cast<double>(sweeps) / iterations;
}

void large_sizes(benchmark::internal::Benchmark* run) {
    run->ArgNames({"side", "threads"})->Args({256, 1})->Args({512, 1})->Args({512, 2})->Args({1024, 1});
    run->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->Iterations(30);
}
BENCHMARK_CAPTURE(large_step, smooth, false, 0.5)->Apply(large_sizes);
BENCHMARK_CAPTURE(large_step, yield, true, 0.5)->Apply(large_sizes);
BENCHMARK_CAPTURE(large_step, smooth_from_rest, false, 0.0)->Apply(large_sizes);
BENCHMARK_CAPTURE(large_step, yield_from_rest, true, 0.0)->Apply(large_sizes);

/// What a frame costs when nothing moves.
void sleeping_canvas(benchmark::State& run) {
    const int n = static_cast<int>(run.range(0));
    core::ThreadPool pool(1);
    FilmState state({n, n}, 0.25);
    Solver solver(state, find_medium("heavy-body oil"), {}, pool);
    for (auto _ : run)
        solver.advance(1.0 / 60);
}
BENCHMARK(sleeping_canvas)->Arg(4096);

}  // namespace
}  // namespace pastoso::film
