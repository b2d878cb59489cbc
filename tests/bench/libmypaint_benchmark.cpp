// The same long stroke painted by libmypaint, plain and in its pigment mode, and by this engine.
#include "brush/stroke.hpp"
#include "core/units.hpp"
#include "film/medium.hpp"
#include "film/support/support.hpp"
#include "pigment/palette.hpp"

#include <cmath>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

extern "C" {
#include <libmypaint/mypaint-brush.h>
#include <libmypaint/mypaint-tiled-surface.h>
}

namespace pastoso::brush {
namespace {

constexpr int kCanvas_px = 2048;
constexpr int kEvents = 1000;
constexpr double kLength_px = 20000.0, kSpeed_px_s = 1000.0;
constexpr double kPxPerMm = 8.0;

/// A spiral of evenly spaced events from the middle of the canvas outwards.
struct SpiralEvent {
    double time_s, x_px, y_px, angle_deg;
};
std::vector<SpiralEvent> spiral() {
    constexpr double kOuter_px = 880.0;
    // Length of a wide spiral: half its outer radius times its angle.
    const double whole_angle = 2.0 * kLength_px / kOuter_px;
    std::vector<SpiralEvent> events;
    for (int i = 0; i < kEvents; ++i) {
        const double share = std::sqrt((i + 1.0) / kEvents);
        const double angle = whole_angle * share;
        events.push_back({i * kLength_px / kEvents / kSpeed_px_s,
                          kCanvas_px / 2 + kOuter_px * share * std::cos(angle),
                          kCanvas_px / 2 + kOuter_px * share * std::sin(angle), core::degrees(angle)});
    }
    return events;
}

/// libmypaint's surface over tiles that lie in one piece of memory.
struct MypaintCanvas {
    MyPaintTiledSurface2 surface;  // first, so that the callbacks can be handed this
    std::vector<guint16> tiles;
    std::vector<guint16> beyond;
};

void lend_tile(MyPaintTiledSurface2* surface, MyPaintTileRequest* request) {
    constexpr int kTilesAcross = kCanvas_px / MYPAINT_TILE_SIZE;
    constexpr std::size_t kTileValues = 4 * MYPAINT_TILE_SIZE * MYPAINT_TILE_SIZE;
    auto* canvas = reinterpret_cast<MypaintCanvas*>(surface);
    const bool inside =
        request->tx >= 0 && request->ty >= 0 && request->tx < kTilesAcross && request->ty < kTilesAcross;
    const auto tile = static_cast<std::size_t>(request->ty * kTilesAcross + request->tx);
    request->buffer = inside ? &canvas->tiles[tile * kTileValues] : canvas->beyond.data();
}

void return_tile(MyPaintTiledSurface2*, MyPaintTileRequest*) {}

/// libmypaint's own defaults, with an opaque, hard, round dab.
MyPaintBrush* mypaint_brush(double radius_px, bool pigment) {
    MyPaintBrush* brush = mypaint_brush_new();
    mypaint_brush_from_defaults(brush);
    const auto set = [&](MyPaintBrushSetting setting, double value) {
        mypaint_brush_set_base_value(brush, setting, static_cast<float>(value));
    };
    set(MYPAINT_BRUSH_SETTING_RADIUS_LOGARITHMIC, std::log(radius_px));
    set(MYPAINT_BRUSH_SETTING_OPAQUE, 1.0);
    set(MYPAINT_BRUSH_SETTING_HARDNESS, 1.0);
    set(MYPAINT_BRUSH_SETTING_COLOR_H, 0.6);
    set(MYPAINT_BRUSH_SETTING_COLOR_S, 0.8);
    set(MYPAINT_BRUSH_SETTING_COLOR_V, 0.5);
    set(MYPAINT_BRUSH_SETTING_PAINT_MODE, pigment ? 1.0 : 0.0);
    return brush;
}

void mypaint_stroke(MyPaintBrush* brush, MypaintCanvas& canvas, const std::vector<SpiralEvent>& events) {
    auto* surface = reinterpret_cast<MyPaintSurface2*>(&canvas.surface);
    for (const SpiralEvent& event : events) {
        mypaint_tiled_surface2_begin_atomic(&canvas.surface);
        mypaint_brush_stroke_to_2(brush, surface, static_cast<float>(event.x_px),
                                  static_cast<float>(event.y_px), 0.5F, 0.0F, 0.0F,
                                  kLength_px / kEvents / kSpeed_px_s, 1.0F, 0.0F, 0.0F);
        mypaint_tiled_surface2_end_atomic(&canvas.surface, nullptr);
    }
}

void libmypaint(benchmark::State& run, bool pigment) {
    const std::vector<SpiralEvent> events = spiral();
    for (auto _ : run) {
        run.PauseTiming();
        auto canvas = std::make_unique<MypaintCanvas>();
        mypaint_tiled_surface2_init(&canvas->surface, lend_tile, return_tile);
        canvas->tiles.assign(std::size_t{4} * kCanvas_px * kCanvas_px, 0);
        canvas->beyond.assign(std::size_t{4} * MYPAINT_TILE_SIZE * MYPAINT_TILE_SIZE, 0);
        MyPaintBrush* brush = mypaint_brush(static_cast<double>(run.range(0)), pigment);
        run.ResumeTiming();
        mypaint_stroke(brush, *canvas, events);
        run.PauseTiming();
        mypaint_brush_unref(brush);
        mypaint_tiled_surface2_destroy(&canvas->surface);
        canvas.reset();
        run.ResumeTiming();
    }
}
BENCHMARK_CAPTURE(libmypaint, plain, false)->Arg(20)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(libmypaint, pigment, true)->Arg(20)->Arg(100)->Unit(benchmark::kMillisecond);

/// A brush 2 x `radius_px` wide whose load lasts the whole stroke.
Brush loaded_brush(const char* preset_name, double radius_px) {
    Preset preset = resized(find_preset(preset_name), 2.0 * radius_px / kPxPerMm);
    preset.paint.run_mm = 2.0 * kLength_px / kPxPerMm;
    Brush brush(preset);
    brush.load(film::paint_coefficients(pigment::find_pigment("PB29").coefficients,
                                        film::find_medium("heavy-body oil")),
               1.0);
    return brush;
}

void own_stroke(Brush& brush, film::FilmState& film, const std::vector<SpiralEvent>& events) {
    Stroke stroke(brush, film);
    for (const SpiralEvent& event : events) {
        const PenSample sample = {.time_s = event.time_s,
                                  .x_mm = event.x_px / kPxPerMm,
                                  .y_mm = event.y_px / kPxPerMm,
                                  .pressure = 0.5,
                                  .rotation_deg = event.angle_deg};  // broadside on
        if (&event == &events.front())
            stroke.begin(sample);
        else
            stroke.add(sample);
    }
    stroke.end();
}

/// Lets every tile have its own memory before the stroke, as those of the other canvas have.
void take_memory(film::FilmState& film) {
    for (int tile = 0; tile < film.shape.tile_count(); ++tile) {
        film.thickness.write(tile)[0] = 0;
        film.paint.write(tile)[0] = {};
    }
}

void pastoso_stroke(benchmark::State& run, const char* preset_name) {
    const std::vector<SpiralEvent> events = spiral();
    film::FilmState clean({kCanvas_px, kCanvas_px}, 1.0 / kPxPerMm);
    core::ThreadPool pool(1);
    clean.support_mm = film::named_support("linen", clean.shape, clean.cell_mm, 0.0, pool);
    for (auto _ : run) {
        run.PauseTiming();
        auto film = std::make_unique<film::FilmState>(clean);
        take_memory(*film);
        Brush brush = loaded_brush(preset_name, static_cast<double>(run.range(0)));
        run.ResumeTiming();
        own_stroke(brush, *film, events);
        run.PauseTiming();
        film.reset();
        run.ResumeTiming();
    }
}
BENCHMARK_CAPTURE(pastoso_stroke, flat, "Flat bristle 20")
    ->Arg(20)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pastoso_stroke, round, "Round sable 9")
    ->Arg(20)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pastoso::brush
