// The part of CanvasView that moves over the canvas, closer to it, around it, and says where its points
// lie.

#include "core/units.hpp"
#include "view/canvas_view.hpp"

#include <algorithm>
#include <cmath>

#include <QResizeEvent>
#include <QWheelEvent>
#include <glm/geometric.hpp>

namespace pastoso::view {
namespace {

/// One notch of a wheel (120 eighths of a degree) zooms by this factor.
constexpr double kZoomPerNotch = 1.25;
constexpr double kNotch = 120.0;

/// A drag over so many pixels of the desktop doubles the zoom.
constexpr double kDoubling_px = 120.0;

/// Around what is fitted into the view.
constexpr double kCanvasMargin_px = 24.0, kWellMargin_px = 4.0;

/// A panel that is made wider makes the well higher, up to here by itself.
constexpr int kTallestLeastWell_px = 360;

/// So near to the middle a drag has no direction.
constexpr double kNoDirection_px = 6.0;

/// A drag that keeps to steps.
constexpr double kStep_deg = 15.0;

double direction_deg(const glm::dvec2& way) {
    return core::degrees(std::atan2(way.y, way.x));
}

}  // namespace

void CanvasView::set_view(const ViewTransform& view) {
    if (view == view_) return;
    view_ = view;
    damage_all();
    Q_EMIT view_changed();
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
    fitted_ = false;
    set_view(zoomed(view_, 0.5 * window_px(), factor));
}

void CanvasView::turn_about_centre(double by_deg) {
    set_turned(turned(view_, 0.5 * window_px(), by_deg));
}

void CanvasView::turn_upright() {
    turn_about_centre(-view_.angle_deg);
}

void CanvasView::mirror() {
    set_view(mirrored(view_, window_px()));
}

void CanvasView::keep_in_place(const QPoint& way) {
    if (fitted_ || wanted_ == nullptr) return;
    set_view(panned(view_, device_px(way), canvas_cells(), window_px()));
}

void CanvasView::show_at_centre(const glm::dvec2& canvas_mm) {
    if (wanted_ == nullptr) return;
    fitted_ = false;
    const glm::dvec2 place_px = view_.device_from_cell(canvas_mm / wanted_->film.cell_mm);
    set_view(panned(view_, 0.5 * window_px() - place_px, canvas_cells(), window_px()));
}

ViewTransform CanvasView::fitted_view() const {
    const double margin_px = surface_ == document::Surface::Canvas ? kCanvasMargin_px : kWellMargin_px;
    return fitted(canvas_cells(), window_px(), margin_px, view_);
}

/// A canvas that was fitted and is turned there and back is fitted again.
void CanvasView::set_turned(const ViewTransform& view) {
    set_view(view);
    fitted_ = wanted_ != nullptr && view_ == fitted_view();
}

void CanvasView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / kNotch;
    if (notches == 0.0) return;
    fitted_ = false;
    set_view(zoomed(view_, device_px(event->position()), std::pow(kZoomPerNotch, notches)));
    follow_pointer(event->position());
}

/// Draws at once, so the canvas is fitted before.
void CanvasView::resizeEvent(QResizeEvent* event) {
    if (fitted_) fit();
    QOpenGLWidget::resizeEvent(event);
    place_legend();
    Q_EMIT view_changed();
    if (surface_ == document::Surface::Well)
        QMetaObject::invokeMethod(this, &CanvasView::grow_with_width, Qt::QueuedConnection);
}

/// Not within a change of size, since it brings the next one.
void CanvasView::grow_with_width() {
    setMinimumHeight(std::min(heightForWidth(width()), kTallestLeastWell_px));
}

/// Shift turns the canvas, Control zooms.
void CanvasView::begin_view_drag(const QPointF& position, Qt::KeyboardModifiers modifiers) {
    using Kind = ViewDrag::Kind;
    easel_->release();
    const bool turns = modifiers.testFlag(Qt::ShiftModifier) && surface_ == document::Surface::Canvas;
    const bool zooms = modifiers.testFlag(Qt::ControlModifier);
    view_drag_ = ViewDrag{turns ? Kind::Turn : zooms ? Kind::Zoom : Kind::Pan, position, view_};
    set_cursor();
}

void CanvasView::drag_view(const QPointF& position, Qt::KeyboardModifiers modifiers) {
    if (wanted_ == nullptr) return;
    if (view_drag_->kind == ViewDrag::Kind::Turn)
        return drag_turn(position, modifiers.testFlag(Qt::ControlModifier));
    fitted_ = false;
    if (view_drag_->kind == ViewDrag::Kind::Zoom) {
        const double doublings = (view_drag_->from.y() - position.y()) / kDoubling_px;
        return set_view(zoomed(view_drag_->start, device_px(view_drag_->from), std::exp2(doublings)));
    }
    const glm::dvec2 drag = device_px(position) - device_px(view_drag_->from);
    view_drag_->from = position;
    set_view(panned(view_, drag, canvas_cells(), window_px()));
}

void CanvasView::drag_turn(const QPointF& position, bool by_steps) {
    const glm::dvec2 centre = 0.5 * window_px();
    const glm::dvec2 from = device_px(view_drag_->from) - centre, to = device_px(position) - centre;
    const double least_px = kNoDirection_px * devicePixelRatioF();
    if (glm::length(from) < least_px || glm::length(to) < least_px) return;
    const ViewTransform& start = view_drag_->start;
    double angle_deg = start.angle_deg + direction_deg(to) - direction_deg(from);
    if (by_steps) angle_deg = kStep_deg * std::round(angle_deg / kStep_deg);
    set_turned(turned(start, centre, angle_deg - start.angle_deg));
}

void CanvasView::end_view_drag() {
    view_drag_.reset();
    set_cursor();
}

glm::dvec2 CanvasView::device_px(const QPointF& position) const {
    return devicePixelRatioF() * glm::dvec2(position.x(), position.y());
}

glm::dvec2 CanvasView::window_px() const {
    return {std::round(width() * devicePixelRatioF()), std::round(height() * devicePixelRatioF())};
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

double CanvasView::mm_per_px() const {
    return wanted_->film.cell_mm / view_.zoom;
}

}  // namespace pastoso::view
