#include "panels/pen/curve_editor.hpp"

#include "appearance/said_value.hpp"
#include "panels/parts/section.hpp"
#include "tools/pressure_curve.hpp"

#include <algorithm>
#include <cmath>

#include <QFontMetrics>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace pastoso::panels {
namespace {

constexpr double kPointRadius = 4.0;
constexpr double kGrabRadius = 9.0;
constexpr double kMargin = 6.0;
constexpr int kGridParts = 4;

/// What an arrow key moves a point by, of the frame's width or height.
constexpr double kStep = 0.02, kFineStep = 0.002;

}  // namespace

CurveEditor::CurveEditor(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("curve_editor"));
    setFocusPolicy(Qt::StrongFocus);
    keep_own_keys(this, {Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Insert, Qt::Key_Delete});
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    appearance::say_as(*this, QAccessible::Chart);
    setAccessibleName(tr("Curve"));
    say();
    setToolTip(
        tr("Drag a point, click beside one to add another, right click to take one away.\n"
           "Keys: Page Up and Page Down choose, arrows move, Insert adds, Delete takes away."));
}

QSize CurveEditor::sizeHint() const {
    return {9 * fontMetrics().height(), 8 * fontMetrics().height()};
}

void CurveEditor::show_curve(const brush::DynamicsCurve& curve) {
    if (curve == curve_) return;
    curve_ = curve;
    frame_ = tools::frame_of(curve);
    chosen_ = std::min(chosen_, static_cast<int>(curve_.points.size()) - 1);
    say();
    update();
}

/// The point that is chosen, or how many there are to choose from.
void CurveEditor::say() {
    const int count = static_cast<int>(curve_.points.size());
    if (chosen_ < 0) return appearance::say_value(*this, tr("%n point(s)", nullptr, count));
    const brush::CurvePoint& point = curve_.points[static_cast<std::size_t>(chosen_)];
    const double across = point.input / frame_.most_input;
    const double up = (point.output - frame_.least_output) / (frame_.most_output - frame_.least_output);
    appearance::say_value(*this, tr("Point %1 of %2: %3 % across, %4 % up")
                                     .arg(chosen_ + 1)
                                     .arg(count)
                                     .arg(100.0 * across, 0, 'f', 0)
                                     .arg(100.0 * up, 0, 'f', 0));
}

// ---- places

QRectF CurveEditor::plot() const {
    return QRectF(rect()).adjusted(kMargin, kMargin, -kMargin, -kMargin);
}

QPointF CurveEditor::position_of(const brush::CurvePoint& point) const {
    const QRectF area = plot();
    const double height = frame_.most_output - frame_.least_output;
    return {area.left() + area.width() * point.input / frame_.most_input,
            area.bottom() - area.height() * (point.output - frame_.least_output) / height};
}

brush::CurvePoint CurveEditor::point_at(const QPointF& position) const {
    const QRectF area = plot();
    const double height = frame_.most_output - frame_.least_output;
    return {frame_.most_input * (position.x() - area.left()) / area.width(),
            frame_.least_output + height * (area.bottom() - position.y()) / area.height()};
}

int CurveEditor::point_near(const QPointF& position) const {
    double reach = kGrabRadius;
    int nearest = -1;
    for (std::size_t i = 0; i < curve_.points.size(); ++i) {
        const QPointF away = position_of(curve_.points[i]) - position;
        const double distance = std::hypot(away.x(), away.y());
        if (distance > reach) continue;
        reach = distance;
        nearest = static_cast<int>(i);
    }
    return nearest;
}

// ---- changes

void CurveEditor::choose(int index) {
    chosen_ = index;
    if (chosen_ >= 0) Q_EMIT read_at(curve_.points[static_cast<std::size_t>(chosen_)].input);
    say();
    update();
}

void CurveEditor::move_chosen(const brush::CurvePoint& place) {
    if (chosen_ < 0) return;
    brush::CurvePoint& point = curve_.points[static_cast<std::size_t>(chosen_)];
    const brush::CurvePoint moved = rises_ ? tools::confined_rising(curve_.points, chosen_, place)
                                           : tools::confined(curve_.points, chosen_, place, frame_);
    if (moved == point) return;
    point = moved;
    Q_EMIT edited(curve_.points);
    choose(chosen_);
}

int CurveEditor::add(const brush::CurvePoint& place) {
    return rises_ ? tools::add_rising(curve_.points, place)
                  : tools::add_point(curve_.points, place, frame_);
}

