#include "panels/pen/pen_pad.hpp"

#include "tools/pen_device_of.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QTabletEvent>

namespace pastoso::panels {
namespace {

/// Width of the line at full pressure.
constexpr double kWidest_px = 26.0, kThinnest_px = 0.6;

}  // namespace

PenPad::PenPad(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("pen_pad"));
    setAccessibleName(tr("Sheet to try the pen on"));
    setCursor(Qt::CrossCursor);
    setMouseTracking(true);
    setTabletTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PenPad::wipe() {
    sheet_.fill(Qt::transparent);
    bare_ = true;
    update();
}

// ---- events

void PenPad::tabletEvent(QTabletEvent* event) {
    event->accept();
    rate_.note(event->timestamp());
    PenReading reading;
    reading.told = reading.meant = event->pressure();
    reading.tilt_x_deg = event->xTilt();
    reading.tilt_y_deg = event->yTilt();
    reading.buttons = event->buttons();
    reading.rate_Hz = rate_.hertz();
    if (const QPointingDevice* device = event->pointingDevice()) {
        reading.device = tools::pen_device_of(*device);
        reading.meant = tools::mapped_pressure(settings_, *reading.device, reading.told);
    }
    if (abilities_.note(*event).rotation) reading.rotation_deg = event->rotation();
    if (event->type() == QEvent::TabletPress) Q_EMIT touched(reading.device);
    if (event->buttons().testFlag(Qt::LeftButton))
        scribble(event->position(), reading.meant);
    else
        from_.reset();
    Q_EMIT read(reading);
}

void PenPad::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) Q_EMIT touched(std::nullopt);
    read_mouse(*event);
}

void PenPad::mouseMoveEvent(QMouseEvent* event) {
    read_mouse(*event);
}

void PenPad::mouseReleaseEvent(QMouseEvent* event) {
    read_mouse(*event);
}

/// A mouse tells no pressure: while its button is down, it is what the settings say.
void PenPad::read_mouse(const QMouseEvent& event) {
    rate_.note(event.timestamp());
    mouse_.moved_to({event.position().x(), event.position().y()}, event.timestamp());
    const bool down = event.buttons().testFlag(Qt::LeftButton);
    PenReading reading;
    reading.meant = down ? mouse_.pressure(settings_.mouse) : 0.0;
    reading.buttons = event.buttons();
    reading.rate_Hz = rate_.hertz();
    if (down)
        scribble(event.position(), reading.meant);
    else
        from_.reset();
    Q_EMIT read(reading);
}

// ---- the sheet

void PenPad::scribble(const QPointF& to, double pressure) {
    QPainter painter(&sheet_);
    painter.setRenderHint(QPainter::Antialiasing);
    const double width = std::max(kThinnest_px, kWidest_px * pressure);
    painter.setPen(QPen(palette().color(QPalette::Text), width, Qt::SolidLine, Qt::RoundCap));
    if (pressure > 0.0) painter.drawLine(from_.value_or(to), to);
    from_ = to;
    bare_ = false;
    update();
}

/// What is there stays in its corner.
void PenPad::resizeEvent(QResizeEvent*) {
    QImage sheet(size() * devicePixelRatioF(), QImage::Format_ARGB32_Premultiplied);
    sheet.setDevicePixelRatio(devicePixelRatioF());
    sheet.fill(Qt::transparent);
    if (!sheet_.isNull()) QPainter(&sheet).drawImage(QPointF(0.0, 0.0), sheet_);
    sheet_ = sheet;
}

void PenPad::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QColor(0, 0, 0, 140));
    painter.setBrush(palette().base());
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
    painter.drawImage(QPointF(0.0, 0.0), sheet_);
    if (!bare_) return;
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignCenter, tr("Scribble here with a pen or the mouse"));
}

}  // namespace pastoso::panels
