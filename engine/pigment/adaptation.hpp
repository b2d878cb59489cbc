// How the eye takes a light for white: the Bradford transform (Lam 1985; ICC.1:2022, annex E).
#pragma once

#include "pigment/working_space.hpp"

namespace pastoso::pigment {

/// The sharpened cone responses to CIE XYZ.
inline constexpr Matrix3 kConesFromXyz = {
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

constexpr Vector3 cones_of(const Vector3& xyz) {
    return transformed(kConesFromXyz, xyz);
}

/// Takes XYZ seen by an eye adapted to the white `from` to what looks the same to an eye adapted to
/// `to`. Both excite all three kinds of cones.
constexpr Matrix3 bradford(const Vector3& from, const Vector3& to) {
    const Vector3 source = cones_of(from), target = cones_of(to);
    const Matrix3 scaled = product(
        diagonal({target[0] / source[0], target[1] / source[1], target[2] / source[2]}), kConesFromXyz);
    return product(inverse(kConesFromXyz), scaled);
}

}  // namespace pastoso::pigment
