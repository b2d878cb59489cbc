#include "interactions/frame.hpp"

#include "appearance/cursors.hpp"
#include "appearance/screen_colours.hpp"
#include "core/check.hpp"
#include "interactions/event_place.hpp"

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <QKeyEvent>
#include <QPainter>

namespace pastoso::interactions {
namespace {

using view::Took;

/// So near to a handle a press takes hold of it.
constexpr double kReach_px = 9.0;
constexpr double kHandle_px = 4.5;

glm::vec2 point(const glm::dvec2& place_mm) {
    return {static_cast<float>(place_mm.x), static_cast<float>(place_mm.y)};
}

std::vector<glm::vec2> corners(const tools::TransformFrame& frame) {
    std::vector<glm::vec2> points;
    for (const glm::ivec2& side : tools::kFrameCorners)
        points.push_back(point(tools::handle_mm(frame, side)));
    return points;
}

std::vector<glm::vec2> square_around(const glm::dvec2& middle_mm, double half_mm) {
    std::vector<glm::vec2> points;
    for (const glm::dvec2& corner : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
        points.push_back(point(middle_mm + half_mm * corner));
    return points;
}

tools::TransformFrame as_it_was(const tools::TransformFrame& frame) {
    return {.corner_mm = frame.corner_mm, .size_mm = frame.size_mm};
}

/// What is below, wherever there is paint at all: a pixel that is half covered shows paint, too.
QImage veil_of(const QImage& picture, const QImage& below) {
    QImage veil = below.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < veil.height(); ++y)
        for (int x = 0; x < veil.width(); ++x)
            if (qAlpha(picture.pixel(x, y)) == 0) veil.setPixel(x, y, qRgba(0, 0, 0, 0));
    return veil;
}

/// Of an arrow key, on the screen.
std::optional<QPointF> way_of(int key) {
    switch (key) {
        case Qt::Key_Left:
            return QPointF(-1.0, 0.0);
        case Qt::Key_Right:
            return QPointF(1.0, 0.0);
        case Qt::Key_Up:
            return QPointF(0.0, -1.0);
        case Qt::Key_Down:
            return QPointF(0.0, 1.0);
        default:
            return std::nullopt;
    }
}

/// Of the keys 1 to 4.
std::optional<std::size_t> corner_of(int key) {
    if (key < Qt::Key_1 || key > Qt::Key_4) return std::nullopt;
    return static_cast<std::size_t>(key - Qt::Key_1);
}

/// Puts a picture of that size where its corners, by their sides, are. False: it would fold.
bool placed_picture(const QSizeF& size, const std::function<QPointF(const glm::ivec2& side)>& corner,
                    QTransform& placed) {
    const QPolygonF from(
        {{0.0, 0.0}, {size.width(), 0.0}, {size.width(), size.height()}, {0.0, size.height()}});
    const QPolygonF to({corner({-1, -1}), corner({1, -1}), corner({1, 1}), corner({-1, 1})});
    return QTransform::quadToQuad(from, to, placed);
}

}  // namespace

Frame::Frame(view::CanvasView& canvas) : canvas_(canvas) {
    connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, this,
            &Frame::take_screen_colours);
}

void Frame::show(std::optional<tools::TransformFrame> frame) {
    frame_ = std::move(frame);
    if (!frame_) {
        drag_.reset();
        corner_.reset();
        picture_ = below_ = open_ = shown_ = veil_ = {};
    }
    canvas_.refresh();
}

void Frame::show_picture(const QImage& picture, const QImage& below, const QImage& open) {
    PASTOSO_CHECK(picture.size() == below.size());
    picture_ = picture;
    below_ = below;
    open_ = open;
    take_screen_colours();
    canvas_.refresh();
}

void Frame::take_screen_colours() {
    if (picture_.isNull()) return;
    shown_ = appearance::shown_in_painting(picture_);
    veil_ = appearance::shown_in_painting(veil_of(picture_, below_));
}

tools::FrameHold Frame::hold_at(const input::PointerEvent& event) const {
    return tools::hold_at(*frame_, place_mm(event), kReach_px * canvas_.px_mm(),
                          event.modifiers.testFlag(Qt::ControlModifier));
}

/// Whatever the button: nothing else is done beside the frame.
Took Frame::press(const input::PointerEvent& event) {
    if (!frame_) return Took::Nothing;
    if (event.button != Qt::LeftButton) return Took::Press;
    under_ = hold_at(event);
    drag_ = Drag{*frame_, under_, place_mm(event)};
    return Took::Pointer;
}

/// A frame that would fold stays as it was last.
void Frame::take_unless_folded(const tools::TransformFrame& wanted) {
    if (!tools::problem_of(wanted).empty()) return;
    frame_ = wanted;
    Q_EMIT dragged(*frame_);
}

void Frame::drag(const input::PointerEvent& event) {
    if (!frame_ || !drag_) return;
    const bool constrained = event.modifiers.testFlag(Qt::ShiftModifier);
    take_unless_folded(tools::dragged(drag_->start, drag_->hold, drag_->from_mm, place_mm(event),
                                      constrained, canvas_.cell_mm()));
}

void Frame::release(const input::PointerEvent& event) {
    if (event.kind == input::Kind::Release) drag(event);
    drag_.reset();
}

void Frame::cancel() {
    if (!frame_ || !drag_) return;
    frame_ = std::exchange(drag_, std::nullopt)->start;
    Q_EMIT dragged(*frame_);
}

void Frame::choose_corner(std::optional<std::size_t> corner) {
    corner_ = corner;
    Q_EMIT corner_chosen();
}

