#include "panels/canvas/easel_panel.hpp"

#include "appearance/terms.hpp"
#include "panels/canvas/light_dial.hpp"
#include "panels/canvas/tilt_dial.hpp"
#include "panels/parts/labels.hpp"
#include "panels/parts/section.hpp"

#include <cmath>
#include <iterator>

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr double kFullTurn_deg = 360.0, kZenith_deg = 90.0;
constexpr QChar kDegreeSign(0xB0);

/// A number of degrees.
QDoubleSpinBox* degrees_box(const char* name, const QString& words, double least_deg, double most_deg) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(QString::fromLatin1(name));
    box->setAccessibleName(words);
    box->setToolTip(words);
    box->setRange(least_deg, most_deg);
    box->setDecimals(0);
    box->setSuffix(kDegreeSign);
    box->setKeyboardTracking(false);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setAlignment(Qt::AlignHCenter);
    return box;
}

/// One that goes on at 0 after a full turn.
QDoubleSpinBox* azimuth_box(const char* name, const QString& words) {
    auto* box = degrees_box(name, words, 0.0, kFullTurn_deg - 1.0);
    box->setWrapping(true);
    return box;
}

/// The heading on the left, and as wide as there is room, what it is of.
QWidget* headed_row(const QString& words, QWidget* value) {
    auto* widget = new QWidget;
    auto* row = new QHBoxLayout(widget);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(heading(words));
    row->addWidget(value, 1);
    return widget;
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

void show_azimuth(QDoubleSpinBox* box, double azimuth_deg) {
    show_number(box, std::fmod(std::round(azimuth_deg), kFullTurn_deg));
}

}  // namespace

EaselPanel::EaselPanel(QWidget* parent)
    : QWidget(parent),
      tilt_(new TiltDial),
      light_(new LightDial),
      drying_(new QSlider(Qt::Horizontal)),
      drying_reading_(new QLabel) {
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(8);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    rows->addLayout(row);
    rows->addWidget(drying_row());
    tilt_boxes_ = {
        degrees_box("tilt", tr("How steeply the canvas stands"), 0.0, tilt_->full_angle_deg()),
        azimuth_box("tilt_direction", tr("Where down is: 0 right, 90 bottom"))};
    tilt_boxes_.angle->setSpecialValueText(tr("flat"));
    light_boxes_ = {degrees_box("light_height", tr("How high the lamp stands"),
                                kZenith_deg - light_->full_angle_deg(), kZenith_deg),
                    azimuth_box("light_direction", tr("Where the light comes from: 0 right, 90 top"))};
    const auto add_column = [&](QWidget* column, appearance::Term term) {
        appearance::explain(column, term);
        row->addWidget(column);
    };
    add_column(column(tr("Tilt"), tilt_, tilt_boxes_), appearance::Term::Tilt);
    add_column(column(tr("Light"), light_, light_boxes_), appearance::Term::Lamp);
    connect(tilt_, &DirectionDial::dragged, this, &EaselPanel::tell_tilt);
    connect(light_, &DirectionDial::dragged, this, &EaselPanel::tell_light);
    connect(tilt_boxes_.angle, &QDoubleSpinBox::valueChanged, this,
            [this](double tilt_deg) { set_tilt(tilt_deg, tilt_->azimuth_deg()); });
    connect(tilt_boxes_.azimuth, &QDoubleSpinBox::valueChanged, this,
            [this](double direction_deg) { set_tilt(tilt_->angle_deg(), direction_deg); });
    connect(light_boxes_.angle, &QDoubleSpinBox::valueChanged, this,
            [this](double elevation_deg) { set_light(elevation_deg, light_->light_azimuth_deg()); });
    connect(light_boxes_.azimuth, &QDoubleSpinBox::valueChanged, this,
            [this](double azimuth_deg) { set_light(light_->elevation_deg(), azimuth_deg); });
    connect(drying_, &QSlider::valueChanged, this, [this](int stop) {
        write_readings();
        Q_EMIT drying_changed(kDryingStops[stop].speed);
    });
    write_readings();
}

QWidget* EaselPanel::column(const QString& heading, DirectionDial* dial, const DirectionBoxes& boxes) {
    auto* widget = new QWidget;
    auto* layout = section(widget, heading);
    layout->setSpacing(3);
    dial->setAccessibleName(heading);
    layout->addWidget(dial, 0, Qt::AlignHCenter);
    auto* numbers = new QHBoxLayout;
    numbers->setSpacing(3);
    for (QDoubleSpinBox* box : {boxes.angle, boxes.azimuth})
        numbers->addWidget(box);
    layout->addLayout(numbers);
    return widget;
}

void EaselPanel::set_tilt(double tilt_deg, double direction_deg) {
    tilt_->set(tilt_deg, direction_deg);
    tell_tilt();
}

void EaselPanel::tell_tilt() {
    write_readings();
    Q_EMIT tilted(tilt_->angle_deg(), tilt_->azimuth_deg());
}

void EaselPanel::set_light(double elevation_deg, double azimuth_deg) {
    light_->set_light(elevation_deg, azimuth_deg);
    tell_light();
}

void EaselPanel::tell_light() {
    write_readings();
    Q_EMIT light_moved(light_->elevation_deg(), light_->light_azimuth_deg());
}

QWidget* EaselPanel::drying_row() {
    auto* widget = new QWidget;
    auto* layout = new QVBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    drying_->setObjectName(QStringLiteral("drying"));
    drying_->setRange(0, static_cast<int>(std::size(kDryingStops)) - 1);
    drying_->setPageStep(1);
    drying_->setAccessibleName(tr("Drying"));
    drying_->setToolTip(tr("How fast wet paint dries; D dries it at once"));
    keep_keys_for_canvas(drying_);
    drying_reading_->setObjectName(QStringLiteral("reading"));
    drying_reading_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    appearance::explain(widget, appearance::Term::Drying);
    layout->addWidget(headed_row(tr("Drying"), drying_reading_));
    layout->addWidget(drying_);
    return widget;
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
    show_number(tilt_boxes_.angle, tilt_->angle_deg());
    show_azimuth(tilt_boxes_.azimuth, tilt_->azimuth_deg());
    show_number(light_boxes_.angle, light_->elevation_deg());
    show_azimuth(light_boxes_.azimuth, light_->light_azimuth_deg());
    drying_reading_->setText(
        QCoreApplication::translate("pastoso::panels", kDryingStops[drying_->value()].words));
}

}  // namespace pastoso::panels
