#include "tea/number_row.hpp"

#include "panels/section.hpp"

#include <algorithm>
#include <cmath>

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

namespace pastoso::tea {
namespace {

constexpr int kSliderSteps = 200;

}  // namespace

NumberRow::NumberRow(QGridLayout* grid, const QString& name, const QString& words, const QString& hint,
                     const NumberRange& range)
    : QObject(grid->parentWidget()),
      range_(range),
      slider_(new QSlider(Qt::Horizontal)),
      number_(new QDoubleSpinBox) {
    auto* label = new QLabel(words);
    label->setObjectName(QStringLiteral("reading"));
    label->setToolTip(hint);
    slider_->setObjectName(name + QStringLiteral("_slider"));
    slider_->setRange(0, kSliderSteps);
    slider_->setToolTip(hint);
    slider_->setAccessibleName(words);
    panels::keep_keys_for_canvas(slider_);
    number_->setObjectName(name);
    number_->setDecimals(range.decimals);
    number_->setRange(range.least, range.most);
    number_->setSuffix(range.unit);
    number_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    number_->setAlignment(Qt::AlignRight);
    number_->setKeyboardTracking(false);
    number_->setToolTip(hint);
    number_->setAccessibleName(words);
    number_->setMinimumWidth(0);
    number_->setFixedWidth(number_->fontMetrics().averageCharWidth() * 14);
    const int row = grid->rowCount();
    grid->addWidget(label, row, 0);
    grid->addWidget(slider_, row, 1);
    grid->addWidget(number_, row, 2);
    grid->setColumnStretch(1, 1);
    connect(slider_, &QSlider::valueChanged, this,
            [this](int step) { number_->setValue(at_step(step)); });
    connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        show_slider(value);
        Q_EMIT chosen(value);
    });
}

double NumberRow::at_step(int step) const {
    const double share = step / double{kSliderSteps};
    if (range_.logarithmic)
        return range_.usual_least * std::pow(range_.usual_most / range_.usual_least, share);
    return std::lerp(range_.usual_least, range_.usual_most, share);
}

void NumberRow::show_slider(double value) {
    const QSignalBlocker quiet(slider_);
    const double inside = std::clamp(value, range_.usual_least, range_.usual_most);
    const double share =
        range_.logarithmic
            ? std::log(inside / range_.usual_least) / std::log(range_.usual_most / range_.usual_least)
            : (inside - range_.usual_least) / (range_.usual_most - range_.usual_least);
    slider_->setValue(static_cast<int>(std::lround(kSliderSteps * share)));
}

void NumberRow::show_value(double value) {
    const QSignalBlocker quiet(number_);
    number_->setValue(value);
    show_slider(value);
}

}  // namespace pastoso::tea