void CurveEditor::step_chosen(int key, bool fine) {
    if (chosen_ < 0) return choose(0);
    const double step = fine ? kFineStep : kStep;
    brush::CurvePoint place = curve_.points[static_cast<std::size_t>(chosen_)];
    const double across = step * frame_.most_input;
    const double up = step * (frame_.most_output - frame_.least_output);
    place.input += key == Qt::Key_Right ? across : key == Qt::Key_Left ? -across : 0.0;
    place.output += key == Qt::Key_Up ? up : key == Qt::Key_Down ? -up : 0.0;
    move_chosen(place);
}

void CurveEditor::add_behind_chosen() {
    const auto& points = curve_.points;
    const auto i = static_cast<std::size_t>(std::max(chosen_, 0));
    const brush::CurvePoint from = points[i];
    const brush::CurvePoint to =
        i + 1 < points.size() ? points[i + 1] : brush::CurvePoint{frame_.most_input, from.output};
    const int added = add({0.5 * (from.input + to.input), 0.5 * (from.output + to.output)});
    if (added < 0) return;
    Q_EMIT edited(curve_.points);
    choose(added);
}

void CurveEditor::remove_chosen() {
    const int last = static_cast<int>(curve_.points.size()) - 1;
    if (chosen_ < 0 || last <= 0 || (rises_ && (chosen_ == 0 || chosen_ == last))) return;
    tools::remove_point(curve_.points, chosen_);
    Q_EMIT edited(curve_.points);
    choose(std::min(chosen_, static_cast<int>(curve_.points.size()) - 1));
}

// ---- events

void CurveEditor::mousePressEvent(QMouseEvent* event) {
    if (curve_.points.empty()) return;
    const int near = point_near(event->position());
    if (event->button() == Qt::RightButton) {
        choose(near);
        remove_chosen();
        return;
    }
    if (event->button() != Qt::LeftButton) return;
    dragging_ = true;
    if (near >= 0) return choose(near);
    const int added = add(point_at(event->position()));
    if (added >= 0) Q_EMIT edited(curve_.points);
    choose(added);
}

void CurveEditor::mouseMoveEvent(QMouseEvent* event) {
    if (curve_.points.empty()) return;
    if (dragging_)
        move_chosen(point_at(event->position()));
    else
        Q_EMIT read_at(std::clamp(point_at(event->position()).input, 0.0, frame_.most_input));
}

void CurveEditor::mouseReleaseEvent(QMouseEvent*) {
    dragging_ = false;
}

void CurveEditor::keyPressEvent(QKeyEvent* event) {
    const int last = static_cast<int>(curve_.points.size()) - 1;
    if (last < 0) return QWidget::keyPressEvent(event);
    switch (event->key()) {
        case Qt::Key_PageDown:
            return choose(std::min(chosen_ + 1, last));
        case Qt::Key_PageUp:
            return choose(std::max(chosen_ - 1, 0));
        case Qt::Key_Insert:
            return add_behind_chosen();
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            return remove_chosen();
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Up:
        case Qt::Key_Down:
            return step_chosen(event->key(), event->modifiers().testFlag(Qt::ControlModifier));
        default:
            QWidget::keyPressEvent(event);
    }
}

void CurveEditor::focusInEvent(QFocusEvent* event) {
    if (chosen_ < 0 && event->reason() != Qt::MouseFocusReason && !curve_.points.empty()) choose(0);
    QWidget::focusInEvent(event);
}

void CurveEditor::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(hasFocus() ? palette().highlight().color() : QColor(0, 0, 0, 140));
    painter.setBrush(palette().base());
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
    if (curve_.points.empty()) return;
    const QRectF area = plot();
    painter.setPen(QPen(palette().color(QPalette::Button), 1.0));
    for (int i = 0; i <= kGridParts; ++i) {
        const double x = area.left() + area.width() * i / kGridParts;
        const double y = area.top() + area.height() * i / kGridParts;
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    }
    QPolygonF line;
    line << QPointF(area.left(), position_of(curve_.points.front()).y());
    for (const brush::CurvePoint& point : curve_.points)
        line << position_of(point);
    line << QPointF(area.right(), position_of(curve_.points.back()).y());
    painter.setPen(QPen(palette().color(QPalette::Text), 1.6));
    painter.drawPolyline(line);
    for (int i = 0; i < static_cast<int>(curve_.points.size()); ++i) {
        const bool chosen = i == chosen_;
        painter.setBrush(chosen ? palette().highlight() : palette().window());
        painter.drawEllipse(position_of(curve_.points[static_cast<std::size_t>(i)]), kPointRadius,
                            kPointRadius);
    }
}

}  // namespace pastoso::panels
