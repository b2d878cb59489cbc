#include "liquid/cosine_pressure.hpp"

#include "core/check.hpp"
#include "liquid/slices.hpp"
#include "liquid/walls.hpp"

#include <cmath>
#include <numbers>

namespace pastoso::liquid {
namespace {

using Complex = std::complex<float>;

/// Plain products: std::complex's own look after infinities.
Complex times(Complex a, Complex b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
Complex times_conjugate(Complex a, Complex b) {
    return {a.real() * b.real() + a.imag() * b.imag(), a.imag() * b.real() - a.real() * b.imag()};
}

/// Where value i of n stands in the order 0, 2, 4, .. 5, 3, 1.
int place(int i, int n) {
    return i % 2 == 0 ? i / 2 : n - 1 - i / 2;
}

/// From the Fourier coefficients V(k) and V(n - k) along an axis to the cosine's, a and b:
///     a = w V + w* V',   b = i (w V - w* V'),   w = exp(-i pi k / 2n).
void to_cosine(Complex& v, Complex& mirrored, Complex turn) {
    const Complex p = times(v, turn), q = times_conjugate(mirrored, turn), d = p - q;
    v = p + q;
    mirrored = {-d.imag(), d.real()};
}
void from_cosine(Complex& a, Complex& b, Complex turn) {
    const Complex turned = {-b.imag(), b.real()};
    const Complex p = 0.5F * (a - turned), q = 0.5F * (a + turned);
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
/// kx.
void CosinePressure::divide_rows(int ky, int kz) {
    const auto& [x, y, z] = axes_;
    const int mirror_y = (shape_.ny - ky) % shape_.ny, mirror_z = (shape_.nz - kz) % shape_.nz;
    // A row that is its own mirror image only changes by a factor, there and back.
    const int rows_y = mirror_y == ky ? 1 : 2, rows_z = mirror_z == kz ? 1 : 2;
    const std::array<int, 2> ys = {ky, mirror_y}, zs = {kz, mirror_z};
    const Complex turn_y = y.turn[static_cast<std::size_t>(ky)],
                  turn_z = z.turn[static_cast<std::size_t>(kz)];
    const auto at = [](int index) { return static_cast<std::size_t>(index); };
    for (int kx = 0; kx <= shape_.nx / 2; ++kx) {
        std::array<std::array<Complex, 2>, 2> v;
        for (int b = 0; b < rows_z; ++b)
            for (int a = 0; a < rows_y; ++a)
                v[at(b)][at(a)] = spectrum_.row(ys[at(a)], zs[at(b)])[kx];
        if (rows_z == 2)
            for (int a = 0; a < rows_y; ++a)
                to_cosine(v[0][at(a)], v[1][at(a)], turn_z);
        for (int b = 0; b < rows_z; ++b) {
            if (rows_y == 2) to_cosine(v[at(b)][0], v[at(b)][1], turn_y);
            for (int a = 0; a < rows_y; ++a) {
                const float rest = y.eigenvalue[at(ys[at(a)])] + z.eigenvalue[at(zs[at(b)])];
                const float low = x.eigenvalue[at(kx)] + rest,
                            high = x.eigenvalue[at(shape_.nx - kx)] + rest;
                const Complex e = times(v[at(b)][at(a)], x.turn[at(kx)]);
                v[at(b)][at(a)] = times_conjugate(
                    Complex(low > 0.0F ? e.real() / low : 0.0F, e.imag() / high), x.turn[at(kx)]);
            }
            if (rows_y == 2) from_cosine(v[at(b)][0], v[at(b)][1], turn_y);
        }
        if (rows_z == 2)
            for (int a = 0; a < rows_y; ++a)
                from_cosine(v[0][at(a)], v[1][at(a)], turn_z);
        for (int b = 0; b < rows_z; ++b)
            for (int a = 0; a < rows_y; ++a)
                spectrum_.row(ys[at(a)], zs[at(b)])[kx] = v[at(b)][at(a)];
    }
}

void CosinePressure::solve(const grid::BoxField& source, grid::BoxField& pressure,
                           core::ThreadPool& pool) {
    PASTOSO_CHECK(source.shape() == shape_ && pressure.shape() == shape_);
    load(source, pool);
    spectrum_.forward(pool);
    for_slices(pool, 0, shape_.nz / 2 + 1, [&](int kz) {
        for (int ky = 0; ky <= shape_.ny / 2; ++ky)
            divide_rows(ky, kz);
    });
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
