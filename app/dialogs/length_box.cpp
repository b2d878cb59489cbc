#include "dialogs/length_box.hpp"

#include <cmath>

namespace pastoso::dialogs {

double in_hundredths(double value) {
    return std::round(100.0 * value) / 100.0;
}

double unrounded(const QDoubleSpinBox& box, double exact) {
    const double half_step = 0.5 * std::pow(10.0, -box.decimals());
    return std::abs(box.value() - exact) <= half_step ? exact : box.value();
}

}  // namespace pastoso::dialogs
