// Numbers in the painter's language. Thousands are not set apart, as in boxes for numbers.
#pragma once

#include <QString>

namespace pastoso::appearance {

/// In at most six digits that count.
QString shown_number(double value);

QString shown_number(double value, int decimals);

}  // namespace pastoso::appearance
