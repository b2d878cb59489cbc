// Cost of strokes: processor time per pixel of travel for brushes of several sizes and bristle counts.
#include "brush/stroke.hpp"
#include "film/medium.hpp"
#include "film/support/support.hpp"
#include "pigment/palette.hpp"

#include <algorithm>

#include <benchmark/benchmark.h>

namespace pastoso::brush {
namespace {

constexpr double kPxPerMm = 8.0;

film::FilmState linen_canvas(int width, int height) {
    film::FilmState film({width, height}, 1.0 / kPxPerMm);
    core::ThreadPool pool(1);
    film.support_mm = film::named_support("linen", film.shape, film.cell_mm, 0.0, pool);
    return film;
}

/// A straight stroke along the canvas at 1000 px/s, reported every 4 ms.
void straight_stroke(Brush& brush, film::FilmState& film, double margin_mm) {
    Stroke stroke(brush, film);
    const double y_mm = film.shape.height * film.cell_mm / 2;
    const double length_mm = film.shape.width * film.cell_mm - 2 * margin_mm;
    const double speed_mm_s = 1000.0 / kPxPerMm;
    const auto at = [&](double t) {
        return PenSample{
            .time_s = t, .x_mm = margin_mm + speed_mm_s * t, .y_mm = y_mm, .rotation_deg = 90.0};
    };
    stroke.begin(at(0.0));
    for (double t = 0.004; t < length_mm / speed_mm_s; t += 0.004)
        stroke.add(at(t));
    stroke.end();
}

void paint_stroke(benchmark::State& run, const char* preset_name) {
    const auto radius_px = static_cast<int>(run.range(0));
    const double width_mm = 2 * radius_px / kPxPerMm;
    Preset preset = resized(find_preset(preset_name), width_mm);
    preset.tip.bristles = static_cast<int>(run.range(1));
    const int canvas_px = std::max(1024, 6 * radius_px);
    const film::FilmState clean = linen_canvas(canvas_px, std::max(400, 3 * radius_px));
    const film::PaintCoefficients paint = film::paint_coefficients(
        pigment::find_pigment("PB29").coefficients, film::find_medium("heavy-body oil"));
    for (auto _ : run) {
        run.PauseTiming();
        film::FilmState film = clean;
        Brush brush(preset);
        brush.load(paint, 1.0);
        run.ResumeTiming();
        straight_stroke(brush, film, width_mm);
    }
    run.counters["us/px"] =
        benchmark::Counter((canvas_px - 4.0 * radius_px) * 1e-6 * run.iterations(),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(paint_stroke, round, "Round sable 9")
    ->Args({40, 250})
    ->Args({100, 250})
    ->Args({250, 250});
BENCHMARK_CAPTURE(paint_stroke, flat, "Flat bristle 20")
    ->Args({40, 250})
    ->Args({100, 250})
    ->Args({250, 250});
BENCHMARK_CAPTURE(paint_stroke, knife, "Palette knife 17")->Args({40, 70})->Args({100, 70});

}  // namespace
}  // namespace pastoso::brush
