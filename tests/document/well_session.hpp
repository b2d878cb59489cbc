// Strokes and sessions on the mixing well.
#pragma once

#include "document/events.hpp"
#include "document/painting.hpp"
#include "document/scenes.hpp"
#include "document/well.hpp"

#include <vector>

namespace pastoso::document {

inline SqueezePaint squeeze_of(const char* pigment, double x_mm, double y_mm,
                               double volume_mm3 = 300.0) {
    return {.paint = {.ingredients = {{pigment, 1.0}}},
            .volume_mm3 = volume_mm3,
            .x_mm = x_mm,
            .y_mm = y_mm};
}

/// The pen's actions of a straight stroke at even pace, the width of a flat brush across.
inline std::vector<Action> line_on(Surface surface, double start_s, double x0_mm, double x1_mm,
                                   double y_mm) {
    constexpr int kSamples = 24;
    std::vector<Action> actions;
    for (int i = 0; i <= kSamples; ++i) {
        const double u = static_cast<double>(i) / kSamples;
        const brush::PenSample sample{.time_s = start_s + 0.4 * u,
                                      .x_mm = x0_mm + (x1_mm - x0_mm) * u,
                                      .y_mm = y_mm,
                                      .pressure = 0.6,
                                      .rotation_deg = 90.0};
        if (i == 0)
            actions.emplace_back(PenDown{sample, surface});
        else
            actions.emplace_back(PenMove{sample});
    }
    actions.emplace_back(PenUp{});
    return actions;
}

inline void apply_all(Painting& painting, const std::vector<Action>& actions) {
    for (const Action& action : actions)
        painting.apply(action);
}

/// Two paints squeezed side by side, drawn through each other by an empty brush, and painted with on the
/// canvas and back on the well.
inline Recording mixing_session() {
    Recording recording;
    recording.canvas = small_canvas();
    auto& events = recording.events;
    std::int64_t tick = 0;
    const auto stroke = [&](Surface surface, double x0_mm, double x1_mm, double y_mm) {
        const auto start_s = static_cast<double>(tick) * kTick_s;
        for (const Action& action : line_on(surface, start_s, x0_mm, x1_mm, y_mm))
            events.push_back({tick++, action});
    };
    events = {{0, UseMedium{"soft-body acrylic"}},
              {0, TiltCanvas{40, 90}},
              {0, squeeze_of("PB29", 30, 40)},
              {0, squeeze_of("PY35", 50, 40)},
              {0, TakeBrush{"flat", 8, 1}}};
    stroke(Surface::Well, 24, 56, 40);
    stroke(Surface::Well, 56, 24, 43);
    stroke(Surface::Canvas, 6, 34, 15);
    stroke(Surface::Well, 60, 90, 60);
    recording.end_tick = tick + 10;
    return recording;
}

}  // namespace pastoso::document
