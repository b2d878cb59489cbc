#include "pigment/viewing.hpp"

#include "pigment/band_fit.hpp"

namespace pastoso::pigment {
namespace {

using Weights = std::array<std::array<double, kBands>, 3>;

Weights in_space(const Matrix3& to_space, const Weights& weights) {
    Weights result{};
    for (int i = 0; i < 3; ++i)
        for (int band = 0; band < kBands; ++band)
            for (int j = 0; j < 3; ++j)
                result[i][band] += to_space[i][j] * weights[j][band];
    return result;
}

Weights daylight_weights() {
    Weights weights{};
    for (int i = 0; i < 3; ++i)
        for (int band = 0; band < kBands; ++band)
            weights[i][band] = kBandsToLinearSrgb[i][band];
    return weights;
}

BandsToRgb rounded(const Weights& weights) {
    BandsToRgb matrix{};
    for (int i = 0; i < 3; ++i)
        for (int band = 0; band < kBands; ++band)
            matrix[i][band] = static_cast<float>(weights[i][band]);
    return matrix;
}

}  // namespace

Viewing viewing_under(const Illuminant& light, WorkingSpace space) {
    if (light.name != kBundledIlluminants.front())
        return {rounded(in_space(linear_from_xyz(space), fitted_bands_to_xyz(light.power))), space};
    if (space == WorkingSpace::Srgb) return {};
    return {rounded(in_space(linear_from_linear(space, WorkingSpace::Srgb), daylight_weights())), space};
}

}  // namespace pastoso::pigment
