#include "panels/easel_panel.hpp"

#include "panels/light_dial.hpp"
#include "panels/section.hpp"
#include "panels/tilt_dial.hpp"

#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

QString degrees_text(double degrees) {
    return QString::number(std::lround(degrees)) + QChar(0xB0);
}

/// An arrow for one of eight directions, 0 to the right, 90 down.
QString arrow_text(double azimuth_deg) {
    static constexpr char16_t kArrows[] = u"→↘↓↙←↖↑↗";
    const long eighth = std::lround(azimuth_deg / 45.0) % 8;
    return QString(QChar(kArrows[(eighth + 8) % 8]));
}

}  // namespace

EaselPanel::EaselPanel(QWidget* parent)
    : QWidget(parent),
      tilt_(new TiltDial),
      light_(new LightDial),
      tilt_reading_(new QLabel),
      light_reading_(new QLabel) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(column(tr("Tilt"), tilt_, tilt_reading_));
    row->addWidget(column(tr("Light"), light_, light_reading_));
    connect(tilt_, &DirectionDial::dragged, this, [this](double angle_deg, double azimuth_deg) {
        write_readings();
        Q_EMIT tilted(angle_deg, azimuth_deg);
    });
    connect(light_, &DirectionDial::dragged, this, [this] {
        write_readings();
        Q_EMIT light_moved(light_->elevation_deg(), light_->light_azimuth_deg());
    });
    write_readings();
}

QWidget* EaselPanel::column(const QString& heading, QWidget* dial, QLabel* reading) {
    auto* widget = new QWidget;
    auto* layout = section(widget, heading);
    layout->setSpacing(3);
    reading->setObjectName(QStringLiteral("reading"));
    reading->setAlignment(Qt::AlignHCenter);
    keep_keys_for_canvas(dial);
    layout->addWidget(dial, 0, Qt::AlignHCenter);
    layout->addWidget(reading);
    return widget;
}

void EaselPanel::show_tilt(double tilt_deg, double direction_deg) {
    tilt_->set(tilt_deg, direction_deg);
    write_readings();
}

void EaselPanel::show_light(const shade::Lighting& lighting) {
    light_->set_light(lighting.elevation_deg, lighting.azimuth_deg);
    write_readings();
}

void EaselPanel::write_readings() {
    const bool flat = tilt_->angle_deg() < 0.5;
    tilt_reading_->setText(
        flat ? tr("flat") : degrees_text(tilt_->angle_deg()) + ' ' + arrow_text(tilt_->azimuth_deg()));
    light_reading_->setText(degrees_text(light_->elevation_deg()) + tr(" high"));
}

}  // namespace pastoso::panels
