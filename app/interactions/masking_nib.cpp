#include "interactions/masking_nib.hpp"

#include "interactions/brush_outline.hpp"
#include "interactions/event_place.hpp"
#include "interactions/stepped_way.hpp"

#include <algorithm>

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

namespace pastoso::interactions {
namespace {

using view::Took;

/// The hand of a click trembles by less.
constexpr double kClick_px = 3.0;

const QColor kLaid(236, 226, 170, 120), kPeeled(40, 60, 90, 120);

}  // namespace

void MaskingNib::mask_next(std::optional<MaskingForm> form) {
    form_ = form;
    fluid_.cancel();
    tape_.reset();
    canvas_.refresh();
}

Took MaskingNib::press(const input::PointerEvent& event) {
    if (!form_ || event.button != Qt::LeftButton) return Took::Nothing;
    peels_ = event.modifiers.testFlag(Qt::AltModifier);
    if (form_ == MaskingForm::Fluid)
        fluid_.press(AreaForm::Lasso, place_mm(event), grid::Combination::Add);
    else
        tape_ = {place_mm(event), place_mm(event)};
    Q_EMIT begun(peels_);
    return Took::Pointer;
}

void MaskingNib::drag(const input::PointerEvent& event) {
    if (fluid_.active()) fluid_.move(place_mm(event), canvas_.px_mm(), false);
    if (!tape_) return;
    const glm::dvec2 way = place_mm(event) - tape_->from_mm;
    tape_->to_mm = tape_->from_mm + (event.modifiers.testFlag(Qt::ShiftModifier) ? stepped(way) : way);
}

std::vector<glm::dvec2> MaskingNib::line_mm() const {
    return tape_ ? std::vector{tape_->from_mm, tape_->to_mm} : fluid_.points_mm();
}

void MaskingNib::release(const input::PointerEvent& event) {
    if (!is_laying()) return;
    if (event.kind == input::Kind::Release) drag(event);
    const std::vector<glm::dvec2> line = line_mm();
    const bool click = tape_ && glm::distance(line.front(), line.back()) < kClick_px * canvas_.px_mm();
    document::MaskStripe stripe{
        .width_mm = std::clamp(easel_.hand().brush_width_mm, document::kLeastStripe_mm,
                               document::kMostStripe_mm),
        .straight_ends = tape_.has_value(),
        .peels = peels_};
    for (const glm::dvec2& point : line)
        stripe.line.push_back({point.x, point.y});
    fluid_.cancel();
    tape_.reset();
    if (click)
        Q_EMIT cancelled();
    else
        Q_EMIT drawn(stripe);
}

void MaskingNib::drop() {
    fluid_.cancel();
    tape_.reset();
    Q_EMIT cancelled();
}

void MaskingNib::cancel() {
    if (is_laying()) drop();
}

bool MaskingNib::key(const QKeyEvent& event) {
    if (event.type() != QEvent::KeyPress || event.key() != Qt::Key_Escape || !form_) return false;
    if (is_laying()) {
        drop();
    } else {
        mask_next(std::nullopt);
        Q_EMIT left();
    }
    return true;
}

void MaskingNib::draw_laid(const view::Overlay& overlay) const {
    const std::vector<glm::dvec2> line = line_mm();
    QPainterPath path(canvas_.widget_position(line.front()));
    for (std::size_t i = 1; i < line.size(); ++i)
        path.lineTo(canvas_.widget_position(line[i]));
    if (line.size() == 1) path.lineTo(path.currentPosition() + QPointF(0.01, 0.0));
    overlay.painter.draw([&](QPainter& painter) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(peels_ ? kPeeled : kLaid, easel_.hand().brush_width_mm / overlay.px_mm,
                            Qt::SolidLine, tape_ ? Qt::FlatCap : Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(path);
    });
}

void MaskingNib::draw(const view::Overlay& overlay) {
    if (!form_) return;
    if (is_laying()) draw_laid(overlay);
    const auto pointer = canvas_.pointer_mm();
    if (!pointer) return;
    const auto radius_mm = static_cast<float>(0.5 * easel_.hand().brush_width_mm);
    if (form_ == MaskingForm::Fluid)
        overlay.painter.draw_loop(hull_mm({glm::vec2(*pointer)}, radius_mm), overlay.canvas, 1.0F);
}

}  // namespace pastoso::interactions
