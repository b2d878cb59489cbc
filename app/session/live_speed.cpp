#include "session/live_speed.hpp"

#include "document/painting.hpp"

#include <chrono>
#include <cmath>

namespace pastoso::session {
namespace {

using namespace document;

constexpr double kMostLoad = 0.2;
constexpr double kFinest[] = {8.0, 6.0};
constexpr double kCoarsest = 4.0;

/// The first ticks are for caches and threads.
constexpr int kFirstTicks = 6, kMeasuredTicks = 30;
constexpr int kSamplesPerTick = 3;
/// By then it is known that it takes too long.
constexpr double kLongest_s = 0.5;

constexpr double kWidth_mm = 120.0, kHeight_mm = 80.0, kMargin_mm = 25.0;
constexpr double kSpeed_mm_s = 200.0;

/// To and fro along the canvas, and slowly down.
brush::PenSample sample_at(double time_s) {
    const double way_mm = kWidth_mm - 2.0 * kMargin_mm;
    const double gone = std::fmod(kSpeed_mm_s * time_s / way_mm, 2.0);
    brush::PenSample sample;
    sample.time_s = time_s;
    sample.x_mm = kMargin_mm + way_mm * (gone < 1.0 ? gone : 2.0 - gone);
    sample.y_mm = kMargin_mm + 0.1 * kSpeed_mm_s * time_s;
    return sample;
}

void take_up(Painting& painting) {
    painting.apply(UseMedium{"heavy-body oil"});
    painting.apply(TakeBrush{"Flat bristle 20", 20.0, 1});
    LoadPaint dip;
    dip.paint.ingredients = {{"PB29", 1.0}};
    painting.apply(dip);
    painting.apply(PenDown{sample_at(0.0)});
}

void paint_tick(Painting& painting) {
    const double begin_s = static_cast<double>(painting.tick()) * kTick_s;
    for (int i = 1; i <= kSamplesPerTick; ++i)
        painting.apply(PenMove{sample_at(begin_s + i * kTick_s / kSamplesPerTick)});
    painting.advance_tick();
}

}  // namespace

double painting_load(double px_per_mm, core::ThreadPool& pool) {
    using Clock = std::chrono::steady_clock;
    CanvasSettings canvas;
    canvas.width_mm = kWidth_mm;
    canvas.height_mm = kHeight_mm;
    canvas.px_per_mm = px_per_mm;
    Painting painting(canvas, pool);
    painting.set_history_budget(0);
    take_up(painting);
    for (int tick = 0; tick < kFirstTicks; ++tick)
        paint_tick(painting);
    const Clock::time_point begun = Clock::now();
    int ticks = 0;
    double taken_s = 0.0;
    while (ticks < kMeasuredTicks && taken_s < kLongest_s) {
        paint_tick(painting);
        ++ticks;
        taken_s = std::chrono::duration<double>(Clock::now() - begun).count();
    }
    return taken_s / (ticks * kTick_s);
}

double live_px_per_mm(const std::function<double(double px_per_mm)>& load_at) {
    for (const double px_per_mm : kFinest)
        if (load_at(px_per_mm) < kMostLoad) return px_per_mm;
    return kCoarsest;
}

}  // namespace pastoso::session
