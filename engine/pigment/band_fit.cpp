#include "pigment/band_fit.hpp"

#include "core/elementary.hpp"
#include "core/random.hpp"
#include "pigment/adaptation.hpp"
#include "pigment/colour_metric.hpp"
#include "pigment/kubelka_munk.hpp"
#include "pigment/observer.hpp"
#include "pigment/palette.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace pastoso::pigment {
namespace {

constexpr int kMixtures = 3000;
constexpr int kRounds = 4;
constexpr double kLn10 = 2.302585092994046;

/// Differences up to this (in CIEDE2000) enter with their square, larger ones with their size.
constexpr double kLargeDifference = 0.3;

/// In each row the last band's weight follows from the others and the white.
constexpr int kFree = kBands - 1;
constexpr int kUnknowns = 3 * kFree;

struct Mixture {
    std::array<double, kBands> reflectance{};
    Vector3 colour{};
    Matrix3 metric{};
};

/// A number of parts from 10^low to 10^high.
double parts(std::uint32_t mixture, std::uint32_t stream, double low, double high) {
    const double share = core::uniform_noise(mixture, stream);
    return core::exponential(kLn10 * (low + (high - low) * share));
}

/// One to five pigments in parts spread over two decades; every second mixture holds ten to a thousand
/// parts of white.
std::vector<std::pair<const Pigment*, double>> recipe(std::uint32_t number) {
    const std::vector<Pigment>& palette = bundled_palette();
    std::vector<std::pair<const Pigment*, double>> result;
    const int count = 1 + static_cast<int>(5.0F * core::uniform_noise(number, 0));
    for (int i = 0; i < count; ++i) {
        const auto which = static_cast<std::size_t>(core::uniform_noise(number, 1 + 2 * i) *
                                                    static_cast<float>(palette.size()));
        result.emplace_back(&palette[which], parts(number, 2 + 2 * i, 0.0, 2.0));
    }
    if (number % 2 == 0) result.emplace_back(&find_pigment("PW6"), parts(number, 100, 1.0, 3.0));
    return result;
}

Mixture mixture(std::uint32_t number, const Spectrum& power, const Matrix3& adapted) {
    Spectrum absorption{}, scattering{};
    std::vector<Portion> portions;
    for (const auto& [pigment, share] : recipe(number)) {
        portions.push_back({pigment->coefficients, share});
        for (int i = 0; i < kSpectralSamples; ++i) {
            absorption[i] += share * pigment->absorption_per_mm[i];
            scattering[i] += share * pigment->scattering_per_mm[i];
        }
    }
    Spectrum reflectance{};
    for (int i = 0; i < kSpectralSamples; ++i)
        reflectance[i] = through_surface(opaque_reflectance(absorption[i], scattering[i]));
    Mixture result;
    result.colour = transformed(adapted, tristimulus(reflectance, power));
    result.metric = colour_metric(result.colour, white_xyz(kD65White));
    const Coefficients mixed = mix(portions);
    for (int band = 0; band < kBands; ++band) {
        result.reflectance[band] =
            through_surface(opaque_reflectance<double>(mixed[band], mixed[kBands + band]));
    }
    return result;
}

std::vector<Mixture> mixtures(const Spectrum& power) {
    const Matrix3 adapted = bradford(white_under(power), white_xyz(kD65White));
    std::vector<Mixture> all;
    for (std::uint32_t number = 0; number < kMixtures; ++number)
        all.push_back(mixture(number, power, adapted));
    return all;
}

/// M r - t.
Vector3 difference(const BandsToXyz& matrix, const Mixture& mixture) {
    Vector3 result{};
    for (int i = 0; i < 3; ++i) {
        result[i] = -mixture.colour[i];
        for (int band = 0; band < kBands; ++band)
            result[i] += matrix[i][band] * mixture.reflectance[band];
    }
    return result;
}

double visible_size(const Vector3& difference, const Matrix3& metric) {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            sum += difference[i] * metric[i][j] * difference[j];
    return std::sqrt(std::max(sum, 0.0));
}

/// The normal equations of a correction to the matrix.
struct Equations {
    std::array<std::array<double, kUnknowns>, kUnknowns> coefficient{};
    std::array<double, kUnknowns> right{};

    void add(const Mixture& mixture, const Vector3& difference, double weight) {
        std::array<double, kFree> lever{};
        for (int band = 0; band < kFree; ++band)
            lever[band] = mixture.reflectance[band] - mixture.reflectance[kFree];
        for (int i = 0; i < 3; ++i) {
            const Vector3& metric = mixture.metric[i];
            const double pull =
                metric[0] * difference[0] + metric[1] * difference[1] + metric[2] * difference[2];
            for (int k = 0; k < kFree; ++k) {
                right[i * kFree + k] -= weight * pull * lever[k];
                for (int j = 0; j < 3; ++j)
                    for (int l = 0; l < kFree; ++l)
                        coefficient[i * kFree + k][j * kFree + l] +=
                            weight * metric[j] * lever[k] * lever[l];
            }
        }
    }

    /// By elimination; the equations are symmetric and positive definite, so that no pivoting is needed.
    std::array<double, kUnknowns> solved() {
        for (int pivot = 0; pivot < kUnknowns; ++pivot) {
            for (int row = pivot + 1; row < kUnknowns; ++row) {
                const double factor = coefficient[row][pivot] / coefficient[pivot][pivot];
                for (int k = pivot; k < kUnknowns; ++k)
                    coefficient[row][k] -= factor * coefficient[pivot][k];
                right[row] -= factor * right[pivot];
            }
        }
        for (int row = kUnknowns - 1; row >= 0; --row) {
            for (int k = row + 1; k < kUnknowns; ++k)
                right[row] -= coefficient[row][k] * right[k];
            right[row] /= coefficient[row][row];
        }
        return right;
    }
};

/// Changes the free weights and lets the last band's keep the sum of the row.
void correct(BandsToXyz& matrix, const std::array<double, kUnknowns>& correction) {
    for (int i = 0; i < 3; ++i) {
        for (int band = 0; band < kFree; ++band) {
            matrix[i][band] += correction[i * kFree + band];
            matrix[i][kFree] -= correction[i * kFree + band];
        }
    }
}

}  // namespace

BandsToXyz fitted_bands_to_xyz(const Spectrum& power) {
    const std::vector<Mixture> all = mixtures(power);
    BandsToXyz matrix{};
    for (int i = 0; i < 3; ++i)
        matrix[i].fill(white_xyz(kD65White)[i] / kBands);
    for (int round = 0; round < kRounds; ++round) {
        Equations equations;
        for (const Mixture& mixture : all) {
            const Vector3 apart = difference(matrix, mixture);
            const double size = visible_size(apart, mixture.metric);
            equations.add(mixture, apart, round == 0 ? 1.0 : 1.0 / std::max(size, kLargeDifference));
        }
        correct(matrix, equations.solved());
    }
    return matrix;
}

}  // namespace pastoso::pigment
