#include "liquid/classic/cosine_pressure.hpp"

#include "core/check.hpp"
#include "liquid/classic/complex_lanes.hpp"
#include "liquid/flow/slices.hpp"
#include "liquid/flow/walls.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace pastoso::liquid {
namespace {

/// Into so many runs of slices the way back is cut, whatever threads there are.
constexpr int kRuns = 16;

/// Where value i of n stands in the order 0, 2, 4, .. 5, 3, 1.
int place(int i, int n) {
    return i % 2 == 0 ? i / 2 : n - 1 - i / 2;
}

/// From the Fourier coefficients V(k) and V(n - k) along an axis to the cosine's, a and b:
///     a = w V + w* V',   b = i (w V - w* V'),   w = exp(-i pi k / 2n).
PASTOSO_LANE_FUNCTION void to_cosine(Four& v, Four& mirrored, const Turn& turn) {
    const Four p = times(v, turn), q = times_conjugate(mirrored, turn);
    v = p + q;
    mirrored = times_i(p - q);
}
PASTOSO_LANE_FUNCTION void from_cosine(Four& a, Four& b, const Turn& turn) {
    const Four turned = times_i(b);
    const Four p = Four(0.5F) * (a - turned), q = Four(0.5F) * (a + turned);
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
    : shape_((check_box_shape(shape), shape)), spectrum_(FourierExtent{shape.nx, shape.ny, shape.nz}) {
    const std::array<int, 3> sizes = {shape.nx, shape.ny, shape.nz};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int k = 0; k <= sizes[axis]; ++k) {
            const double angle = std::numbers::pi * k / sizes[axis], half_sine = std::sin(0.5 * angle);
            axes_[axis].eigenvalue.push_back(static_cast<float>(4.0 * half_sine * half_sine));
            axes_[axis].turn.emplace_back(static_cast<float>(std::cos(0.5 * angle)),
                                          static_cast<float>(-half_sine));
        }
    compute_frequencies_x();
}

void CosinePressure::compute_frequencies_x() {
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

/// To the order 0, 2, 4, .. 5, 3, 1.
void CosinePressure::load_row(const float* source, int j, int k) {
    float* out = spectrum_.real_row(place(j, shape_.ny), place(k, shape_.nz));
    const int nx = shape_.nx;
    int i = 0;
    for (; i + 8 <= nx; i += 8) {
        const Four first = lanes::load<Four>(source + i), second = lanes::load<Four>(source + i + 4);
        lanes::store(out + i / 2, lanes::permuted<0, 2, 4, 6>(first, second));
        lanes::store(out + nx - 4 - i / 2, lanes::permuted<7, 5, 3, 1>(first, second));
    }
    for (; i < nx; ++i)
        out[place(i, nx)] = source[i];
}

void CosinePressure::store_row(int j, int k, float* pressure) {
    const float scale = 1.0F / (static_cast<float>(shape_.nx) * static_cast<float>(shape_.ny) *
                                static_cast<float>(shape_.nz));
    const float* in = spectrum_.real_row(place(j, shape_.ny), place(k, shape_.nz));
    const int nx = shape_.nx;
    int i = 0;
    for (; i + 8 <= nx; i += 8) {
        const Four even = Four(scale) * lanes::load<Four>(in + i / 2),
                   odd = Four(scale) * lanes::load<Four>(in + nx - 4 - i / 2);
        lanes::store(pressure + i, lanes::permuted<0, 7, 1, 6>(even, odd));
        lanes::store(pressure + i + 4, lanes::permuted<2, 5, 3, 4>(even, odd));
    }
    for (; i < nx; ++i)
        pressure[i] = scale * in[place(i, nx)];
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
        const Four eigenvalues = lanes::load<Four>(eigenvalues_x_.data() + at);
        const Turn turn_x(lanes::load<Four>(real_x_.data() + at),
                          lanes::load<Four>(imaginary_x_.data() + at));
        std::array<std::array<Four, kRowsY>, kRowsZ> v;
        for (std::size_t b = 0; b < kRowsZ; ++b)
            for (std::size_t a = 0; a < kRowsY; ++a)
                v[b][a] = lanes::load<Four>(rows[b][a] + at);
        for (std::size_t a = 0; kRowsZ == 2 && a < kRowsY; ++a)
            to_cosine(v.front()[a], v.back()[a], turn_z);
        for (std::size_t b = 0; b < kRowsZ; ++b) {
            if (kRowsY == 2) to_cosine(v[b].front(), v[b].back(), turn_y);
            for (std::size_t a = 0; a < kRowsY; ++a) {
                const Four divisor = eigenvalues + Four(rest[b][a]);
                const Four coefficients = times(v[b][a], turn_x);
                v[b][a] = times_conjugate(
                    lanes::select(divisor > 0.0F, coefficients / divisor, Four(0.0F)), turn_x);
            }
            if (kRowsY == 2) from_cosine(v[b].front(), v[b].back(), turn_y);
        }
        for (std::size_t a = 0; kRowsZ == 2 && a < kRowsY; ++a)
            from_cosine(v.front()[a], v.back()[a], turn_z);
        for (std::size_t b = 0; b < kRowsZ; ++b)
            for (std::size_t a = 0; a < kRowsY; ++a)
                lanes::store(rows[b][a] + at, v[b][a]);
    }
}

/// Frequency ky along y and its mirror image: a row in all slices each, which stay in the processor's
/// cache from one transform to the other.
void CosinePressure::divide_across(int ky) {
    const int mirrored = (shape_.ny - ky) % shape_.ny;
    const bool one_y = mirrored == ky;
    spectrum_.forward_across(ky);
    if (!one_y) spectrum_.forward_across(mirrored);
    for (int kz = 0; kz <= shape_.nz / 2; ++kz) {
        const bool one_z = (shape_.nz - kz) % shape_.nz == kz;
        if (one_z)
            one_y ? divide_rows<1, 1>(ky, kz) : divide_rows<2, 1>(ky, kz);
        else
            one_y ? divide_rows<1, 2>(ky, kz) : divide_rows<2, 2>(ky, kz);
    }
    spectrum_.backward_across(ky);
    if (!one_y) spectrum_.backward_across(mirrored);
}

void CosinePressure::divide(core::ThreadPool& pool) {
    for_slices(pool, 0, shape_.ny / 2 + 1, [&](int ky) { divide_across(ky); });
}

void CosinePressure::store_slice(int k, float* pressure, std::ptrdiff_t stride) {
    spectrum_.backward_slice(place(k, shape_.nz));
    for (int j = 0; j < shape_.ny; ++j)
        store_row(j, k, pressure + j * stride);
}

void CosinePressure::solve(const grid::BoxField& source, grid::BoxField& pressure,
                           core::ThreadPool& pool) {
    PASTOSO_CHECK(source.shape() == shape_ && pressure.shape() == shape_);
    for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j)
            load_row(source.row(j, k), j, k);
        spectrum_.forward_slice(place(k, shape_.nz));
    });
    divide(pool);
    for_slices(pool, 0, shape_.nz,
               [&](int k) { store_slice(k, pressure.row(0, k), shape_.stride_y()); });
}

