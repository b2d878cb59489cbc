// The colour spaces that pictures are made in: linear light of three primaries around the white of D65.
// Both have the transfer curve of sRGB (encode_srgb() in colour.hpp).
#pragma once

#include "pigment/matrix3.hpp"

#include <array>

namespace pastoso::pigment {

enum class WorkingSpace {
    Srgb,       ///< IEC 61966-2-1
    DisplayP3,  ///< the primaries of SMPTE EG 432-1 with D65 and the curve of sRGB
};

/// What users call it: "sRGB", "Display P3".
const char* name_of(WorkingSpace space);

struct Chromaticity {
    double x = 0.0, y = 0.0;
};

/// The chromaticity of the white of both spaces (IEC 61966-2-1).
inline constexpr Chromaticity kD65White = {0.3127, 0.3290};

/// CIE 1931 chromaticities of red, green and blue.
std::array<Chromaticity, 3> primaries_of(WorkingSpace space);

/// CIE XYZ with Y = 1 for white of a chromaticity.
constexpr Vector3 white_xyz(const Chromaticity& white) {
    return {white.x / white.y, 1.0, (1.0 - white.x - white.y) / white.y};
}

/// From linear RGB to CIE XYZ (RGB 1, 1, 1 is white_xyz(kD65White)), and back. The primaries' columns
/// are scaled so that their sum is the white (SMPTE RP 177).
const Matrix3& xyz_from_linear(WorkingSpace space);
const Matrix3& linear_from_xyz(WorkingSpace space);

/// From linear RGB of one space to that of another; colours outside the other get channels below 0 or
/// above 1.
Matrix3 linear_from_linear(WorkingSpace to, WorkingSpace from);

/// The luminance of each primary, sum 1; four digits, as the standards print them.
std::array<float, 3> luminance_weights(WorkingSpace space);

}  // namespace pastoso::pigment
