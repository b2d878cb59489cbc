// Small sessions that the tests of this folder paint.
#pragma once

#include "document/painting.hpp"

#include <cmath>

namespace pastoso::document {

inline CanvasSettings small_canvas() {
    CanvasSettings canvas;
    canvas.width_mm = 40.0;
    canvas.height_mm = 30.0;
    canvas.px_per_mm = 3.0;
    return canvas;
}

inline LoadPaint load_of(const char* pigment, double fill = 1.0) {
    LoadPaint load;
    load.paint.ingredients = {{pigment, 1.0}};
    load.fill = fill;
    return load;
}

/// A sample of a wavy stroke from left to right at height y_mm; `i` from 0 to 30.
inline brush::PenSample wave_sample(double start_s, double y_mm, int i) {
    return {start_s + 0.01 * i, 5.0 + i, y_mm + 2.0 * std::sin(0.4 * i), 0.3 + 0.01 * i};
}

/// The whole stroke at once, without paint time passing.
inline void paint_wave(Painting& painting, double start_s, double y_mm) {
    painting.apply(PenDown{wave_sample(start_s, y_mm, 0)});
    for (int i = 1; i <= 30; ++i)
        painting.apply(PenMove{wave_sample(start_s, y_mm, i)});
    painting.apply(PenUp{});
}

/// A dry wave of blue acrylic; the flat that painted it stays in hand.
inline void paint_dry_wave(Painting& painting) {
    painting.apply(UseMedium{"fluid acrylic"});
    painting.apply(TakeBrush{"flat", 8, 1});
    painting.apply(load_of("PB29"));
    paint_wave(painting, 0.0, 10.0);
    painting.apply(DryNow{});
}

/// Two strokes of two colours that cross, with a tilt of runny paint, as a session with ticks.
inline Recording crossing_session() {
    Recording recording;
    recording.canvas = small_canvas();
    auto& events = recording.events;
    events = {{0, UseMedium{"fluid acrylic"}},
              {0, TiltCanvas{60, 90}},
              {0, TakeBrush{"flat", 8, 1}},
              {0, load_of("PB29")}};
    for (int i = 0; i <= 30; ++i) {
        const brush::PenSample sample = wave_sample(0.0, 10.0, i);
        if (i == 0)
            events.push_back({0, PenDown{sample}});
        else
            events.push_back({i * 2 / 3, PenMove{sample}});
    }
    events.insert(events.end(), {{20, PenUp{}}, {21, CleanBrush{}}, {21, load_of("PY35")}});
    for (int i = 0; i <= 30; ++i) {
        const brush::PenSample sample = wave_sample(0.4, 12.0, i);
        if (i == 0)
            events.push_back({24, PenDown{sample}});
        else
            events.push_back({24 + i * 2 / 3, PenMove{sample}});
    }
    events.push_back({44, PenUp{}});
    recording.end_tick = 60;
    return recording;
}

}  // namespace pastoso::document
