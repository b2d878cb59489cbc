// Visible differences between near colours.
#pragma once

#include "pigment/matrix3.hpp"

namespace pastoso::pigment {

/// The matrix G for which d' G d is the square of the CIEDE2000 difference (Sharma, Wu, Dalal 2005) of
/// two colours near `xyz` that differ by d in CIE XYZ, the eye adapted to `white`. The terms of the
/// formula that bend the hue (T and the rotation in the blues) are left out.
Matrix3 colour_metric(const Vector3& xyz, const Vector3& white);

}  // namespace pastoso::pigment
