// Undo on a canvas of 4096 x 4096 cells that is painted all over and at rest: what a stroke, its Undo
// and the tick after it take, and what the history holds.
#include "core/memory.hpp"
#include "painted_canvas.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <sys/resource.h>
#include <thread>

#include <benchmark/benchmark.h>

namespace pastoso {
namespace {

constexpr int kStrokes = 10;

double seconds_of(const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Pages of memory that were new to this process until now.
double new_pages() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_minflt);
}

/// All its tiles sleep.
std::unique_ptr<document::Painting> resting_painting(core::ThreadPool& pool) {
    core::keep_freed_memory();  // as the programs do
    document::PaintingState state = bench::painted_canvas("heavy-body oil", pool);
    state.solver = {};
    auto painting = std::make_unique<document::Painting>(state, pool);
    painting->apply(document::TakeBrush{"flat", 20.0, 1});
    return painting;
}

/// From left to right.
void stroke(document::Painting& painting, int number, double y_mm, double length_mm) {
    document::LoadPaint load;
    load.paint.ingredients = {{number % 2 == 0 ? "PB29" : "PY35", 1.0}};
    painting.apply(load);
    for (int i = 0; i <= 400; ++i) {
        const brush::PenSample sample{.time_s = number + i / 400.0,
                                      .x_mm = length_mm * i / 400.0,
                                      .y_mm = y_mm,
                                      .pressure = 0.7,
                                      .rotation_deg = 90.0};
        if (i == 0)
            painting.apply(document::PenDown{sample});
        else
            painting.apply(document::PenMove{sample});
    }
    painting.apply(document::PenUp{});
}

void stroke_across(document::Painting& painting, int number) {
    const double side_mm = painting.settings().width_mm;
    stroke(painting, number, (0.5 + number) * side_mm / kStrokes, side_mm);
}

/// The latest stroke, from a canvas that rested before it; on the canvas's layer or on one above it.
void undo_latest(benchmark::State& state) {
    core::ThreadPool pool(2);
    const auto painting = resting_painting(pool);
    for (std::int64_t layers = 1; layers < state.range(0); ++layers)
        painting->apply(document::AddLayer{"Above"});
    double undo_s = 0.0, tick_s = 0.0;
    for (auto _ : state) {
        stroke_across(*painting, 0);
        painting->advance_tick();
        undo_s += seconds_of([&] { painting->apply(document::Undo{}); });
        tick_s += seconds_of([&] { painting->advance_tick(); });
    }
    const auto count = static_cast<double>(state.iterations());
    state.counters["undo_ms"] = 1e3 * undo_s / count;
    state.counters["tick_after_ms"] = 1e3 * tick_s / count;
}
BENCHMARK(undo_latest)->ArgName("layers")->Arg(1)->Arg(2)->Iterations(3)->Unit(benchmark::kMillisecond);

/// Many strokes, after the history has had time to pack them; with so many milliseconds between two
/// steps.
void undo_many(benchmark::State& state) {
    core::ThreadPool pool(2);
    const auto painting = resting_painting(pool);
    painting->apply(document::TakeBrush{"flat", static_cast<double>(state.range(0)), 1});
    painting->set_history_budget(static_cast<std::size_t>(state.range(2)) << 20);
    const double side_mm = painting->settings().height_mm;
    for (int i = 0; i < kStrokes; ++i)
        stroke(*painting, i, (0.5 + i) * side_mm / kStrokes, static_cast<double>(state.range(1)));
    std::this_thread::sleep_for(std::chrono::seconds(5));
    std::size_t packed_bytes = 0, packed = 0;
    for (const document::KeptStep& step : painting->undo_steps()) {
        if (!step.packed) continue;
        packed_bytes += step.bytes;
        ++packed;
    }
    double undo_s = 0.0, longest_s = 0.0;
    const double pages = new_pages();
    for (auto _ : state)
        for (int i = 0; i < kStrokes; ++i) {
            const double one_s = seconds_of([&] { painting->apply(document::Undo{}); });
            undo_s += one_s;
            longest_s = std::max(longest_s, one_s);
            std::this_thread::sleep_for(std::chrono::milliseconds(state.range(3)));
        }
    state.counters["undo_ms"] = 1e3 * undo_s / kStrokes;
    state.counters["longest_ms"] = 1e3 * longest_s;
    state.counters["new_pages"] = (new_pages() - pages) / kStrokes;
    state.counters["packed_steps"] = static_cast<double>(packed);
    state.counters["packed_MB"] = 1e-6 * static_cast<double>(packed_bytes);
}
BENCHMARK(undo_many)
    ->ArgNames({"width_mm", "length_mm", "budget_MiB", "pause_ms"})
    ->Args({8, 60, 64, 0})
    ->Args({20, 200, 512, 0})
    ->Args({20, 410, 512, 0})
    ->Args({20, 410, 256, 0})
    ->Args({20, 410, 512, 33})
    ->Args({20, 410, 256, 33})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

/// How many of two hundred strokes, wet in wet, can be undone.
void steps_kept(benchmark::State& state) {
    constexpr int kManyStrokes = 200;
    core::ThreadPool pool(2);
    const auto painting = resting_painting(pool);
    painting->apply(document::TakeBrush{"flat", static_cast<double>(state.range(0)), 1});
    painting->set_history_budget(static_cast<std::size_t>(state.range(2)) << 20);
    const double step_mm = painting->settings().height_mm / kManyStrokes;
    for (auto _ : state)
        for (int i = 0; i < kManyStrokes; ++i)
            stroke(*painting, i, (0.5 + i) * step_mm, static_cast<double>(state.range(1)));
    for (; painting->can_undo(); painting->apply(document::Undo{}))
        state.counters["steps"] += 1.0;
}
BENCHMARK(steps_kept)
    ->ArgNames({"width_mm", "length_mm", "budget_MiB"})
    ->Args({8, 60, 512})
    ->Args({20, 200, 512})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

void pen_down(benchmark::State& state) {
    core::ThreadPool pool(2);
    const auto painting = resting_painting(pool);
    stroke_across(*painting, 0);
    const brush::PenSample sample{.time_s = 0.0, .x_mm = 50.0, .y_mm = 50.0, .pressure = 0.0};
    for (auto _ : state) {
        painting->apply(document::PenDown{sample});
        painting->apply(document::PenUp{});
    }
}
BENCHMARK(pen_down)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pastoso
