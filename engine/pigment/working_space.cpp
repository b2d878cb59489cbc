#include "pigment/working_space.hpp"

namespace pastoso::pigment {
namespace {

constexpr std::array<Chromaticity, 3> kSrgbPrimaries = {{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}};
constexpr std::array<Chromaticity, 3> kP3Primaries = {{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}}};

constexpr Matrix3 matrix_of(const std::array<Chromaticity, 3>& primaries) {
    Matrix3 columns{};
    for (int i = 0; i < 3; ++i) {
        const Vector3 primary = white_xyz(primaries[i]);
        for (int row = 0; row < 3; ++row)
            columns[row][i] = primary[row];
    }
    const Vector3 luminances = transformed(inverse(columns), white_xyz(kD65White));
    return product(columns, diagonal(luminances));
}

constexpr Matrix3 kXyzFromSrgb = matrix_of(kSrgbPrimaries);
constexpr Matrix3 kXyzFromP3 = matrix_of(kP3Primaries);
constexpr Matrix3 kSrgbFromXyz = inverse(kXyzFromSrgb);
constexpr Matrix3 kP3FromXyz = inverse(kXyzFromP3);

}  // namespace

const char* name_of(WorkingSpace space) {
    return space == WorkingSpace::Srgb ? "sRGB" : "Display P3";
}

std::array<Chromaticity, 3> primaries_of(WorkingSpace space) {
    return space == WorkingSpace::Srgb ? kSrgbPrimaries : kP3Primaries;
}

const Matrix3& xyz_from_linear(WorkingSpace space) {
    return space == WorkingSpace::Srgb ? kXyzFromSrgb : kXyzFromP3;
}

const Matrix3& linear_from_xyz(WorkingSpace space) {
    return space == WorkingSpace::Srgb ? kSrgbFromXyz : kP3FromXyz;
}

Matrix3 linear_from_linear(WorkingSpace to, WorkingSpace from) {
    return product(linear_from_xyz(to), xyz_from_linear(from));
}

std::array<float, 3> luminance_weights(WorkingSpace space) {
    if (space == WorkingSpace::Srgb) return {0.2126F, 0.7152F, 0.0722F};
    return {0.2290F, 0.6917F, 0.0793F};
}

}  // namespace pastoso::pigment
