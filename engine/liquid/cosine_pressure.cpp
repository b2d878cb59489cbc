#include "liquid/cosine_pressure.hpp"

#include "core/check.hpp"
#include "liquid/sample_lanes.hpp"
#include "liquid/slices.hpp"
#include "liquid/walls.hpp"

#include <cmath>
#include <numbers>

namespace pastoso::liquid {
namespace {

/// Two complex numbers lie in a Four.
constexpr int kNumbersAtOnce = 2;

PASTOSO_LIQUID_INLINE Four parts_swapped(Four v) {
    return __builtin_shufflevector(v, v, 1, 0, 3, 2);
}
PASTOSO_LIQUID_INLINE Four times_i(Four v) {
    return parts_swapped(v) * Four{-1.0F, 1.0F, -1.0F, 1.0F};
}

/// A factor of complex numbers: its real part, and its imaginary part with the signs that it has in a
/// product.
struct Turn {
    Four real, imaginary;
    explicit Turn(std::complex<float> w)
        : real(all(w.real())), imaginary{-w.imag(), w.imag(), -w.imag(), w.imag()} {}
    Turn(Four real_parts, Four imaginary_parts) : real(real_parts), imaginary(imaginary_parts) {}
};
PASTOSO_LIQUID_INLINE Four times(Four v, const Turn& w) {
    return v * w.real + parts_swapped(v) * w.imaginary;
}
PASTOSO_LIQUID_INLINE Four times_conjugate(Four v, const Turn& w) {
    return v * w.real - parts_swapped(v) * w.imaginary;
}

/// Where value i of n stands in the order 0, 2, 4, .. 5, 3, 1.
int place(int i, int n) {
    return i % 2 == 0 ? i / 2 : n - 1 - i / 2;
}

/// From the Fourier coefficients V(k) and V(n - k) along an axis to the cosine's, a and b:
///     a = w V + w* V',   b = i (w V - w* V'),   w = exp(-i pi k / 2n).
PASTOSO_LIQUID_INLINE void to_cosine(Four& v, Four& mirrored, const Turn& turn) {
    const Four p = times(v, turn), q = times_conjugate(mirrored, turn);
    v = p + q;
    mirrored = times_i(p - q);
}
PASTOSO_LIQUID_INLINE void from_cosine(Four& a, Four& b, const Turn& turn) {
    const Four turned = times_i(b);
    const Four p = all(0.5F) * (a - turned), q = all(0.5F) * (a + turned);
    a = times_conjugate(p, turn);
    b = times(q, turn);
}

/// The faces of the box itself let nothing through.
void close_box(VelocityField& velocity) {
    const grid::BoxShape& shape = velocity.shape();
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            velocity.x.at(0, j, k) = velocity.x.at(shape.nx, j, k) = 0.0F;
    for (int k = 0; k < shape.nz; ++k)
        for (int i = 0; i < shape.nx; ++i)
            velocity.y.at(i, 0, k) = velocity.y.at(i, shape.ny, k) = 0.0F;
    for (int j = 0; j < shape.ny; ++j)
        for (int i = 0; i < shape.nx; ++i)
            velocity.z.at(i, j, 0) = velocity.z.at(i, j, shape.nz) = 0.0F;
}

}  // namespace

CosinePressure::CosinePressure(const grid::BoxShape& shape)
    : shape_((check_box_shape(shape), shape)),
      spectrum_(FourierExtent{shape.nx, shape.ny, shape.nz}),
      source_(shape),
      pressure_(shape) {
    const std::array<int, 3> sizes = {shape.nx, shape.ny, shape.nz};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int k = 0; k <= sizes[axis]; ++k) {
            const double angle = std::numbers::pi * k / sizes[axis], half_sine = std::sin(0.5 * angle);
            axes_[axis].eigenvalue.push_back(static_cast<float>(4.0 * half_sine * half_sine));
            axes_[axis].turn.emplace_back(static_cast<float>(std::cos(0.5 * angle)),
                                          static_cast<float>(-half_sine));
        }
    find_frequencies_x();
}

void CosinePressure::find_frequencies_x() {
    const auto& [eigenvalue, turn] = axes_[0];
    const auto count = static_cast<std::size_t>(2 * spectrum_.extent().row_stride());
    // What pads a row divides nothing by one.
    eigenvalues_x_.assign(count, 1.0F);
    real_x_.assign(count, 0.0F);
    imaginary_x_.assign(count, 0.0F);
    for (std::size_t k = 0; k < static_cast<std::size_t>(spectrum_.extent().half()); ++k) {
        eigenvalues_x_[2 * k] = eigenvalue[k];
        eigenvalues_x_[2 * k + 1] = eigenvalue[static_cast<std::size_t>(shape_.nx) - k];
        real_x_[2 * k] = real_x_[2 * k + 1] = turn[k].real();
        imaginary_x_[2 * k] = -turn[k].imag();
        imaginary_x_[2 * k + 1] = turn[k].imag();
    }
}

void CosinePressure::load(const grid::BoxField& source, core::ThreadPool& pool) {
    for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j) {
            float* out = spectrum_.real_row(place(j, shape_.ny), place(k, shape_.nz));
            const float* in = source.row(j, k);
            for (int i = 0; i < shape_.nx; i += 2)
                out[i / 2] = in[i];
            for (int i = 1; i < shape_.nx; i += 2)
                out[shape_.nx - 1 - i / 2] = in[i];
        }
    });
}