void Frame::move_corner(const QPointF& way_px) {
    const glm::ivec2& side = tools::kFrameCorners[*corner_];
    const glm::dvec2 from_mm = tools::handle_mm(*frame_, side);
    const glm::dvec2 to_mm = canvas_.canvas_mm(canvas_.widget_position(from_mm) + way_px);
    take_unless_folded(tools::dragged(*frame_, {tools::FrameHold::Kind::Distort, side}, from_mm, to_mm,
                                      false, canvas_.cell_mm()));
    Q_EMIT corner_moved();
}

bool Frame::needs_key(const QKeyEvent& event) const {
    if (!frame_ || drag_ || (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)))
        return false;
    if (corner_ && way_of(event.key())) return true;
    return event.key() == Qt::Key_Tab || corner_of(event.key());
}

void Frame::key_of_corner(const QKeyEvent& event) {
    const double step_px = event.modifiers().testFlag(Qt::ShiftModifier) ? 10.0 : 1.0;
    if (const auto way = way_of(event.key())) return move_corner(step_px * *way);
    if (event.key() != Qt::Key_Tab) return choose_corner(corner_of(event.key()));
    const std::size_t next = corner_ ? *corner_ + 1 : 0;
    choose_corner(next < tools::kFrameCorners.size() ? std::optional(next) : std::nullopt);
}

bool Frame::key(const QKeyEvent& event) {
    if (!frame_ || event.type() != QEvent::KeyPress) return false;
    if (needs_key(event)) {
        key_of_corner(event);
        return true;
    }
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
        drag_.reset();
        Q_EMIT accepted();
        return true;
    }
    if (event.key() != Qt::Key_Escape) return false;
    if (drag_)
        cancel();
    else
        Q_EMIT cancelled();
    return true;
}

void Frame::hover(const input::PointerEvent& event) {
    if (frame_) under_ = hold_at(event);
}

std::optional<QCursor> Frame::cursor() const {
    if (!frame_) return std::nullopt;
    const tools::FrameHold hold = drag_ ? drag_->hold : under_;
    if (hold.kind == tools::FrameHold::Kind::Move) return Qt::SizeAllCursor;
    if (hold.kind == tools::FrameHold::Kind::Turn) return appearance::turning_cursor();
    if (hold.kind == tools::FrameHold::Kind::Distort) return Qt::CrossCursor;
    const QPointF way = canvas_.widget_position(tools::handle_mm(*frame_, hold.side)) -
                        canvas_.widget_position(tools::handle_mm(*frame_, {0, 0}));
    return appearance::scaling_cursor(way);
}

/// The box as it was is drawn faintly, and a square around the handle of the chosen corner.
void Frame::draw(const view::Overlay& overlay) {
    if (!frame_) return;
    constexpr float kFaint = 0.4F;
    const auto draw_square = [&](const glm::ivec2& side, double half_px) {
        const auto square = square_around(tools::handle_mm(*frame_, side), half_px * overlay.px_mm);
        overlay.painter.draw_loop(square, overlay.canvas, 1.0F);
    };
    draw_picture(overlay);
    overlay.painter.draw_loop(corners(as_it_was(*frame_)), overlay.canvas, kFaint);
    overlay.painter.draw_loop(corners(*frame_), overlay.canvas, 1.0F);
    for (const glm::ivec2& side : tools::kFrameHandles)
        draw_square(side, kHandle_px);
    if (corner_) draw_square(tools::kFrameCorners[*corner_], 2.0 * kHandle_px);
}

/// The paint where it would come to lie.
void Frame::draw_picture(const view::Overlay& overlay) const {
    constexpr double kVeil = 1.0, kPaint = 0.85;
    if (picture_.isNull() || *frame_ == as_it_was(*frame_)) return;
    draw_in(overlay, as_it_was(*frame_), veil_, kVeil);
    if (open_.isNull())
        draw_in(overlay, *frame_, shown_, kPaint);
    else
        draw_in(overlay, whole_canvas(), paint_on_open(), kPaint);
}

tools::TransformFrame Frame::whole_canvas() const {
    return {.corner_mm = {}, .size_mm = canvas_.canvas_size_mm()};
}

/// A picture of the whole canvas.
QImage Frame::paint_on_open() const {
    QImage paint(open_.size(), QImage::Format_ARGB32_Premultiplied);
    paint.fill(Qt::transparent);
    const glm::dvec2 px_per_mm = glm::dvec2(open_.width(), open_.height()) / canvas_.canvas_size_mm();
    const auto pixel = [&](const glm::ivec2& side) {
        const glm::dvec2 place = px_per_mm * tools::handle_mm(*frame_, side);
        return QPointF(place.x, place.y);
    };
    QTransform placed;
    if (!placed_picture(shown_.size(), pixel, placed)) return paint;
    QPainter painter(&paint);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setTransform(placed);
    painter.drawImage(QPointF(0.0, 0.0), shown_);
    painter.resetTransform();
    painter.setCompositionMode(QPainter::CompositionMode_DestinationIn);
    painter.drawImage(QPointF(0.0, 0.0), open_);
    return paint;
}

void Frame::draw_in(const view::Overlay& overlay, const tools::TransformFrame& frame,
                    const QImage& picture, double opacity) const {
    const auto widget_point = [&](const glm::ivec2& side) {
        return canvas_.widget_position(tools::handle_mm(frame, side));
    };
    QTransform placed;
    if (!placed_picture(picture.size(), widget_point, placed)) return;
    overlay.painter.draw([&](QPainter& painter) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.setOpacity(opacity);
        painter.setTransform(placed, true);
        painter.drawImage(QPointF(0.0, 0.0), picture);
    });
}

}  // namespace pastoso::interactions
