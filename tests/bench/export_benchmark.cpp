// Large exports: time, and the memory that they take beside the painting.
#include "recordings/layer_export.hpp"
#include "recordings/map_export.hpp"
#include "recordings/picture_export.hpp"
#include "recordings/relief_export.hpp"
#include "shade/canvas.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <benchmark/benchmark.h>

namespace pastoso::files {
namespace {

const KeepGoing kToTheEnd = [](double) { return true; };

/// Random paint on every cell of a canvas of some cells a side, from one piece.
film::FilmState painted(int side) {
    constexpr int kPiece = 512;
    const film::FilmState piece = test::random_canvas({kPiece, kPiece}, 1);
    film::FilmState film({side, side}, 0.25);
    const int tiles = kPiece / grid::kTileSize;
    for (int tile = 0; tile < film.shape.tile_count(); ++tile) {
        const int x = tile % film.shape.tiles_x() % tiles, y = tile / film.shape.tiles_x() % tiles;
        const int source = y * tiles + x;
        film.thickness.replace(tile, piece.thickness.block(source));
        film.paint.replace(tile, piece.paint.block(source));
        film.support_mm.replace(tile, piece.support_mm.block(source));
    }
    return film;
}

/// A line of /proc/self/status, in MB; 0 where it is not told.
double status_MB(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(name)) return std::atof(line.c_str() + name.size()) / 1024.0;
    return 0.0;
}

/// Starts the peak of memory anew (proc(5)).
void forget_peak() {
    std::ofstream("/proc/self/clear_refs") << "5";
}

std::filesystem::path bench_path(const char* extension) {
    const char* folder = std::getenv("PASTOSO_BENCH_FOLDER");
    return (folder != nullptr ? std::filesystem::path(folder) : std::filesystem::temp_directory_path()) /
           (std::string("benchmark-export") + extension);
}

template <class Export>
void measure(benchmark::State& run, const std::filesystem::path& path, const Export& work) {
    forget_peak();
    const double before_MB = status_MB("VmRSS:");
    for (auto _ : run)
        work(path);
    run.counters["peak_MB"] = status_MB("VmHWM:");
    run.counters["beside_MB"] = status_MB("VmHWM:") - before_MB;
    run.counters["file_MB"] = 1e-6 * static_cast<double>(std::filesystem::file_size(path));
    std::filesystem::remove(path);
}

/// Arguments: cells of a side, pixels of a side.
void picture(benchmark::State& run, const char* extension, int depth_bits) {
    core::ThreadPool pool;
    const film::FilmState film = painted(static_cast<int>(run.range(0)));
    recordings::ExportSource source{film, test::kGround, {}};
    source.settings.scale = static_cast<double>(run.range(1)) / static_cast<double>(run.range(0));
    measure(run, bench_path(extension), [&](const std::filesystem::path& path) {
        recordings::export_picture(path, source, {depth_bits, {}}, pool, kToTheEnd);
    });
}

void layers(benchmark::State& run) {
    core::ThreadPool pool;
    const film::FilmState film = painted(static_cast<int>(run.range(0)));
    recordings::ExportSource source{film, test::kGround, {}};
    source.settings.scale = static_cast<double>(run.range(1)) / static_cast<double>(run.range(0));
    const film::SupportHeights bare_mm(film.shape);
    const recordings::ChannelLayers apart =
        recordings::channel_layers(film, bare_mm, document::single_layer());
    measure(run, bench_path(".exr"), [&](const std::filesystem::path& path) {
        recordings::export_layers(path, source, apart, pool, kToTheEnd);
    });
}

/// Argument: cells of a side, each a step of the relief.
void relief(benchmark::State& run) {
    core::ThreadPool pool;
    const film::FilmState film = painted(static_cast<int>(run.range(0)));
    measure(run, bench_path(".stl"), [&](const std::filesystem::path& path) {
        recordings::export_relief(path, recordings::relief_of(film, {2.0, 1.0, film.cell_mm}, pool),
                                  kToTheEnd);
    });
}

BENCHMARK_CAPTURE(picture, jpeg_8, ".jpg", 8)
    ->Args({2048, 8192})
    ->Args({2048, 16384})
    ->UseRealTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(picture, png_8, ".png", 8)
    ->Args({2048, 8192})
    ->Args({2048, 32768})
    ->UseRealTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(layers)->Args({2048, 8192})->UseRealTime()->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(relief)->Arg(2048)->UseRealTime()->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pastoso::files
