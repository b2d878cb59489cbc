// Numbers in dialogs: boxes into which other units may be typed, and what of them is for reading.
#pragma once

#include "appearance/unit_box.hpp"

namespace pastoso::dialogs {

using appearance::read_length_mm;
using appearance::read_px_per_mm;
using appearance::UnitBox;

/// What the box says; or `exact`, where that is what it shows, rounded for reading.
double unrounded(const QDoubleSpinBox& box, double exact);

/// A number for reading: without more than two decimals.
double in_hundredths(double value);

}  // namespace pastoso::dialogs
