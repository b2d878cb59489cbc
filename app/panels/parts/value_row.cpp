#include "panels/parts/value_row.hpp"

#include "panels/parts/section.hpp"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

namespace pastoso::panels {
namespace {

SliderScale scale_of(const ValueRange& range) {
    const ValueRange::Usual ends = range.usual.value_or(ValueRange::Usual{range.least, range.most});
    return {ends.least, ends.most, range.logarithmic};
}

}  // namespace

ValueRow::ValueRow(QGridLayout* grid, const QString& name, const QString& words, const QString& hint,
                   const ValueRange& range)
    : QObject(grid->parentWidget()),
      scale_(scale_of(range)),
      label_(new QLabel(words)),
      slider_(new QSlider(Qt::Horizontal)),
      number_(new QDoubleSpinBox) {
    label_->setObjectName(QStringLiteral("reading"));
    label_->setToolTip(hint);
    slider_->setObjectName(name + QStringLiteral("_slider"));
    number_->setObjectName(name);
    slider_->setRange(0, SliderScale::kSteps);
    slider_->setToolTip(hint);
    slider_->setAccessibleName(words);
    keep_keys_for_canvas(slider_);
    keep_own_keys(slider_, {Qt::Key_PageUp, Qt::Key_PageDown});
    number_->setDecimals(range.decimals);
    number_->setRange(range.least, range.most);
    number_->setSingleStep(
        (range.most - range.least) / 100.0 > 1.0 ? 1.0 : (range.most - range.least) / 100.0);
    number_->setSuffix(range.unit);
    number_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    number_->setAlignment(Qt::AlignRight);
    number_->setKeyboardTracking(false);
    number_->setToolTip(hint);
    number_->setAccessibleName(words);
    number_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    const int row = grid->rowCount();
    grid->addWidget(label_, row, 0);
    grid->addWidget(slider_, row, 1);
    grid->addWidget(number_, row, 2);
    grid->setColumnStretch(1, 1);
    connect(slider_, &QSlider::valueChanged, this,
            [this](int step) { number_->setValue(scale_.value_at(step)); });
    connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        show_slider(value);
        Q_EMIT chosen(value);
    });
    show_slider(range.least);
}

double ValueRow::value() const {
    return number_->value();
}

void ValueRow::show_slider(double value) {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(scale_.step_of(value));
}

void ValueRow::show_value(double value) {
    const QSignalBlocker quiet(number_);
    number_->setValue(value);
    show_slider(value);
}

void ValueRow::setEnabled(bool enabled) {
    label_->setEnabled(enabled);
    slider_->setEnabled(enabled);
    number_->setEnabled(enabled);
}

void ValueRow::setVisible(bool visible) {
    label_->setVisible(visible);
    slider_->setVisible(visible);
    number_->setVisible(visible);
}

}  // namespace pastoso::panels
