#include "panels/pen/pen_words.hpp"

#include <QObject>
#include <QStringList>

namespace pastoso::panels {
namespace {

QString percent(double share) {
    return QObject::tr("%1 %").arg(100.0 * share, 0, 'f', 0);
}

QString degrees(double angle_deg) {
    return QStringLiteral("%1\u00b0").arg(angle_deg, 0, 'f', 0);
}

QString button_words(Qt::MouseButtons buttons, bool pen) {
    QStringList words;
    if (buttons.testFlag(Qt::LeftButton)) words += pen ? QObject::tr("tip") : QObject::tr("left");
    if (buttons.testFlag(Qt::MiddleButton)) words += pen ? QObject::tr("lower") : QObject::tr("middle");
    if (buttons.testFlag(Qt::RightButton)) words += pen ? QObject::tr("upper") : QObject::tr("right");
    return words.isEmpty() ? QObject::tr("none") : words.join(QStringLiteral(", "));
}

QString tilt_words(const PenReading& reading) {
    const QString rotation =
        reading.rotation_deg ? degrees(*reading.rotation_deg) : QObject::tr("not told", "rotation");
    return QObject::tr("Tilt %1 across, %2 along; rotation %3; buttons: %4")
        .arg(degrees(reading.tilt_x_deg), degrees(reading.tilt_y_deg), rotation,
             button_words(reading.buttons, true));
}

}  // namespace

QString words_of(const tools::PenDevice& device) {
    const QString name = QString::fromStdString(device.name);
    switch (device.end) {
        case tools::PenEnd::Eraser:
            return QObject::tr("%1, eraser end").arg(name);
        case tools::PenEnd::Puck:
            return QObject::tr("%1, puck").arg(name);
        case tools::PenEnd::Tip:
            break;
    }
    return name;
}

QString words_of(const PenReading& reading) {
    const bool pen = reading.device.has_value();
    const QString device = pen ? words_of(*reading.device) : QObject::tr("Mouse");
    const QString pressure =
        pen ? QObject::tr("pressure %1 \u2192 %2").arg(percent(reading.told), percent(reading.meant))
            : QObject::tr("pressure %1").arg(percent(reading.meant));
    const QString first =
        QObject::tr("%1: %2, %3 events a second").arg(device, pressure).arg(reading.rate_Hz, 0, 'f', 0);
    const QString second =
        pen ? tilt_words(reading) : QObject::tr("Buttons: %1").arg(button_words(reading.buttons, false));
    return first + '\n' + second;
}

}  // namespace pastoso::panels