void CosinePressure::load_divergence(const VelocityField& velocity, int k) {
    const std::ptrdiff_t y = shape_.stride_y(), z = shape_.stride_z();
    std::array<float, kMaxBoxSide_cells> out;
    for (int j = 0; j < shape_.ny; ++j) {
        const float *u = velocity.x.row(j, k), *v = velocity.y.row(j, k), *w = velocity.z.row(j, k);
        for (int i = 0; i < shape_.nx; ++i)
            out[static_cast<std::size_t>(i)] =
                ((u[i] - u[i + 1]) + (v[i] - v[i + y])) + (w[i] - w[i + z]);
        load_row(out.data(), j, k);
    }
}

void CosinePressure::subtract_gradient(const Slice& pressure, int k, VelocityField& velocity) const {
    const int nx = shape_.nx;
    const float* p = pressure.data();
    for (int j = 0; j < shape_.ny; ++j, p += nx) {
        float *u = velocity.x.row(j, k), *v = velocity.y.row(j, k);
        for (int i = 1; i < nx; ++i)
            u[i] -= p[i] - p[i - 1];
        for (int i = 0; j > 0 && i < nx; ++i)
            v[i] -= p[i] - p[i - nx];
    }
}

void CosinePressure::subtract_gradient_z(const Slice& pressure, const Slice& below, int k,
                                         VelocityField& velocity) const {
    const float *p = pressure.data(), *q = below.data();
    for (int j = 0; j < shape_.ny; ++j, p += shape_.nx, q += shape_.nx) {
        float* w = velocity.z.row(j, k);
        for (int i = 0; i < shape_.nx; ++i)
            w[i] -= p[i] - q[i];
    }
}

/// The divergence goes straight to where it is transformed, and a thread has a slice of the pressure and
/// the one below for a moment only: each pass goes through memory once. Between two runs of slices the
/// first of the one and the last of the other are kept for the end.
void CosinePressure::project(VelocityField& velocity, core::ThreadPool& pool) {
    PASTOSO_CHECK(velocity.shape() == shape_);
    close_box(velocity);
    for_slices(pool, 0, shape_.nz, [&](int k) {
        load_divergence(velocity, k);
        spectrum_.forward_slice(place(k, shape_.nz));
    });
    divide(pool);
    const int runs = std::min(shape_.nz, kRuns);
    const auto begin_of = [&](int run) { return shape_.nz * run / runs; };
    const std::size_t cells = static_cast<std::size_t>(shape_.nx) * static_cast<std::size_t>(shape_.ny);
    std::vector<Slice> first(static_cast<std::size_t>(runs)), last(first.size());
    pool.run(first.size(), [&](std::size_t run, int) {
        const int begin = begin_of(static_cast<int>(run)), end = begin_of(static_cast<int>(run) + 1);
        Slice here(cells), below(cells);
        for (int k = begin; k < end; ++k) {
            std::swap(here, below);
            store_slice(k, here.data(), shape_.nx);
            subtract_gradient(here, k, velocity);
            if (k == begin)
                first[run] = here;
            else
                subtract_gradient_z(here, below, k, velocity);
        }
        last[run] = std::move(here);
    });
    pool.run(first.size() - 1, [&](std::size_t run, int) {
        subtract_gradient_z(first[run + 1], last[run], begin_of(static_cast<int>(run) + 1), velocity);
    });
}

}  // namespace pastoso::liquid
