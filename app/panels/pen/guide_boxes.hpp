// Boxes for the numbers of guides and symmetries.
#pragma once

class QDoubleSpinBox;
class QFormLayout;
class QString;
class QVBoxLayout;

namespace pastoso::panels {

/// A form at the end of the column.
QFormLayout* form_in(QVBoxLayout* column);

/// A row of the form. A number without a unit is whole.
QDoubleSpinBox* add_number(QFormLayout* form, const QString& name, const QString& words, double least,
                           double most, const QString& unit);

}  // namespace pastoso::panels
