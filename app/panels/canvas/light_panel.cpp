#include "panels/canvas/light_panel.hpp"

#include "appearance/terms.hpp"
#include "panels/canvas/illuminant_box.hpp"
#include "panels/canvas/light_dial.hpp"
#include "panels/parts/section.hpp"
#include "panels/parts/value_row.hpp"

#include <cmath>

#include <QComboBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr double kPercent = 100.0;
constexpr double kLowest_deg = 5.0;

struct FinishWords {
    shade::Finish finish;
    const char* words;
};
constexpr FinishWords kFinishes[] = {{shade::Finish::None, QT_TR_NOOP("None")},
                                     {shade::Finish::Matte, QT_TR_NOOP("Matte")},
                                     {shade::Finish::Satin, QT_TR_NOOP("Satin")},
                                     {shade::Finish::Gloss, QT_TR_NOOP("Gloss")}};

QGridLayout* rows_of(QWidget* widget) {
    auto* grid = new QGridLayout(widget);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    return grid;
}

/// 0 to 360.
double whole_turn(double azimuth_deg) {
    const double rest = std::fmod(azimuth_deg, 360.0);
    return rest < 0.0 ? rest + 360.0 : rest;
}

}  // namespace

LightPanel::LightPanel(QWidget* parent)
    : QWidget(parent), dial_(new LightDial), illuminant_(new IlluminantBox), finish_(new QComboBox) {
    auto* column = new QVBoxLayout(this);
    column->setSpacing(12);
    column->addWidget(lamp_section());
    auto* seen_in = new QWidget;
    illuminant_->setObjectName(QStringLiteral("illuminant"));
    appearance::explain(seen_in, appearance::Term::Seen);
    section(seen_in, tr("Seen in"))->addWidget(illuminant_);
    column->addWidget(varnish_section());
    column->addWidget(seen_in);
    column->addStretch(1);
    connect(illuminant_, &IlluminantBox::chosen, this, &LightPanel::illuminant_chosen);
    connect(illuminant_, &IlluminantBox::file_wanted, this, &LightPanel::illuminant_file_wanted);
    show_lamp(lamp_);
    show_varnish(varnish_);
}

QWidget* LightPanel::lamp_section() {
    auto* widget = new QWidget;
    appearance::explain(widget, appearance::Term::Lamp);
    auto* layout = section(widget, tr("Lamp"));
    keep_keys_for_canvas(dial_);
    dial_->setAccessibleName(tr("Lamp"));
    layout->addWidget(dial_, 0, Qt::AlignHCenter);
    auto* values = new QWidget;
    auto* grid = rows_of(values);
    azimuth_ = new ValueRow(grid, QStringLiteral("lamp_azimuth"), tr("From"),
                            tr("Where the light comes from: 0 right, 90 above, 180 left, 270 below"),
                            {0.0, 360.0, 0, tr("\u00b0")});
    elevation_ = new ValueRow(grid, QStringLiteral("lamp_height"), tr("Height"),
                              tr("Low light rakes over the relief, 90 is overhead"),
                              {kLowest_deg, 90.0, 0, tr("\u00b0")});
    ambient_ =
        new ValueRow(grid, QStringLiteral("lamp_ambient"), tr("Even light"),
                     tr("The part of the light that comes from all sides; the lamp gives the rest. "
                        "More of it softens the relief"),
                     {0.0, kPercent, 0, tr(" %")});
    layout->addWidget(values);
    const auto moves = [this](ValueRow* row, double shade::Lighting::*part, double scale) {
        connect(row, &ValueRow::chosen, this, [this, part, scale](double value) {
            lamp_.*part = scale * value;
            dial_->set_light(lamp_.elevation_deg, lamp_.azimuth_deg);
            Q_EMIT lamp_changed(lamp_);
        });
    };
    moves(azimuth_, &shade::Lighting::azimuth_deg, 1.0);
    moves(elevation_, &shade::Lighting::elevation_deg, 1.0);
    moves(ambient_, &shade::Lighting::ambient, 1.0 / kPercent);
    connect(dial_, &DirectionDial::dragged, this, [this] {
        lamp_.elevation_deg = dial_->elevation_deg();
        lamp_.azimuth_deg = dial_->light_azimuth_deg();
        show_lamp(lamp_);
        Q_EMIT lamp_changed(lamp_);
    });
    return widget;
}

QWidget* LightPanel::varnish_section() {
    auto* widget = new QWidget;
    appearance::explain(widget, appearance::Term::Varnish);
    auto* layout = section(widget, tr("Varnish"));
    finish_->setObjectName(QStringLiteral("varnish"));
    finish_->setAccessibleName(tr("Varnish"));
    finish_->setToolTip(
        tr("A clear coat to look through, here and in exports; it changes no paint, and can be taken "
           "off again"));
    for (const FinishWords& finish : kFinishes)
        finish_->addItem(QCoreApplication::translate("pastoso::panels", finish.words),
                         static_cast<int>(finish.finish));
    keep_keys_for_canvas(finish_);
    layout->addWidget(finish_);
    auto* values = new QWidget;
    auto* grid = rows_of(values);
    amount_ = new ValueRow(grid, QStringLiteral("varnish_amount"), tr("Amount"),
                           tr("A thin coat evens the gloss only in part"), {0.0, kPercent, 0, tr(" %")});
    yellowing_ = new ValueRow(grid, QStringLiteral("varnish_yellowing"), tr("Aged"),
                              tr("Old varnish turns yellow: 100 % is about a century"),
                              {0.0, kPercent, 0, tr(" %")});
    layout->addWidget(values);
    connect(finish_, &QComboBox::activated, this, [this] {
        varnish_.finish = static_cast<shade::Finish>(finish_->currentData().toInt());
        enable_varnish();
        Q_EMIT varnish_chosen(varnish_);
    });
    connect(amount_, &ValueRow::chosen, this,
            [this](double percent) { change_varnish(&shade::Varnish::amount, percent); });
    connect(yellowing_, &ValueRow::chosen, this,
            [this](double percent) { change_varnish(&shade::Varnish::yellowing, percent); });
    return widget;
}

void LightPanel::change_varnish(double shade::Varnish::*part, double percent) {
    varnish_.*part = percent / kPercent;
    Q_EMIT varnish_chosen(varnish_);
}

void LightPanel::enable_varnish() {
    const bool coated = varnish_.finish != shade::Finish::None;
    amount_->setEnabled(coated);
    yellowing_->setEnabled(coated);
}

void LightPanel::show_lamp(const shade::Lighting& lamp) {
    lamp_ = lamp;
    dial_->set_light(lamp.elevation_deg, lamp.azimuth_deg);
    azimuth_->show_value(whole_turn(lamp.azimuth_deg));
    elevation_->show_value(lamp.elevation_deg);
    ambient_->show_value(kPercent * lamp.ambient);
}

void LightPanel::show_varnish(const shade::Varnish& varnish) {
    varnish_ = varnish;
    finish_->setCurrentIndex(finish_->findData(static_cast<int>(varnish.finish)));
    amount_->show_value(kPercent * varnish.amount);
    yellowing_->show_value(kPercent * varnish.yellowing);
    enable_varnish();
}

void LightPanel::show_illuminant(const QString& name_or_path) {
    illuminant_->show_illuminant(name_or_path);
}

}  // namespace pastoso::panels
