// Recordings of a flat brush on a small, steep canvas.
#pragma once

#include "document/events.hpp"

#include <cstdint>
#include <utility>

namespace pastoso::tests {

/// Runny paint on 40 x 30 mm, so that every tick shows; no stroke yet.
inline document::Recording runny_recording(double px_per_mm, std::int64_t end_tick) {
    document::CanvasSettings canvas;
    canvas.width_mm = 40.0;
    canvas.height_mm = 30.0;
    canvas.px_per_mm = px_per_mm;
    document::LoadPaint dip;
    dip.paint.ingredients = {{"PB29", 1.0}};
    document::Recording recording{canvas, {}, end_tick};
    recording.events = {{0, document::UseMedium{"house paint"}},
                        {0, document::TiltCanvas{60.0, 90.0}},
                        {0, document::TakeBrush{"Flat bristle 20", 8.0, 1}},
                        {0, dip}};
    return recording;
}

/// A millimetre a tick, for 25 of them.
inline void add_stroke(document::Recording& recording, std::int64_t tick, double y_mm) {
    const auto add = [&](std::int64_t later, document::Action action) {
        recording.events.push_back({tick + later, std::move(action)});
    };
    const auto sample_at = [&](int i) {
        brush::PenSample sample;
        sample.time_s = static_cast<double>(tick + i) * document::kTick_s;
        sample.x_mm = 6.0 + i;
        sample.y_mm = y_mm;
        return sample;
    };
    add(0, document::PenDown{sample_at(0)});
    for (int i = 1; i <= 25; ++i)
        add(i, document::PenMove{sample_at(i)});
    add(26, document::PenUp{});
}

}  // namespace pastoso::tests
