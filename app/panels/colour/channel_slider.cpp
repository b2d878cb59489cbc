#include "panels/colour/channel_slider.hpp"

#include "appearance/screen_colours.hpp"
#include "panels/parts/section.hpp"

#include <cmath>

#include <QFontMetrics>
#include <QLinearGradient>
#include <QMouseEvent>
#include <QPainter>
#include <QStyle>

namespace pastoso::panels {
namespace {

constexpr int kHandleHalf = 3;

}  // namespace

ChannelSlider::ChannelSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
    keep_keys_for_canvas(this);
}

void ChannelSlider::show_ramp(const QVector<QColor>& ramp) {
    ramp_ = ramp;
    update();
}

QSize ChannelSlider::sizeHint() const {
    return {6 * fontMetrics().height(), fontMetrics().height() + 2};
}

void ChannelSlider::drag_to(double x) {
    const int place = static_cast<int>(std::lround(x)) - kHandleHalf;
    const int span = width() - 2 * kHandleHalf;
    setSliderPosition(QStyle::sliderValueFromPosition(minimum(), maximum(), place, span));
}

/// The handle jumps to where the ramp is pressed, and is dragged from there.
void ChannelSlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    setSliderDown(true);
    drag_to(event->position().x());
}

void ChannelSlider::mouseMoveEvent(QMouseEvent* event) {
    if (isSliderDown()) drag_to(event->position().x());
}

void ChannelSlider::mouseReleaseEvent(QMouseEvent*) {
    setSliderDown(false);
}

void ChannelSlider::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF bar = QRectF(rect()).adjusted(kHandleHalf, 2.5, -kHandleHalf, -2.5);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    for (qsizetype i = 0; i < ramp_.size(); ++i)
        gradient.setColorAt(static_cast<double>(i) / static_cast<double>(ramp_.size() - 1),
                            appearance::shown(ramp_[i]));
    painter.setPen(hasFocus() ? palette().highlight().color() : QColor(0, 0, 0, 140));
    painter.setBrush(gradient);
    painter.drawRoundedRect(bar, 3.0, 3.0);
    const int span = width() - 2 * kHandleHalf;
    const int x =
        kHandleHalf + QStyle::sliderPositionFromValue(minimum(), maximum(), sliderPosition(), span);
    painter.setPen(QPen(QColor(20, 20, 22), 1.0));
    painter.setBrush(palette().text());
    painter.drawRoundedRect(QRectF(x - kHandleHalf + 0.5, 0.5, 2 * kHandleHalf - 1, height() - 1.0), 2.0,
                            2.0);
}

}  // namespace pastoso::panels
