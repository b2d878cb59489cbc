#include "glass/number_row.hpp"

#include "panels/parts/section.hpp"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

namespace pastoso::glass {

NumberRow::NumberRow(QGridLayout* grid, const QString& name, const QString& words, const QString& hint,
                     const NumberRange& range)
    : QObject(grid->parentWidget()),
      scale_{range.usual_least, range.usual_most, range.logarithmic},
      slider_(new QSlider(Qt::Horizontal)),
      number_(new QDoubleSpinBox) {
    auto* label = new QLabel(words);
    label->setObjectName(QStringLiteral("reading"));
    label->setToolTip(hint);
    slider_->setObjectName(name + QStringLiteral("_slider"));
    slider_->setRange(0, panels::SliderScale::kSteps);
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
            [this](int step) { number_->setValue(scale_.value_at(step)); });
    connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        show_slider(value);
        Q_EMIT chosen(value);
    });
}

void NumberRow::show_slider(double value) {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(scale_.step_of(value));
}

void NumberRow::show_value(double value) {
    const QSignalBlocker quiet(number_);
    number_->setValue(value);
    show_slider(value);
}

}  // namespace pastoso::glass
