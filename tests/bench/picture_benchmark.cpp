// Cost of pictures that become paint.
#include "core/random.hpp"
#include "layers/flat_paint.hpp"
#include "pigment/rgb_bands.hpp"
#include "pigment/smooth_bands.hpp"

#include <vector>

#include <benchmark/benchmark.h>

namespace pastoso::layers {
namespace {

std::vector<pigment::LinearRgb> random_colours() {
    std::vector<pigment::LinearRgb> colours(1024);
    for (std::uint32_t i = 0; i < colours.size(); ++i)
        colours[i] = {core::uniform_noise(i, 1), core::uniform_noise(i, 2), core::uniform_noise(i, 3)};
    return colours;
}

template <class Fit>
void colours(benchmark::State& run, const Fit& fit) {
    const std::vector<pigment::LinearRgb> colours = random_colours();
    benchmark::DoNotOptimize(fit(colours[0]));
    std::size_t next = 0;
    for (auto _ : run)
        benchmark::DoNotOptimize(fit(colours[next++ % colours.size()]));
}
void rgb_bands(benchmark::State& run) {
    colours(run, pigment::rgb_bands);
}
void smooth_bands(benchmark::State& run) {
    colours(run, pigment::smooth_bands);
}
BENCHMARK(rgb_bands);
BENCHMARK(smooth_bands);

void flat_paint_of_2048_squared(benchmark::State& run) {
    pigment::Picture picture{2048, 2048, {}};
    for (std::uint32_t i = 0; i < 4U * 2048 * 2048; ++i)
        picture.rgba.push_back(static_cast<std::uint8_t>(256.0F * core::uniform_noise(i, 5)));
    core::ThreadPool pool;
    for (auto _ : run)
        benchmark::DoNotOptimize(flat_paint(picture, {0, 0, 512, 512}, {2048, 2048}, 0.25, pool));
}
BENCHMARK(flat_paint_of_2048_squared)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pastoso::layers
