#include "liquid/classic/fourier.hpp"

#include "core/random.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

using Number = std::complex<double>;

struct Box {
    FourierExtent extent;
    std::vector<double> values;  ///< between -1 and 1

    explicit Box(const FourierExtent& size) : extent(size) {
        for (int n = 0; n < size.nx * size.ny * size.nz; ++n)
            values.push_back(
                2.0 * static_cast<double>(core::uniform_noise(static_cast<std::uint32_t>(n), 5)) - 1.0);
    }
    double at(int i, int j, int k) const {
        return values[static_cast<std::size_t>((k * extent.ny + j) * extent.nx + i)];
    }
    void put_into(FourierBox& box) const {
        for (int k = 0; k < extent.nz; ++k)
            for (int j = 0; j < extent.ny; ++j)
                for (int i = 0; i < extent.nx; ++i)
                    box.real_row(j, k)[i] = static_cast<float>(at(i, j, k));
    }
    /// By the sum itself.
    Number coefficient(int kx, int ky, int kz) const {
        Number sum = 0.0;
        for (int k = 0; k < extent.nz; ++k)
            for (int j = 0; j < extent.ny; ++j)
                for (int i = 0; i < extent.nx; ++i) {
                    const double turns = static_cast<double>(i * kx) / extent.nx +
                                         static_cast<double>(j * ky) / extent.ny +
                                         static_cast<double>(k * kz) / extent.nz;
                    sum += at(i, j, k) * std::polar(1.0, -2.0 * std::numbers::pi * turns);
                }
        return sum;
    }
};

/// Rows of even and odd lengths, of whole bundles of columns and of what is left over.
constexpr FourierExtent kExtents[] = {{2, 3, 2}, {4, 2, 3}, {6, 5, 4},  {8, 3, 2},  {10, 4, 3},
                                      {5, 4, 2}, {7, 2, 5}, {16, 3, 2}, {30, 2, 2}, {33, 2, 3}};

TEST(Fourier, CoefficientsAreTheSumsThatDefineThem) {
    core::ThreadPool pool(2);
    for (const FourierExtent& extent : kExtents) {
        const Box box(extent);
        FourierBox spectrum(extent);
        box.put_into(spectrum);
        spectrum.forward(pool);
        for (int kz = 0; kz < extent.nz; ++kz)
            for (int ky = 0; ky < extent.ny; ++ky)
                for (int kx = 0; kx < extent.half(); ++kx) {
                    const std::complex<float> found = spectrum.row(ky, kz)[kx];
                    // Some roundings of sums below 200.
                    EXPECT_LT(std::abs(Number(found) - box.coefficient(kx, ky, kz)), 2e-5)
                        << extent.nx << " x " << extent.ny << " x " << extent.nz << " at " << kx << ' '
                        << ky << ' ' << kz;
                }
    }
}

TEST(Fourier, ThereAndBackIsTheNumberOfValuesTimesThem) {
    core::ThreadPool pool(2);
    for (const FourierExtent& extent : kExtents) {
        const Box box(extent);
        FourierBox spectrum(extent);
        box.put_into(spectrum);
        spectrum.forward(pool);
        spectrum.backward(pool);
        const double count = static_cast<double>(box.values.size());
        for (int k = 0; k < extent.nz; ++k)
            for (int j = 0; j < extent.ny; ++j)
                for (int i = 0; i < extent.nx; ++i)
                    EXPECT_NEAR(static_cast<double>(spectrum.real_row(j, k)[i]) / count, box.at(i, j, k),
                                1e-6)
                        << extent.nx << " x " << extent.ny << " x " << extent.nz;
    }
}

}  // namespace
}  // namespace pastoso::liquid
