#include "interactions/gradient_line.hpp"

#include "interactions/event_place.hpp"
#include "interactions/stepped_way.hpp"

#include <utility>

#include <QKeyEvent>
#include <glm/geometric.hpp>

namespace pastoso::interactions {
namespace {

using view::Took;

/// The hand of a click trembles by less.
constexpr double kClick_px = 3.0;

/// Half as long is the stroke across each end.
constexpr double kEnd_px = 16.0;

}  // namespace

void GradientLine::draw_next(bool on) {
    on_ = on;
    line_.reset();
    canvas_.refresh();
}

Took GradientLine::press(const input::PointerEvent& event) {
    if (!on_ || event.button != Qt::LeftButton) return Took::Nothing;
    line_ = {place_mm(event), place_mm(event)};
    return Took::Pointer;
}

void GradientLine::drag(const input::PointerEvent& event) {
    if (!line_) return;
    const glm::dvec2 way = place_mm(event) - line_->from_mm;
    line_->to_mm = line_->from_mm + (event.modifiers.testFlag(Qt::ShiftModifier) ? stepped(way) : way);
}

void GradientLine::release(const input::PointerEvent& event) {
    if (!line_) return;
    if (event.kind == input::Kind::Release) drag(event);
    const Line line = *std::exchange(line_, std::nullopt);
    if (glm::distance(line.from_mm, line.to_mm) < kClick_px * canvas_.px_mm())
        Q_EMIT cancelled();
    else
        Q_EMIT drawn(line.from_mm, line.to_mm);
}

void GradientLine::cancel() {
    if (!line_) return;
    line_.reset();
    Q_EMIT cancelled();
}

bool GradientLine::key(const QKeyEvent& event) {
    if (event.type() != QEvent::KeyPress || event.key() != Qt::Key_Escape || !on_) return false;
    if (line_) {
        cancel();
    } else {
        draw_next(false);
        Q_EMIT left();
    }
    return true;
}

void GradientLine::draw(const view::Overlay& overlay) {
    if (!line_ || line_->from_mm == line_->to_mm) return;
    const glm::dvec2 along = glm::normalize(line_->to_mm - line_->from_mm);
    const glm::dvec2 across = 0.5 * kEnd_px * overlay.px_mm * glm::dvec2(-along.y, along.x);
    std::vector<glm::vec2> lines{line_->from_mm, line_->to_mm};
    for (const glm::dvec2& end : {line_->from_mm, line_->to_mm})
        for (const glm::dvec2& tip : {end - across, end + across})
            lines.emplace_back(tip);
    overlay.painter.draw_segments(lines, overlay.canvas, 1.0F);
}

}  // namespace pastoso::interactions
