#include "panels/canvas/easel_panel.hpp"

#include "panels/canvas/illuminant_box.hpp"
#include "panels/canvas/light_dial.hpp"
#include "panels/canvas/tilt_dial.hpp"
#include "panels/parts/section.hpp"

#include <cmath>
#include <iterator>

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

QString degrees_text(double degrees) {
    return QString::number(std::lround(degrees)) + QChar(0xB0);
}

/// What the drying slider stops at.
struct DryingStop {
    double speed;
    const char* words;
};
constexpr DryingStop kDryingStops[] = {DryingStop{0.0, QT_TR_NOOP("never")},
                                       DryingStop{1.0, QT_TR_NOOP("real time")},
                                       DryingStop{10.0, QT_TR_NOOP("10 times")},
                                       DryingStop{60.0, QT_TR_NOOP("a minute a second")},
                                       DryingStop{600.0, QT_TR_NOOP("10 min a second")},
                                       DryingStop{3600.0, QT_TR_NOOP("an hour a second")},
                                       DryingStop{86400.0, QT_TR_NOOP("a day a second")}};

/// The last stop that is not faster.
int drying_stop(double speed) {
    int stop = 0;
    while (stop + 1 < static_cast<int>(std::size(kDryingStops)) && kDryingStops[stop + 1].speed <= speed)
        ++stop;
    return stop;
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
      light_reading_(new QLabel),
      illuminant_(new IlluminantBox),
      drying_(new QSlider(Qt::Horizontal)),
      drying_reading_(new QLabel) {
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(8);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    rows->addLayout(row);
    rows->addWidget(illuminant_row());
    rows->addWidget(drying_row());
    row->addWidget(column(tr("Tilt"), tilt_, tilt_reading_));
    row->addWidget(column(tr("Light"), light_, light_reading_));
    connect(tilt_, &DirectionDial::dragged, this, [this](double angle_deg, double azimuth_deg) {
        write_readings();
        Q_EMIT tilted(angle_deg, azimuth_deg);
    });
    connect(illuminant_, &IlluminantBox::chosen, this, &EaselPanel::illuminant_chosen);
    connect(illuminant_, &IlluminantBox::file_wanted, this, &EaselPanel::illuminant_file_wanted);
    connect(drying_, &QSlider::valueChanged, this, [this](int stop) {
        write_readings();
        Q_EMIT drying_changed(kDryingStops[stop].speed);
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
    dial->setAccessibleName(heading);
    layout->addWidget(dial, 0, Qt::AlignHCenter);
    layout->addWidget(reading);
    return widget;
}

QWidget* EaselPanel::illuminant_row() {
    auto* widget = new QWidget;
    auto* layout = section(widget, tr("Seen in"));
    layout->setSpacing(3);
    illuminant_->setObjectName(QStringLiteral("illuminant"));
    layout->addWidget(illuminant_);
    return widget;
}

QWidget* EaselPanel::drying_row() {
    auto* widget = new QWidget;
    auto* layout = section(widget, tr("Drying"));
    layout->setSpacing(3);
    drying_->setObjectName(QStringLiteral("drying"));
    drying_->setRange(0, static_cast<int>(std::size(kDryingStops)) - 1);
    drying_->setPageStep(1);
    drying_->setToolTip(tr("How fast wet paint dries; D dries it at once"));
    keep_keys_for_canvas(drying_);
    drying_reading_->setObjectName(QStringLiteral("reading"));
    layout->addWidget(drying_);
    layout->addWidget(drying_reading_);
    return widget;
}

void EaselPanel::show_illuminant(const QString& name_or_path) {
    illuminant_->show_illuminant(name_or_path);
}

void EaselPanel::show_drying(double speed) {
    const QSignalBlocker quiet(drying_);
    drying_->setValue(drying_stop(speed));
    write_readings();
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
    drying_reading_->setText(
        QCoreApplication::translate("pastoso::panels", kDryingStops[drying_->value()].words));
}

}  // namespace pastoso::panels
