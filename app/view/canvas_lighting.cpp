// The part of CanvasView that shows in what light, and how, the paint is looked at.

#include "core/error.hpp"
#include "view/canvas_view.hpp"
#include "view/frame_device.hpp"
#include "view/light_handle.hpp"
#include "view/look_legend.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <QPainter>
#include <QRadialGradient>
#include <glm/geometric.hpp>

namespace pastoso::view {
namespace {

constexpr double kLegendMargin_px = 12.0;
constexpr double kDial_px = 120.0, kHandle_px = 11.0, kReach_px = 16.0;

/// Shadows that take longer wait until the light rests.
constexpr double kQuickShadows_s = 0.012;

LightDirection direction_of(const shade::Lighting& lighting) {
    return {lighting.azimuth_deg, lighting.elevation_deg};
}

QPointF point(const glm::dvec2& px) {
    return {px.x, px.y};
}

}  // namespace

void CanvasView::set_look(Look look) {
    if (look == look_) return;
    look_ = look;
    relook_ = true;
    legend_->show_look(look_, scale_top_mm_);
    place_legend();
    damage_all();
}

void CanvasView::set_lighting(const shade::Lighting& lighting) {
    const bool moved = lighting.azimuth_deg != lighting_.azimuth_deg ||
                       lighting.elevation_deg != lighting_.elevation_deg;
    const bool changed = !(lighting == lighting_);
    lighting_ = lighting;
    damage_all();
    if (changed) Q_EMIT lighting_changed();
    if (!moved) return;  // the shadows stay where they are
    if (shadows_took_s_ > kQuickShadows_s)
        light_rests_.start();
    else
        relight_ = true;
}

/// `tiles` have changed; all of them where another look is asked for.
void CanvasView::upload_look(const std::vector<int>& tiles) {
    if (!needs_thickness(look_)) return;
    const auto patches = look_patches(*seen_, look_, tiles, pool_);
    textures_.upload_look(patches);
    if (look_ != Look::Height) return;
    highest_mm_ = std::max(relook_ ? 0.0 : highest_mm_, highest_mm(patches));
    if (scale_top_mm(highest_mm_) == scale_top_mm_) return;
    scale_top_mm_ = scale_top_mm(highest_mm_);
    legend_->show_look(look_, scale_top_mm_);
    damage_all();
}

void CanvasView::upload_new_look() {
    try {
        picture_.prepare(look_);
    } catch (const core::InputError&) {
        // A driver that shades lit paint refuses none of the simpler looks; if it does, painting goes
        // on.
        look_ = Look::Lit;
        legend_->show_look(look_, scale_top_mm_);
    }
    std::vector<int> all(static_cast<std::size_t>(seen_->film.shape.tile_count()));
    std::iota(all.begin(), all.end(), 0);
    upload_look(all);
    relook_ = false;
}

void CanvasView::place_legend() {
    legend_->move(static_cast<int>(kLegendMargin_px),
                  height() - legend_->height() - static_cast<int>(kLegendMargin_px));
}

void CanvasView::show_light_handle(bool shown) {
    light_handle_shown_ = shown;
    light_drag_.reset();
    update();
}

LightDial CanvasView::light_dial() const {
    const glm::dvec2 window{width(), height()};
    return {0.5 * window, std::min(kDial_px, 0.4 * std::min(window.x, window.y))};
}

/// Whether the press takes hold of the lamp.
bool CanvasView::press_light(const QPointF& position) {
    if (!light_handle_shown_) return false;
    const glm::dvec2 handle = light_handle_px(light_dial(), view_, direction_of(lighting_));
    const glm::dvec2 place{position.x(), position.y()};
    if (glm::distance(place, handle) > kReach_px) return false;
    light_drag_ = handle - place;
    return true;
}

void CanvasView::drag_light(const QPointF& position) {
    const glm::dvec2 place = glm::dvec2{position.x(), position.y()} + *light_drag_;
    const LightDirection light = light_at(light_dial(), view_, place, direction_of(lighting_));
    Q_EMIT light_dragged(light.elevation_deg, light.azimuth_deg);
    update();
}

void CanvasView::draw_light_handle() {
    const LightDial dial = light_dial();
    const QPointF centre = point(dial.centre_px);
    const QPointF lamp = point(light_handle_px(dial, view_, direction_of(lighting_)));
    FrameDevice frame(*this);
    QPainter painter(&frame);
    painter.setRenderHint(QPainter::Antialiasing);
    const auto twice = [&](const auto& draw) {
        painter.setPen(QPen(QColor(0, 0, 0, 110), 3.0));
        draw();
        painter.setPen(QPen(QColor(255, 255, 255, 170), 1.2));
        draw();
    };
    painter.setBrush(Qt::NoBrush);
    twice([&] { painter.drawEllipse(centre, dial.radius_px, dial.radius_px); });
    twice([&] { painter.drawLine(lamp, centre); });
    QRadialGradient glow(lamp, 2.4 * kHandle_px);
    glow.setColorAt(0.0, QColor(255, 226, 130, 210));
    glow.setColorAt(1.0, QColor(255, 226, 130, 0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(glow);
    painter.drawEllipse(lamp, 2.4 * kHandle_px, 2.4 * kHandle_px);
    painter.setPen(QPen(QColor(60, 45, 10), 1.5));
    painter.setBrush(QColor(255, 214, 90));
    painter.drawEllipse(lamp, kHandle_px, kHandle_px);
}

}  // namespace pastoso::view
