#include "interactions/guides.hpp"

#include "core/units.hpp"
#include "interactions/event_place.hpp"
#include "interactions/guide_lines.hpp"

#include <algorithm>
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

/// How far from its centre a mirror is turned.
double Guides::axis_mm() const {
    constexpr double kShare = 0.4;
    const glm::dvec2 canvas = canvas_.canvas_size_mm();
    return kShare * std::min(canvas.x, canvas.y);
}

Took Guides::press(const input::PointerEvent& event) {
    if (!handles_shown_ || event.button != Qt::LeftButton) return Took::Nothing;
    const bool held =
        drag_.press(easel_.hand(), place_mm(event), axis_mm(), kReach_px * canvas_.px_mm());
    return held ? Took::Pointer : Took::Nothing;
}

void Guides::drag(const input::PointerEvent& event) {
    const bool square = event.modifiers.testFlag(Qt::ShiftModifier);
    if (const auto guide = drag_.move(easel_.hand(), place_mm(event), square)) Q_EMIT dragged(*guide);
}

void Guides::draw(const view::Overlay& overlay) {
    constexpr float kFaint = 0.6F;
    overlay.painter.draw_segments(guide_lines_mm(easel_.hand(), canvas_.canvas_size_mm()),
                                  overlay.canvas, kFaint);
    if (handles_shown_) draw_handles(overlay);
}

/// Rings that keep their size on the screen.
void Guides::draw_handles(const view::Overlay& overlay) const {
    constexpr double kRadius_px = 5.0;
    constexpr int kCorners = 20;
    const double radius_mm = kRadius_px * overlay.px_mm;
    for (const tools::PlacedHandle& handle : tools::guide_handles(easel_.hand(), axis_mm())) {
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
