// What it takes to paint the stroke of a tool that the brush editor shows while a number is moved, and
// the fine one that follows.
#include "brush/preset.hpp"
#include "core/thread_pool.hpp"
#include "document/tool_sample.hpp"

#include <benchmark/benchmark.h>

namespace pastoso::document {
namespace {

/// The editor's strip at its usual width, and its cells (panels/pen/stroke_strip.cpp).
constexpr int kWidth_px = 600, kHeight_px = 108;
constexpr double kBlownCells = 4.0;

void paint_strip(benchmark::State& run, const brush::Preset& tool) {
    const ToolMark mark = mark_of(tool);
    const double coarser = mark == ToolMark::Blow ? kBlownCells : 1.0;
    const SampleBoard::Size size{.width_mm = sample_width_mm(mark_width_mm(tool), kWidth_px, kHeight_px),
                                 .width_px = kWidth_px,
                                 .height_px = kHeight_px,
                                 .cell_px = coarser * static_cast<double>(run.range(0))};
    core::ThreadPool pool(1);
    for (auto _ : run)
        benchmark::DoNotOptimize(tool_sample(tool, mark, size, pool));
}

const bool kRegistered = [] {
    for (const brush::Preset& tool : brush::bundled_presets())
        benchmark::RegisterBenchmark(("paint_strip/" + tool.name).c_str(),
                                     [&tool](benchmark::State& run) { paint_strip(run, tool); })
            ->ArgName("cell_px")
            ->Arg(2)
            ->Arg(1)
            ->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace pastoso::document
