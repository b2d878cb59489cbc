#include "panels/pen/guide_boxes.hpp"

#include "appearance/shown_number.hpp"
#include "panels/parts/labels.hpp"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QVBoxLayout>

namespace pastoso::panels {

QFormLayout* form_in(QVBoxLayout* column) {
    auto* form = new QFormLayout;
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(4);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    column->addLayout(form);
    return form;
}

QDoubleSpinBox* add_number(QFormLayout* form, const QString& name, const QString& words, double least,
                           double most, const QString& unit) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setAccessibleName(words);
    box->setToolTip(
        translated(QT_TR_NOOP("%1: %2 to %3%4"))
            .arg(words, appearance::shown_number(least), appearance::shown_number(most), unit));
    box->setRange(least, most);
    box->setDecimals(unit.isEmpty() ? 0 : 1);
    box->setSuffix(unit);
    box->setKeyboardTracking(false);
    box->setAlignment(Qt::AlignRight);
    form->addRow(words, box);
    return box;
}

}  // namespace pastoso::panels
