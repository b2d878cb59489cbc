// Saving and loading a fully painted canvas of 4096 x 4096 cells.
#include "painted_canvas.hpp"
#include "project/project.hpp"

#include <cstdlib>
#include <filesystem>

#include <benchmark/benchmark.h>

namespace pastoso::project {
namespace {

Project painted_project(const char* medium, core::ThreadPool& pool) {
    document::PaintingState painting = bench::painted_canvas(medium, pool);
    const document::CanvasSettings settings = painting.value.bare->settings;
    return {std::move(painting), {settings, {}, 0}};
}

/// PASTOSO_BENCH_FOLDER says where to; a disk in memory leaves the disk's own speed out.
std::filesystem::path bench_path() {
    const char* folder = std::getenv("PASTOSO_BENCH_FOLDER");
    return (folder != nullptr ? std::filesystem::path(folder) : std::filesystem::temp_directory_path()) /
           "benchmark.pastoso";
}

void report_sizes(benchmark::State& run, const std::filesystem::path& path) {
    double raw = 0.0;
    for (const KindSize& size : project_summary(path).sizes) {
        raw += static_cast<double>(size.bytes);
        if (size.bytes > 1'000'000)
            run.counters[size.kind] =
                static_cast<double>(size.packed_bytes) / static_cast<double>(size.bytes);
    }
    run.counters["MB"] = 1e-6 * static_cast<double>(std::filesystem::file_size(path));
    run.counters["raw_MB"] = 1e-6 * raw;
    run.counters["share"] = static_cast<double>(std::filesystem::file_size(path)) / raw;
}

void save_painting(benchmark::State& run, const char* medium) {
    core::ThreadPool pool;
    const Project project = painted_project(medium, pool);
    for (auto _ : run)
        save_project(bench_path(), project, pool);
    report_sizes(run, bench_path());
}

void load_painting(benchmark::State& run, const char* medium) {
    core::ThreadPool pool;
    save_project(bench_path(), painted_project(medium, pool), pool);
    for (auto _ : run)
        benchmark::DoNotOptimize(load_project(bench_path(), pool));
    std::filesystem::remove(bench_path());
}

BENCHMARK_CAPTURE(save_painting, standing_oil, "heavy-body oil")
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load_painting, standing_oil, "heavy-body oil")
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(save_painting, running_paint, "house paint")
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load_painting, running_paint, "house paint")
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pastoso::project
