#include "tea/tea_view.hpp"

#include "core/units.hpp"

#include <cmath>
#include <utility>

#include <QPainter>
#include <QPainterPath>

namespace pastoso::tea {

TeaView::TeaView(QWidget* parent) : GlassView(parent) {
    setObjectName(QStringLiteral("tea_view"));
}

TeaView::~TeaView() {
    release_graphics();
}

void TeaView::show_moment(std::shared_ptr<const session::TeaMoment> moment) {
    if (moment == wanted_) return;
    wanted_ = std::move(moment);
    begin_anew();
}

void TeaView::show_force(const session::TeaForce& force) {
    if (force == force_) return;
    force_ = force;
    update();
}

void TeaView::look_from_front() {
    set_camera(wanted_ != nullptr ? TeaCamera(wanted_->settings.cup) : TeaCamera());
}

void TeaView::release_renderer() {
    renderer_.release();
    shown_.reset();
}

void TeaView::show_latest() {
    renderer_.show(*wanted_);
    shown_ = wanted_;
}

void TeaView::draw_liquid(QOpenGLFramebufferObject& target, const QRect& part, int pass,
                          Quality quality) {
    renderer_.draw(target, part, camera(), pass, quality);
}

/// Where milk would be poured, and the axis with the way the force turns.
void TeaView::draw_marks(QPainter& painter, const std::optional<QPointF>& pointer) {
    const auto ring = [&](const glm::vec2& middle_m, double radius_m, double from, double to) {
        constexpr int kCorners = 48;
        QPainterPath path;
        for (int i = 0; i <= kCorners; ++i) {
            const double angle = std::lerp(from, to, static_cast<double>(i) / kCorners);
            const glm::vec2 at =
                middle_m + glm::vec2(radius_m * std::cos(angle), radius_m * std::sin(angle));
            const QPointF seen = widget_position(at);
            i == 0 ? path.moveTo(seen) : path.lineTo(seen);
        }
        return path;
    };
    if (force_.on) {
        constexpr double kRadius_m = 0.009, kGap = 0.9;
        const glm::vec2 axis(force_.axis_m);
        const double turns = force_.swirl_rad_s2 < 0.0 ? -1.0 : 1.0;
        QPainterPath mark = ring(axis, kRadius_m, turns * kGap, turns * 2.0 * core::kPi);
        const glm::vec2 tip = axis + glm::vec2(kRadius_m, 0.0);
        for (const double side : {-0.0028, 0.0028}) {
            mark.moveTo(widget_position(tip));
            mark.lineTo(widget_position(tip + glm::vec2(side, -turns * 0.0036)));
        }
        mark.addEllipse(widget_position(axis), 1.2, 1.2);
        stroke_mark(painter, mark, 0.9);
    }
    if (!pointer) return;
    if (const auto at = on_tea(*pointer))
        stroke_mark(painter, ring(*at, shown_->settings.pour_radius_m, 0.0, 2.0 * core::kPi), 0.55);
}

QPointF TeaView::widget_position(const glm::vec2& on_tea_m) const {
    const float level_m = wanted_ != nullptr ? wanted_->settings.cup.level_m : liquid::Cup{}.level_m;
    return camera().seen_at(glm::vec3(on_tea_m, level_m), size());
}

std::optional<glm::vec2> TeaView::on_tea(const QPointF& place) const {
    if (wanted_ == nullptr) return std::nullopt;
    return place_on_tea(camera().through(place, size()), wanted_->settings.cup);
}

void TeaView::press_liquid(const QPointF& place) {
    if (const auto at = on_tea(place)) Q_EMIT poured(*at);
}

}  // namespace pastoso::tea
