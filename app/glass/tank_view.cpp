#include "glass/tank_view.hpp"

#include "core/units.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <QPainter>
#include <QPainterPath>
#include <glm/geometric.hpp>

namespace pastoso::glass {
namespace {

GlassCamera camera_for(const tank::TankScene& scene) {
    const glm::vec3 size_m = scene.size_m();
    const float wide_m = glm::length(glm::vec2(size_m));
    GlassCamera camera(glm::vec3(0.5F, 0.5F, 0.44F) * size_m,
                       static_cast<double>(std::max(size_m.z, 0.62F * wide_m)));
    camera.orbit(18.0, 0.0);
    return camera;
}

}  // namespace

TankView::TankView(QWidget* parent) : GlassView(parent) {
    setObjectName(QStringLiteral("tank_view"));
}

TankView::~TankView() {
    release_graphics();
}

/// Another tank is looked at from its front.
void TankView::show_moment(std::shared_ptr<const session::TankSnapshot> snapshot) {
    if (snapshot == wanted_) return;
    const bool other =
        wanted_ == nullptr || wanted_->place->scene.size_m() != snapshot->place->scene.size_m();
    wanted_ = std::move(snapshot);
    if (other) look_from_front();
    take_moment();
}

void TankView::show_wind(const session::TankWind& wind) {
    if (wind == wind_) return;
    wind_ = wind;
    update();
}

void TankView::show_velocity(bool shown) {
    velocity_shown_ = shown;
    update();
}

void TankView::set_ball_radius(float radius_m) {
    ball_radius_m_ = radius_m;
}

void TankView::look_from_front() {
    if (wanted_ != nullptr) set_camera(camera_for(wanted_->place->scene));
}

void TankView::show_latest() {
    renderer_.show(wanted_);
    shown_ = wanted_;
}

glm::vec3 TankView::on_surface(const glm::vec2& on_liquid_m) const {
    return {on_liquid_m, wanted_ != nullptr ? session::rest_level_m(*wanted_) : 0.0F};
}

std::optional<glm::vec2> TankView::on_liquid(const QPointF& place) const {
    if (wanted_ == nullptr) return std::nullopt;
    const ViewRay ray = camera().through(place, size());
    const float along = (session::rest_level_m(*wanted_) - ray.origin_m.z) / ray.direction.z;
    if (!(along > 0.0F)) return std::nullopt;
    const glm::vec2 at_m(ray.origin_m + along * ray.direction);
    const glm::vec3 size_m = wanted_->place->scene.size_m();
    const bool inside = at_m.x > 0.0F && at_m.y > 0.0F && at_m.x < size_m.x && at_m.y < size_m.y;
    return inside ? std::optional(at_m) : std::nullopt;
}

void TankView::press_liquid(const QPointF& place) {
    if (const auto at_m = on_liquid(place)) Q_EMIT ball_wanted(*at_m);
}

// ---- marks

void TankView::draw_marks(QPainter& painter, const std::optional<QPointF>& pointer) {
    if (wanted_ == nullptr) return;
    draw_drains(painter);
    if (velocity_shown_) draw_velocity(painter);
    if (wind_.on) draw_wind(painter);
    if (!pointer) return;
    if (const auto at_m = on_liquid(*pointer))
        stroke_mark(painter, seen_ring(on_surface(*at_m), ball_radius_m_), 0.55);
}

/// Slow ones are blue, the fastest red; the fastest is as long as they lie apart.
void TankView::draw_velocity(QPainter& painter) const {
    constexpr int kColours = 6;
    constexpr int kApart = 16;
    constexpr float kHead = 0.3F;
    float fastest_m_s = 1e-6F;
    for (const session::FlowArrow& arrow : wanted_->seen.arrows)
        fastest_m_s = std::max(fastest_m_s, glm::length(arrow.velocity_m_s));
    const float scale = 1.1F * session::longest_side_m(wanted_->place->scene) / (kApart * fastest_m_s);
    std::array<QList<QLineF>, kColours> lines;
    for (const session::FlowArrow& arrow : wanted_->seen.arrows) {
        const float share = glm::length(arrow.velocity_m_s) / fastest_m_s;
        const QPointF from = seen(arrow.from_m), to = seen(arrow.from_m + scale * arrow.velocity_m_s);
        QList<QLineF>& these =
            lines[static_cast<std::size_t>(std::min(static_cast<int>(share * kColours), kColours - 1))];
        const QPointF way = kHead * (to - from), across(0.6 * way.y(), -0.6 * way.x());
        these << QLineF(from, to) << QLineF(to, to - way + across) << QLineF(to, to - way - across);
    }
    for (int i = 0; i < kColours; ++i) {
        const double share = static_cast<double>(i) / (kColours - 1);
        painter.setPen(
            QPen(QColor::fromHsvF(0.61 * (1.0 - share), 0.85, 0.95 - 0.25 * (1.0 - share), 0.9), 1.3));
        painter.drawLines(lines[static_cast<std::size_t>(i)]);
    }
}

void TankView::draw_drains(QPainter& painter) const {
    for (const tank::Drain& drain : wanted_->place->scene.drains)
        if (const auto* form = std::get_if<tank::Cylinder>(&drain.shape.form)) {
            const glm::vec3 middle_m(form->to_m.x, form->to_m.y, 0.0F);
            const QPainterPath outer = seen_ring(middle_m, form->radius_m);
            stroke_mark(painter, outer, wanted_->drains_open ? 0.9 : 0.3);
            if (wanted_->drains_open)
                stroke_mark(painter, seen_ring(middle_m, 0.55F * form->radius_m), 0.9);
        }
}

/// An arrow over the tank, where the wind blows to.
void TankView::draw_wind(QPainter& painter) const {
    const glm::vec3 size_m = wanted_->place->scene.size_m();
    const auto angle = static_cast<float>(wind_.direction_deg * core::kPi / 180.0);
    const glm::vec3 along(std::cos(angle), std::sin(angle), 0.0F), across(-along.y, along.x, 0.0F);
    const float half_m = 0.32F * std::min(size_m.x, size_m.y);
    const glm::vec3 middle_m(0.5F * size_m.x, 0.5F * size_m.y, size_m.z);
    const glm::vec3 tip_m = middle_m + half_m * along;
    QPainterPath path(seen(middle_m - half_m * along));
    path.lineTo(seen(tip_m));
    for (const float side : {-0.3F, 0.3F}) {
        path.moveTo(seen(tip_m));
        path.lineTo(seen(tip_m - half_m * (0.4F * along + side * across)));
    }
    stroke_mark(painter, path, 0.9);
}

}  // namespace pastoso::glass
