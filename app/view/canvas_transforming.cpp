// The part of CanvasView in which a frame moves, scales and turns paint.

#include "core/units.hpp"
#include "view/canvas_view.hpp"
#include "view/frame_device.hpp"

#include <cmath>
#include <utility>

#include <QPainter>
#include <QPainterPath>

namespace pastoso::view {
namespace {

/// So near to a handle a press takes hold of it.
constexpr double kReach_px = 9.0;
constexpr double kHandle_px = 4.5;

glm::vec2 point(const glm::dvec2& place_mm) {
    return {static_cast<float>(place_mm.x), static_cast<float>(place_mm.y)};
}

std::vector<glm::vec2> corners(const tools::TransformFrame& frame) {
    std::vector<glm::vec2> points;
    for (const glm::ivec2& side : {glm::ivec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
        points.push_back(point(tools::handle_mm(frame, side)));
    return points;
}

std::vector<glm::vec2> square_around(const glm::dvec2& middle_mm, double half_mm) {
    std::vector<glm::vec2> points;
    for (const glm::dvec2& corner : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
        points.push_back(point(middle_mm + half_mm * corner));
    return points;
}

/// Along which a handle goes from the middle of the frame, on the screen.
Qt::CursorShape scaling_cursor(const glm::dvec2& way) {
    static constexpr Qt::CursorShape kShapes[] = {Qt::SizeHorCursor, Qt::SizeFDiagCursor,
                                                  Qt::SizeVerCursor, Qt::SizeBDiagCursor};
    const double eighths = std::atan2(way.y, way.x) / (0.25 * core::kPi);
    return kShapes[(static_cast<int>(std::lround(eighths)) + 8) % 4];
}

/// A bow with a point at both ends.
const QCursor& turning_cursor() {
    static const QCursor cursor = [] {
        constexpr int kSide = 24;
        QPixmap picture(kSide, kSide);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        QPainterPath bow;
        bow.arcMoveTo(5, 6, 14, 14, 30);
        bow.arcTo(5, 6, 14, 14, 30, 120);
        QPainterPath points;
        points.addPolygon(QPolygonF({{19.5, 5.5}, {19.5, 12.0}, {13.5, 10.0}}));
        points.closeSubpath();
        points.addPolygon(QPolygonF({{4.5, 5.5}, {4.5, 12.0}, {10.5, 10.0}}));
        points.closeSubpath();
        painter.strokePath(bow, QPen(Qt::white, 4.0, Qt::SolidLine, Qt::FlatCap));
        painter.strokePath(points, QPen(Qt::white, 2.0));
        painter.strokePath(bow, QPen(Qt::black, 2.0, Qt::SolidLine, Qt::FlatCap));
        painter.fillPath(points, Qt::black);
        painter.end();
        return QCursor(picture, kSide / 2, kSide / 2);
    }();
    return cursor;
}

tools::TransformFrame as_it_was(const tools::TransformFrame& frame) {
    return {.corner_mm = frame.corner_mm, .size_mm = frame.size_mm};
}

/// Bare canvas in place of the paint.
QImage veil_of(QImage picture) {
    constexpr QColor kBareCanvas(233, 230, 222);
    QPainter painter(&picture);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(picture.rect(), kBareCanvas);
    return picture;
}

}  // namespace

void CanvasView::show_frame(std::optional<tools::TransformFrame> frame) {
    frame_ = std::move(frame);
    if (!frame_) {
        frame_drag_.reset();
        frame_picture_ = frame_veil_ = {};
    }
    set_cursor();
}

void CanvasView::show_in_frame(const QImage& picture) {
    frame_picture_ = picture;
    frame_veil_ = veil_of(picture);
    update();
}

tools::FrameHold CanvasView::hold_under(const QPointF& position) const {
    return tools::hold_at(*frame_, canvas_mm(position), kReach_px * devicePixelRatioF() * mm_per_px());
}

void CanvasView::press_frame(const QPointF& position) {
    frame_drag_ = FrameDrag{*frame_, hold_under(position), canvas_mm(position)};
    set_cursor();
}

void CanvasView::drag_frame(const QPointF& position, Qt::KeyboardModifiers modifiers) {
    const bool constrained = modifiers.testFlag(Qt::ShiftModifier);
    frame_ = tools::dragged(frame_drag_->start, frame_drag_->hold, frame_drag_->from_mm,
                            canvas_mm(position), constrained, wanted_->film.cell_mm);
    set_cursor();
    Q_EMIT frame_dragged(*frame_);
}

/// Enter keeps what the frame shows; Escape gives up the drag, or else the frame. False for other keys.
bool CanvasView::press_frame_key(int key) {
    if (!frame_) return false;
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        frame_drag_.reset();
        Q_EMIT frame_accepted();
        return true;
    }
    if (key != Qt::Key_Escape) return false;
    if (frame_drag_) {
        frame_ = std::exchange(frame_drag_, std::nullopt)->start;
        set_cursor();
        Q_EMIT frame_dragged(*frame_);
    } else {
        Q_EMIT frame_cancelled();
    }
    return true;
}

QCursor CanvasView::frame_cursor() const {
    if (!pointer_) return Qt::ArrowCursor;
    const tools::FrameHold hold = frame_drag_ ? frame_drag_->hold : hold_under(*pointer_);
    if (hold.kind == tools::FrameHold::Kind::Move) return Qt::SizeAllCursor;
    if (hold.kind == tools::FrameHold::Kind::Turn) return turning_cursor();
    const QPointF way = widget_position(tools::handle_mm(*frame_, hold.side)) -
                        widget_position(tools::handle_mm(*frame_, {0, 0}));
    return scaling_cursor({way.x(), way.y()});
}

/// The box as it was is drawn faintly.
void CanvasView::draw_frame() {
    constexpr float kFaint = 0.4F;
    const OverlayFrame canvas = overlay_frame(view_.device_from_cell({0.0, 0.0}));
    overlay_.draw_loop(corners(as_it_was(*frame_)), canvas, kFaint);
    overlay_.draw_loop(corners(*frame_), canvas, 1.0F);
    const double half_mm = kHandle_px * devicePixelRatioF() * mm_per_px();
    for (const glm::ivec2& side : tools::kFrameHandles)
        overlay_.draw_loop(square_around(tools::handle_mm(*frame_, side), half_mm), canvas, 1.0F);
}

/// The paint where it would come to lie.
void CanvasView::draw_frame_picture() {
    constexpr double kVeil = 0.75, kPaint = 0.85;
    if (frame_picture_.isNull() || *frame_ == as_it_was(*frame_)) return;
    draw_in(as_it_was(*frame_), frame_veil_, kVeil);
    draw_in(*frame_, frame_picture_, kPaint);
}

void CanvasView::draw_in(const tools::TransformFrame& frame, const QImage& picture, double opacity) {
    const auto widget_point = [&](const glm::ivec2& side) {
        return widget_position(tools::handle_mm(frame, side));
    };
    const QPointF origin = widget_point({-1, -1});
    const QPointF across = (widget_point({1, -1}) - origin) / picture.width();
    const QPointF down = (widget_point({-1, 1}) - origin) / picture.height();
    FrameDevice device(*this);
    QPainter painter(&device);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setOpacity(opacity);
    painter.setTransform({across.x(), across.y(), down.x(), down.y(), origin.x(), origin.y()});
    painter.drawImage(QPointF(0.0, 0.0), picture);
}

}  // namespace pastoso::view
