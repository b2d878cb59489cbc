#include "interactions/guides.hpp"

#include "core/units.hpp"
#include "interactions/event_place.hpp"
#include "interactions/guide_lines.hpp"
#include "interactions/guide_ways.hpp"

#include <cmath>

namespace pastoso::interactions {
namespace {

using view::Took;

/// So near to a handle a press takes hold of it.
constexpr double kReach_px = 9.0;

}  // namespace

void Guides::show_handles(bool shown) {
    handles_shown_ = shown;
    canvas_.refresh();
}

Took Guides::press(const input::PointerEvent& event) {
    if (!handles_shown_ || event.button != Qt::LeftButton) return Took::Nothing;
    const bool held = drag_.press(easel_.hand(), place_mm(event), canvas_.canvas_size_mm(),
                                  kReach_px * canvas_.px_mm());
    return held ? Took::Pointer : Took::Nothing;
}

void Guides::drag(const input::PointerEvent& event) {
    const bool square = event.modifiers.testFlag(Qt::ShiftModifier);
    if (const auto guide = drag_.move(easel_.hand(), place_mm(event), square)) Q_EMIT dragged(*guide);
}

void Guides::draw(const view::Overlay& overlay) {
    constexpr float kFaint = 0.6F, kFaintest = 0.3F;
    const glm::dvec2 canvas_mm = canvas_.canvas_size_mm();
    overlay.painter.draw_segments(ways_mm(easel_.hand().laid, canvas_mm), overlay.canvas, kFaintest);
    overlay.painter.draw_segments(guide_lines_mm(easel_.hand(), canvas_mm), overlay.canvas, kFaint);
    if (handles_shown_) draw_handles(overlay);
}

/// Rings that keep their size on the screen.
void Guides::draw_handles(const view::Overlay& overlay) const {
    constexpr double kRadius_px = 5.0;
    constexpr int kCorners = 20;
    const double radius_mm = kRadius_px * overlay.px_mm;
    const auto handles = tools::guide_handles(easel_.hand(), canvas_.canvas_size_mm());
    for (const tools::PlacedHandle& handle : handles) {
        std::vector<glm::vec2> ring;
        for (int i = 0; i < kCorners; ++i) {
            const double angle = 2.0 * core::kPi * i / kCorners;
            ring.emplace_back(handle.place_mm +
                              radius_mm * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
        overlay.painter.draw_loop(ring, overlay.canvas, 1.0F);
    }
}

}  // namespace pastoso::interactions
