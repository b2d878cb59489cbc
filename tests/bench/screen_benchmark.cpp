// Cost of the picture of a window that the processor draws.
#include "screen/raster_picture.hpp"

#include <cmath>

#include <benchmark/benchmark.h>

namespace pastoso::screen {
namespace {

constexpr int kWidth = 2400, kHeight = 1600;
constexpr QSize kWindow_px(1000, 700);

/// Thick strokes at 8 px/mm.
std::shared_ptr<document::Snapshot> painted() {
    auto snapshot = std::make_shared<document::Snapshot>();
    snapshot->film = film::FilmState({kWidth, kHeight}, 0.125);
    snapshot->ground = {0.90F, 0.93F, 0.93F, 0.93F, 0.93F, 0.93F};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double h = 0.3 + 0.1 * std::sin(x * 0.5) * std::cos(y * 0.1);
            snapshot->film.thickness.set(x, y,
                                         static_cast<std::int32_t>(h / film::kThicknessQuantum_mm));
            film::PaintCell cell;
            for (int k = 0; k < pigment::kChannels; ++k)
                cell[k] = static_cast<std::int32_t>((10 + 7 * k + x % 5) * h / film::kPaintQuantum);
            snapshot->film.paint.set(x, y, cell);
        }
    return snapshot;
}

const std::shared_ptr<document::Snapshot>& painting() {
    static const auto snapshot = painted();
    return snapshot;
}

RasterScene scene_at(double zoom, double angle_deg) {
    ViewTransform view = fitted({kWidth, kHeight}, {kWindow_px.width(), kWindow_px.height()});
    if (zoom > 0.0) view = zoomed(view, {500.0, 350.0}, zoom / view.zoom);
    return {{painting(), {}, {}, {}, Look::Lit},
            turned(view, {500.0, 350.0}, angle_deg),
            kWindow_px,
            {},
            {}};
}

/// As it is to be, whatever of it is a draft at first.
void show(RasterPicture& picture, const RasterScene& scene, core::ThreadPool& pool) {
    picture.show(scene, pool);
    while (picture.is_draft())
        picture.refine(pool);
}

/// All of a canvas that was not seen before.
void draw_other_canvas(benchmark::State& run) {
    core::ThreadPool pool;
    const RasterScene scene = scene_at(0.0, 0.0);
    for (auto _ : run) {
        RasterPicture picture;
        show(picture, scene, pool);
        benchmark::DoNotOptimize(picture.image().constBits());
    }
}
BENCHMARK(draw_other_canvas)->UseRealTime()->Unit(benchmark::kMillisecond);

/// From another place: `zoom` hundredths of a pixel a cell (0: the whole canvas), turned by degrees.
void draw_window(benchmark::State& run) {
    core::ThreadPool pool;
    RasterScene scene =
        scene_at(0.01 * static_cast<double>(run.range(0)), static_cast<double>(run.range(1)));
    RasterPicture picture;
    show(picture, scene, pool);
    for (auto _ : run) {
        scene.view.origin_px.x += 1.0;
        show(picture, scene, pool);
        benchmark::DoNotOptimize(picture.image().constBits());
    }
}
BENCHMARK(draw_window)
    ->Args({0, 0})
    ->Args({0, 20})
    ->Args({100, 0})
    ->Args({400, 0})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// A cube that swaps red and green, as none of a screen does.
appearance::ScreenCube swapping_cube() {
    auto cube = std::make_shared<pigment::ColourCube>();
    constexpr int kSide = pigment::ColourCube::kSide;
    for (int i = 0; i < kSide * kSide * kSide; ++i)
        cube->nodes[i].shown = {pigment::ColourCube::value_at(i / kSide % kSide),
                                pigment::ColourCube::value_at(i % kSide),
                                pigment::ColourCube::value_at(i / kSide / kSide)};
    return cube;
}

/// From another place, through the colours of a screen; the arguments are those of draw_window.
void draw_window_in_colours(benchmark::State& run) {
    core::ThreadPool pool;
    RasterScene scene =
        scene_at(0.01 * static_cast<double>(run.range(0)), static_cast<double>(run.range(1)));
    scene.colours = swapping_cube();
    RasterPicture picture;
    show(picture, scene, pool);
    for (auto _ : run) {
        scene.view.origin_px.x += 1.0;
        show(picture, scene, pool);
        benchmark::DoNotOptimize(picture.image().constBits());
    }
}
BENCHMARK(draw_window_in_colours)
    ->Args({100, 0})
    ->Args({400, 0})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// Another profile of the screen.
void draw_other_colours(benchmark::State& run) {
    core::ThreadPool pool;
    RasterScene scene = scene_at(1.0, 0.0);
    const appearance::ScreenCube cubes[] = {swapping_cube(), swapping_cube()};
    RasterPicture picture;
    show(picture, scene, pool);
    std::size_t turn = 0;
    for (auto _ : run) {
        scene.colours = cubes[turn++ % 2];
        show(picture, scene, pool);
        benchmark::DoNotOptimize(picture.image().constBits());
    }
}
BENCHMARK(draw_other_colours)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Paint of so many tiles is another.
void draw_tiles(benchmark::State& run) {
    core::ThreadPool pool;
    RasterScene scene = scene_at(1.0, 0.0);
    RasterPicture picture;
    show(picture, scene, pool);
    for (auto _ : run) {
        auto next = std::make_shared<document::Snapshot>(*scene.sight.painting);
        for (int tile = 0; tile < run.range(0); ++tile)
            next->film.thickness.set(1000 + tile * grid::kTileSize, 800, 1);
        scene.sight.painting = next;
        show(picture, scene, pool);
    }
}
BENCHMARK(draw_tiles)->Arg(1)->Arg(4)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pastoso::screen
