// The part of CanvasView that moves over the canvas, closer to it, around it, and says where its points
// lie.

#include "screen/window_pixels.hpp"
#include "view/canvas_view.hpp"

#include <algorithm>
#include <cmath>

#include <QResizeEvent>
#include <QWheelEvent>

namespace pastoso::view {
namespace {

/// One notch of a wheel (120 eighths of a degree) zooms by this factor.
constexpr double kZoomPerNotch = 1.25;
constexpr double kNotch = 120.0;

/// Around what is fitted into the view.
constexpr double kCanvasMargin_px = 24.0, kWellMargin_px = 4.0;

/// A panel that is made wider makes the well higher, up to here by itself.
constexpr int kTallestLeastWell_px = 360;

}  // namespace

void CanvasView::set_view(const screen::ViewTransform& view) {
    if (view == view_) return;
    view_ = view;
    screen_->refresh();
    Q_EMIT view_changed();
}

void CanvasView::look_from(const screen::ViewTransform& view) {
    set_view(view);
    fitted_ = wanted_ != nullptr && view_ == fitted_view();
}

void CanvasView::pan(const glm::dvec2& drag_px) {
    if (wanted_ != nullptr) look_from(panned(view_, drag_px, canvas_cells(), window_px()));
}

void CanvasView::fit() {
    if (wanted_ == nullptr) return;
    fitted_ = true;
    set_view(fitted_view());
}

void CanvasView::show_actual_pixels() {
    zoom_about_centre(1.0 / view_.zoom);
    set_view(snapped(view_));
}

void CanvasView::zoom_about_centre(double factor) {
    look_from(zoomed(view_, 0.5 * window_px(), factor));
}

void CanvasView::turn_about_centre(double by_deg) {
    look_from(turned(view_, 0.5 * window_px(), by_deg));
}

void CanvasView::turn_upright() {
    turn_about_centre(-view_.angle_deg);
}

void CanvasView::mirror() {
    set_view(mirrored(view_, window_px()));
}

void CanvasView::keep_in_place(const QPoint& way) {
    if (!fitted_) pan(device_px(way));
}

void CanvasView::show_at_centre(const glm::dvec2& canvas_mm) {
    if (wanted_ == nullptr) return;
    const glm::dvec2 place_px = view_.device_from_cell(canvas_mm / wanted_->film.cell_mm);
    pan(0.5 * window_px() - place_px);
}

screen::ViewTransform CanvasView::fitted_view() const {
    const double margin_px = surface_ == document::Surface::Canvas ? kCanvasMargin_px : kWellMargin_px;
    return fitted(canvas_cells(), window_px(), margin_px, view_);
}

void CanvasView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / kNotch;
    if (notches == 0.0) return;
    look_from(zoomed(view_, device_px(event->position()), std::pow(kZoomPerNotch, notches)));
    move_pointer(event->position());
    refresh();
}

/// The screen draws at once, so the canvas is fitted before.
void CanvasView::resizeEvent(QResizeEvent*) {
    if (fitted_) fit();
    screen_->widget().resize(size());
    place_legend();
    Q_EMIT view_changed();
    if (surface_ == document::Surface::Well)
        QMetaObject::invokeMethod(this, &CanvasView::grow_with_width, Qt::QueuedConnection);
}

/// Not within a change of size, since it brings the next one.
void CanvasView::grow_with_width() {
    setMinimumHeight(std::min(heightForWidth(width()), kTallestLeastWell_px));
}

glm::dvec2 CanvasView::device_px(const QPointF& position) const {
    return devicePixelRatioF() * glm::dvec2(position.x(), position.y());
}

glm::dvec2 CanvasView::window_px() const {
    const QSize size = screen::window_px(*this);
    return {size.width(), size.height()};
}

glm::dvec2 CanvasView::canvas_cells() const {
    return {wanted_->film.shape.width, wanted_->film.shape.height};
}

glm::dvec2 CanvasView::canvas_size_mm() const {
    return wanted_ == nullptr ? glm::dvec2(0.0) : wanted_->film.cell_mm * canvas_cells();
}

glm::dvec2 CanvasView::canvas_mm(const QPointF& position) const {
    if (wanted_ == nullptr) return {};
    return wanted_->film.cell_mm * view_.cell_from_device(device_px(position));
}

std::optional<glm::dvec2> CanvasView::pointer_mm() const {
    if (!pointer_) return std::nullopt;
    return canvas_mm(*pointer_);
}

QPointF CanvasView::widget_position(const glm::dvec2& canvas_mm) const {
    if (wanted_ == nullptr) return {};
    const glm::dvec2 px =
        view_.device_from_cell(canvas_mm / wanted_->film.cell_mm) / devicePixelRatioF();
    return {px.x, px.y};
}

double CanvasView::cell_mm() const {
    return wanted_ == nullptr ? 0.0 : wanted_->film.cell_mm;
}

double CanvasView::px_mm() const {
    return cell_mm() * devicePixelRatioF() / view_.zoom;
}

}  // namespace pastoso::view
