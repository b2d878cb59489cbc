#include "glass/tea_view.hpp"

#include "core/units.hpp"

#include <cmath>
#include <utility>

#include <QPainter>
#include <QPainterPath>

namespace pastoso::glass {

TeaView::TeaView(QWidget* parent) : GlassView(parent) {
    setObjectName(QStringLiteral("tea_view"));
}

TeaView::~TeaView() {
    release_graphics();
}

void TeaView::show_moment(std::shared_ptr<const session::TeaSnapshot> snapshot) {
    if (snapshot == wanted_) return;
    wanted_ = std::move(snapshot);
    take_moment();
}

void TeaView::show_force(const session::TeaForce& force) {
    if (force == force_) return;
    force_ = force;
    update();
}

void TeaView::look_from_front() {
    set_camera(wanted_ != nullptr ? GlassCamera(wanted_->settings.cup) : GlassCamera());
}

void TeaView::show_latest() {
    renderer_.show(*wanted_);
    shown_ = wanted_;
}

/// Where milk would be poured, and the axis with the way the force turns.
void TeaView::draw_marks(QPainter& painter, const std::optional<QPointF>& pointer) {
    if (force_.on) {
        constexpr double kRadius_m = 0.009, kGap = 0.9;
        const glm::vec2 axis(force_.axis_m);
        const double turns = force_.swirl_rad_s2 < 0.0 ? -1.0 : 1.0;
        QPainterPath mark =
            seen_ring(on_surface(axis), kRadius_m, turns * kGap, turns * 2.0 * core::kPi);
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
        stroke_mark(painter, seen_ring(on_surface(*at), shown_->settings.pour_radius_m), 0.55);
}

glm::vec3 TeaView::on_surface(const glm::vec2& on_tea_m) const {
    return {on_tea_m, wanted_ != nullptr ? wanted_->cup().level_m : liquid::Cup{}.level_m};
}

std::optional<glm::vec2> TeaView::on_tea(const QPointF& place) const {
    if (wanted_ == nullptr) return std::nullopt;
    return place_on_tea(camera().through(place, size()), wanted_->cup());
}

void TeaView::press_liquid(const QPointF& place) {
    if (const auto at = on_tea(place)) Q_EMIT poured(*at);
}

}  // namespace pastoso::glass
