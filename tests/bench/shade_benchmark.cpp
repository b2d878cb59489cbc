// Cost of colouring a tile and of rendering a canvas.
#include "shade/render.hpp"
#include "shade/tile_colour.hpp"

#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>

namespace pastoso::shade {
namespace {

constexpr pigment::Bands kGround = {0.90F, 0.93F, 0.93F, 0.93F, 0.93F, 0.93F};

film::FilmState painted(int width, int height) {
    film::FilmState state({width, height}, 0.25);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double h = 0.3 + 0.1 * std::sin(x * 0.5) * std::cos(y * 0.1);
            state.thickness.set(x, y, static_cast<std::int32_t>(h / film::kThicknessQuantum_mm));
            film::PaintCell cell;
            for (int k = 0; k < pigment::kChannels; ++k)
                cell[k] = static_cast<std::int32_t>((10 + 7 * k + x % 5) * h / film::kPaintQuantum);
            state.paint.set(x, y, cell);
        }
    return state;
}

void colour_tile(benchmark::State& run) {
    const film::FilmState state = painted(64, 64);
    std::vector<CellColour> colours(grid::kTileCells);
    for (auto _ : run) {
        tile_colours(state, 0, kGround, colours.data());
        benchmark::DoNotOptimize(colours.data());
    }
}
BENCHMARK(colour_tile)->Unit(benchmark::kMicrosecond);

void render_canvas(benchmark::State& run) {
    const film::FilmState state = painted(1200, 800);
    core::ThreadPool pool(static_cast<int>(run.range(0)));
    for (auto _ : run)
        benchmark::DoNotOptimize(render(state, kGround, state.shape.cells(), {}, pool));
}
BENCHMARK(render_canvas)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pastoso::shade
