#include "help/tour_bubble.hpp"

#include "appearance/focus_loop.hpp"

#include <algorithm>
#include <array>

#include <QAccessible>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>

namespace pastoso::help {
namespace {

constexpr int kTip_px = 14, kEdge_px = 14;

/// As wide as lines are read well, whatever the size of the letters.
constexpr int kLettersInLine = 36;

/// Around a target, in the order in which they are tried: what is small is better seen above the bubble
/// than beside it.
std::array<QRect, 4> places_beside(const QRect& target, const QSize& size) {
    const QPoint centre = target.center();
    const QPoint upper_left(centre.x() - size.width() / 2, centre.y() - size.height() / 2);
    const QRect right(QPoint(target.right() + 1, upper_left.y()), size);
    const QRect left(QPoint(target.left() - size.width(), upper_left.y()), size);
    const QRect below(QPoint(upper_left.x(), target.bottom() + 1), size);
    const QRect above(QPoint(upper_left.x(), target.top() - size.height()), size);
    if (target.width() < size.width() / 2) return {below, above, right, left};
    return {right, left, below, above};
}

/// Pushed inside as far as it has to be.
QRect within(QRect place, const QRect& around) {
    place.moveLeft(std::clamp(place.left(), around.left(),
                              std::max(around.left(), around.right() + 1 - place.width())));
    place.moveTop(std::clamp(place.top(), around.top(),
                             std::max(around.top(), around.bottom() + 1 - place.height())));
    return place;
}

/// The first that, pushed inside, does not lie on the target; else the last.
QRect best_place(const QRect& target, const QSize& size, const QRect& around) {
    QRect place;
    for (const QRect& beside : places_beside(target, size)) {
        place = within(beside, around);
        if (!place.intersects(target)) break;
    }
    return place;
}

}  // namespace

TourBubble::TourBubble(QWidget* parent)
    : QWidget(parent),
      heading_(new QLabel),
      words_(new QLabel),
      count_(new QLabel),
      next_(new QPushButton),
      leave_(new QPushButton(tr("Skip the tour"))) {
    setObjectName(QStringLiteral("tour_bubble"));
    setAttribute(Qt::WA_NoMousePropagation);  // a click beside its buttons is no stroke
    setCursor(Qt::ArrowCursor);
    heading_->setObjectName(QStringLiteral("heading"));
    count_->setObjectName(QStringLiteral("reading"));
    next_->setObjectName(QStringLiteral("tour_next"));
    leave_->setObjectName(QStringLiteral("tour_leave"));
    next_->setToolTip(tr("Go on with the tour"));
    leave_->setToolTip(
        tr("Leave the tour, as Escape does; \"Show me round\" in the \"Help\" menu brings it back"));
    words_->setWordWrap(true);
    words_->setFixedWidth(kLettersInLine * fontMetrics().averageCharWidth());
    auto* column = new QVBoxLayout(this);
    constexpr int kAround_px = kTip_px + kEdge_px;
    column->setContentsMargins(kAround_px, kAround_px, kAround_px, kAround_px);
    column->setSpacing(8);
    column->addWidget(heading_);
    column->addWidget(words_);
    auto* row = new QHBoxLayout;
    row->addWidget(count_);
    row->addStretch(1);
    row->addWidget(leave_);
    row->addWidget(next_);
    column->addLayout(row);
    connect(next_, &QPushButton::clicked, this, &TourBubble::next_wanted);
    connect(leave_, &QPushButton::clicked, this, &TourBubble::left);
    hide();
}

void TourBubble::show_step(const TourStep& step, const QRect& target) {
    const bool is_last = step.number == step.of;
    heading_->setText(step.heading);
    words_->setText(step.words);
    count_->setText(tr("%1 of %2").arg(step.number).arg(step.of));
    next_->setText(is_last ? tr("Done") : tr("Next"));
    leave_->setVisible(!is_last);
    setAccessibleName(step.heading);
    setAccessibleDescription(step.words);
    point_at(target);
    show();
    raise();
    QAccessibleEvent told(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&told);
}

void TourBubble::take_keys() {
    next_->setFocus(Qt::OtherFocusReason);
}

void TourBubble::point_at(const QRect& target) {
    target_ = target;
    place();
    update();
}

void TourBubble::place() {
    layout()->activate();
    const QRect around = parentWidget()->rect();
    const QRect place = best_place(target_, layout()->sizeHint(), around);
    setGeometry(place);
    const QRect body = rect().adjusted(kTip_px, kTip_px, -kTip_px, -kTip_px);
    const QPoint centre = target_.center() - place.topLeft();
    tip_ = {std::clamp(centre.x(), 0, width() - 1), std::clamp(centre.y(), 0, height() - 1)};
    if (body.contains(tip_)) tip_ = {};
}

/// A body with round corners, and a tip towards what it speaks of.
void TourBubble::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF body = QRectF(rect()).adjusted(kTip_px, kTip_px, -kTip_px, -kTip_px);
    QPainterPath shape;
    shape.addRoundedRect(body, 6.0, 6.0);
    if (!tip_.isNull()) {
        const QPointF root(
            std::clamp<double>(tip_.x(), body.left() + 2 * kTip_px, body.right() - 2 * kTip_px),
            std::clamp<double>(tip_.y(), body.top() + 2 * kTip_px, body.bottom() - 2 * kTip_px));
        const bool is_beside = tip_.x() < body.left() || tip_.x() > body.right();
        const QPointF half = is_beside ? QPointF(0.0, kTip_px) : QPointF(kTip_px, 0.0);
        QPainterPath tip;
        tip.addPolygon(QPolygonF({QPointF(tip_), root - half, root + half, QPointF(tip_)}));
        shape = shape.united(tip);
    }
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
    painter.setBrush(palette().color(QPalette::Window));
    painter.drawPath(shape);
}

/// Return presses the button that has the keys, as it does in dialogs.
void TourBubble::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Escape:
            Q_EMIT left();
            return;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            (leave_->hasFocus() ? leave_ : next_)->click();
            return;
        default:
            QWidget::keyPressEvent(event);
    }
}

/// Between its buttons; a press beside it leaves them.
bool TourBubble::focusNextPrevChild(bool next) {
    return appearance::focus_within(*this, next);
}

}  // namespace pastoso::help