void CosinePressure::store(grid::BoxField& pressure, core::ThreadPool& pool) {
    const float scale = 1.0F / (static_cast<float>(shape_.nx) * static_cast<float>(shape_.ny) *
                                static_cast<float>(shape_.nz));
    for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j) {
            const float* in = spectrum_.real_row(place(j, shape_.ny), place(k, shape_.nz));
            float* out = pressure.row(j, k);
            for (int i = 0; i < shape_.nx; i += 2)
                out[i] = scale * in[i / 2];
            for (int i = 1; i < shape_.nx; i += 2)
                out[i] = scale * in[shape_.nx - 1 - i / 2];
        }
    });
}

/// The rows of frequencies ky, kz and of their mirror images: to cosine coefficients, divided by the
/// eigenvalues, and back. Along x the real part belongs to frequency kx, minus the imaginary one to nx -
/// kx. A row that is its own mirror image only changes by a factor, there and back.
template <std::size_t kRowsY, std::size_t kRowsZ>
void CosinePressure::divide_rows(int ky, int kz) {
    const std::array<int, 2> ys = {ky, (shape_.ny - ky) % shape_.ny},
                             zs = {kz, (shape_.nz - kz) % shape_.nz};
    const Turn turn_y(axes_[1].turn[static_cast<std::size_t>(ky)]),
        turn_z(axes_[2].turn[static_cast<std::size_t>(kz)]);
    std::array<std::array<float*, kRowsY>, kRowsZ> rows;
    std::array<std::array<float, kRowsY>, kRowsZ> rest;
    for (std::size_t b = 0; b < kRowsZ; ++b)
        for (std::size_t a = 0; a < kRowsY; ++a) {
            rows[b][a] = spectrum_.real_row(ys[a], zs[b]);
            rest[b][a] = axes_[1].eigenvalue[static_cast<std::size_t>(ys[a])] +
                         axes_[2].eigenvalue[static_cast<std::size_t>(zs[b])];
        }
    const std::ptrdiff_t count = 2 * spectrum_.extent().row_stride();
    for (std::ptrdiff_t at = 0; at < count; at += 2 * kNumbersAtOnce) {
        const Four eigenvalues = liquid::load(eigenvalues_x_.data() + at);
        const Turn turn_x(liquid::load(real_x_.data() + at), liquid::load(imaginary_x_.data() + at));
        std::array<std::array<Four, kRowsY>, kRowsZ> v;
        for (std::size_t b = 0; b < kRowsZ; ++b)
            for (std::size_t a = 0; a < kRowsY; ++a)
                v[b][a] = liquid::load(rows[b][a] + at);
        for (std::size_t a = 0; kRowsZ == 2 && a < kRowsY; ++a)
            to_cosine(v.front()[a], v.back()[a], turn_z);
        for (std::size_t b = 0; b < kRowsZ; ++b) {
            if (kRowsY == 2) to_cosine(v[b].front(), v[b].back(), turn_y);
            for (std::size_t a = 0; a < kRowsY; ++a) {
                const Four divisor = eigenvalues + all(rest[b][a]);
                const Four coefficients = times(v[b][a], turn_x);
                v[b][a] = times_conjugate(divisor > 0.0F ? coefficients / divisor : all(0.0F), turn_x);
            }
            if (kRowsY == 2) from_cosine(v[b].front(), v[b].back(), turn_y);
        }
        for (std::size_t a = 0; kRowsZ == 2 && a < kRowsY; ++a)
            from_cosine(v.front()[a], v.back()[a], turn_z);
        for (std::size_t b = 0; b < kRowsZ; ++b)
            for (std::size_t a = 0; a < kRowsY; ++a)
                __builtin_memcpy(rows[b][a] + at, &v[b][a], sizeof(Four));
    }
}

void CosinePressure::divide_slices(int kz) {
    const bool one_z = (shape_.nz - kz) % shape_.nz == kz;
    for (int ky = 0; ky <= shape_.ny / 2; ++ky) {
        const bool one_y = (shape_.ny - ky) % shape_.ny == ky;
        if (one_z)
            one_y ? divide_rows<1, 1>(ky, kz) : divide_rows<2, 1>(ky, kz);
        else
            one_y ? divide_rows<1, 2>(ky, kz) : divide_rows<2, 2>(ky, kz);
    }
}

void CosinePressure::solve(const grid::BoxField& source, grid::BoxField& pressure,
                           core::ThreadPool& pool) {
    PASTOSO_CHECK(source.shape() == shape_ && pressure.shape() == shape_);
    load(source, pool);
    spectrum_.forward(pool);
    for_slices(pool, 0, shape_.nz / 2 + 1, [&](int kz) { divide_slices(kz); });
    spectrum_.backward(pool);
    store(pressure, pool);
}

void CosinePressure::project(VelocityField& velocity, core::ThreadPool& pool) {
    const std::ptrdiff_t y = shape_.stride_y(), z = shape_.stride_z();
    close_box(velocity);
    for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j) {
            const float *u = velocity.x.row(j, k), *v = velocity.y.row(j, k), *w = velocity.z.row(j, k);
            float* out = source_.row(j, k);
            for (int i = 0; i < shape_.nx; ++i)
                out[i] = ((u[i] - u[i + 1]) + (v[i] - v[i + y])) + (w[i] - w[i + z]);
        }
    });
    solve(source_, pressure_, pool);
    for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j) {
            float *u = velocity.x.row(j, k), *v = velocity.y.row(j, k), *w = velocity.z.row(j, k);
            const float* p = pressure_.row(j, k);
            for (int i = 1; i < shape_.nx; ++i)
                u[i] -= p[i] - p[i - 1];
            for (int i = 0; j > 0 && i < shape_.nx; ++i)
                v[i] -= p[i] - p[i - y];
            for (int i = 0; k > 0 && i < shape_.nx; ++i)
                w[i] -= p[i] - p[i - z];
        }
    });
}

}  // namespace pastoso::liquid
