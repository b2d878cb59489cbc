#include "liquid/classic/far_field.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>

namespace pastoso::liquid {
namespace {

constexpr int kColumns = 16;      ///< transformed along z at a time
constexpr int kSplinePoints = 6;  ///< along each axis
constexpr int kMargin = 2;        ///< slots before the first sample

/// The least even number that is large enough and a product of the primes that FFTW is quick with.
int period_for(int least) {
    for (int period = (least + 1) / 2 * 2;; period += 2) {
        int rest = period;
        for (const int prime : {2, 3, 5, 7}) {
            while (rest % prime == 0)
                rest /= prime;
        }
        if (rest == 1 || rest == 11 || rest == 13) return period;
    }
}

double smooth_part(double q) {
    constexpr double kEnd = static_cast<double>(kNearReach) * static_cast<double>(kNearReach);
    if (q >= kEnd) return 1.0 / q;
    const double e = q / kEnd - 1.0;
    return (1.0 - e * (1.0 - e * (1.0 - e * (1.0 - e * (1.0 - e))))) / kEnd;
}

/// What spreading by quintic B-splines multiplies a frequency by: their transform at the samples.
double spline_symbol(int frequency, int period) {
    const double angle = 2.0 * std::numbers::pi * frequency / period;
    return (66.0 + 52.0 * std::cos(angle) + 2.0 * std::cos(2.0 * angle)) / 120.0;
}

/// Quintic B-spline weights of the samples from two before the place on, `t` in [0, 1) behind the third.
void spline_weights(float t, float* weights) {
    const auto power = [](float x) { return x * x * x * x * x; };
    for (int n = 0; n < kSplinePoints; ++n) {
        // The sum over the spline's knots, from the nearer end.
        const bool from_left = n >= kSplinePoints / 2;
        const float x =
            from_left ? static_cast<float>(kSplinePoints - 1 - n) + t : static_cast<float>(n + 1) - t;
        float sum = power(x);
        if (x > 1.0F) sum -= 6.0F * power(x - 1.0F);
        if (x > 2.0F) sum += 15.0F * power(x - 2.0F);
        weights[n] = sum / 120.0F;
    }
}

std::size_t product(std::ptrdiff_t a, std::ptrdiff_t b, std::ptrdiff_t c) {
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(b) * static_cast<std::size_t>(c);
}

template <class Memory, class Pointer>
Memory owned(Pointer memory) {
    PASTOSO_CHECK(memory != nullptr);
    return Memory(memory);
}

}  // namespace

FarField::Axis::Axis(int count)
    : samples(count), slots(count + kSplinePoints - 1), period(period_for(2 * (count + kMargin))) {}

FarField::FarField(int nx, int ny, int nz)
    : x_(nx), y_(ny), z_(nz), row_stride_((x_.frequencies() + 7) / 8 * 8) {
    const std::size_t numbers = product(z_.slots, y_.period, row_stride_);
    values_ = owned<FftwComplexes>(fftwf_alloc_complex(numbers));
    columns_ = owned<FftwComplexes>(fftwf_alloc_complex(product(z_.period, kColumns, 1)));
    column_threads_ = 1;
    transform_kernel();
    make_plans();
}

bool FarField::serves(const Lattice& lattice) const {
    return lattice.nx == x_.samples && lattice.ny == y_.samples && lattice.nz == z_.samples;
}

bool FarField::reaches(const Lattice& lattice, const Ball& ball) {
    const auto within = [](float place, int samples) {
        return place >= 0.0F && place < static_cast<float>(samples);
    };
    return within(ball.x, lattice.nx) && within(ball.y, lattice.ny) && within(ball.z, lattice.nz);
}

fftwf_complex* FarField::row(int slot_y, int slot_z) const {
    return values_.get() + row_stride_ * (slot_y + static_cast<std::ptrdiff_t>(y_.period) * slot_z);
}

/// The kernel is even along every axis: a cosine transform of one octant holds all of its frequencies.
/// They are divided by what spreading and the transforms themselves multiply by.
void FarField::transform_kernel() {
    const int nx = x_.frequencies(), ny = y_.frequencies(), nz = z_.frequencies();
    symbol_ = owned<FftwReals>(fftwf_alloc_real(product(nx, ny, nz)));
    FftwPlan plan;
    {
        const std::lock_guard lock(fftw_planner());
        plan.reset(fftwf_plan_r2r_3d(nz, ny, nx, symbol_.get(), symbol_.get(), FFTW_REDFT00,
                                     FFTW_REDFT00, FFTW_REDFT00, FFTW_ESTIMATE));
    }
    const auto for_each = [&](const auto& use) {
        float* value = symbol_.get();
        for (int k = 0; k < nz; ++k)
            for (int j = 0; j < ny; ++j)
                for (int i = 0; i < nx; ++i)
                    use(*value++, i, j, k);
    };
    for_each([&](float& value, int i, int j, int k) {
        value = static_cast<float>(smooth_part(static_cast<double>(i) * i + static_cast<double>(j) * j +
                                               static_cast<double>(k) * k));
    });
    fftwf_execute(plan.get());
    const double numbers = static_cast<double>(x_.period) * y_.period * z_.period;
    for_each([&](float& value, int i, int j, int k) {
        const double spline =
            spline_symbol(i, x_.period) * spline_symbol(j, y_.period) * spline_symbol(k, z_.period);
        value = static_cast<float>(static_cast<double>(value) / (spline * numbers));
    });
}

void FarField::make_plans() {
    const std::lock_guard lock(fftw_planner());
    const int frequencies = x_.frequencies(), stride = static_cast<int>(row_stride_);
    fftwf_complex* values = values_.get();
    auto* reals = reinterpret_cast<float*>(values);
    x_forward_.reset(fftwf_plan_many_dft_r2c(1, &x_.period, y_.slots, reals, nullptr, 1, 2 * stride,
                                             values, nullptr, 1, stride, FFTW_ESTIMATE));
    x_back_.reset(fftwf_plan_many_dft_c2r(1, &x_.period, y_.samples, values, nullptr, 1, stride, reals,
                                          nullptr, 1, 2 * stride, FFTW_ESTIMATE));
    const auto complex_plan = [](int period, int count, int step, fftwf_complex* memory, int sign) {
        return fftwf_plan_many_dft(1, &period, count, memory, nullptr, step, 1, memory, nullptr, step, 1,
                                   sign, FFTW_ESTIMATE);
    };
    y_forward_.reset(complex_plan(y_.period, frequencies, stride, values, FFTW_FORWARD));
    y_back_.reset(complex_plan(y_.period, frequencies, stride, values, FFTW_BACKWARD));
    z_forward_.reset(complex_plan(z_.period, kColumns, kColumns, columns_.get(), FFTW_FORWARD));
    z_back_.reset(complex_plan(z_.period, kColumns, kColumns, columns_.get(), FFTW_BACKWARD));
    for (const FftwPlan* plan : {&x_forward_, &x_back_, &y_forward_, &y_back_, &z_forward_, &z_back_})
        PASTOSO_CHECK(*plan != nullptr);
}

void FarField::clear(core::ThreadPool& pool) {
    pool.run(static_cast<std::size_t>(z_.slots), [&](std::size_t slot, int) {
        std::memset(row(0, static_cast<int>(slot)), 0,
                    sizeof(fftwf_complex) * product(y_.period, row_stride_, 1));
    });
}

void FarField::spread(const std::vector<Ball>& balls) {
    for (const Ball& ball : balls) {
        const int i = static_cast<int>(ball.x), j = static_cast<int>(ball.y),
                  k = static_cast<int>(ball.z);
        float along_x[kSplinePoints], along_y[kSplinePoints], along_z[kSplinePoints];
        spline_weights(ball.x - static_cast<float>(i), along_x);
        spline_weights(ball.y - static_cast<float>(j), along_y);
        spline_weights(ball.z - static_cast<float>(k), along_z);
        for (int c = 0; c < kSplinePoints; ++c) {
            for (int b = 0; b < kSplinePoints; ++b) {
                const float weight = ball.strength * (along_z[c] * along_y[b]);
                float* out = real_row(j + b, k + c) + i;
                for (int a = 0; a < kSplinePoints; ++a)
                    out[a] += weight * along_x[a];
            }
        }
    }
}

void FarField::to_frequencies(core::ThreadPool& pool) {
    pool.run(static_cast<std::size_t>(z_.slots), [&](std::size_t slot, int) {
        const int k = static_cast<int>(slot);
        fftwf_execute_dft_r2c(x_forward_.get(), real_row(0, k), row(0, k));
        fftwf_execute_dft(y_forward_.get(), row(0, k), row(0, k));
    });
}

void FarField::filter_columns(int y, fftwf_complex* columns) const {
    const int frequencies = x_.frequencies(), folded_y = std::min(y, y_.period - y);
    for (int first = 0; first < frequencies; first += kColumns) {
        const int count = std::min(kColumns, frequencies - first);
        std::memset(columns, 0, sizeof(fftwf_complex) * product(z_.period, kColumns, 1));
        for (int z = 0; z < z_.slots; ++z)
            std::memcpy(columns + z * kColumns, row(y, z) + first,
                        sizeof(fftwf_complex) * static_cast<std::size_t>(count));
        fftwf_execute_dft(z_forward_.get(), columns, columns);
        for (int z = 0; z < z_.period; ++z) {
            const float* symbol =
                symbol_.get() + first +
                product(frequencies, folded_y + y_.frequencies() * std::min(z, z_.period - z), 1);
            for (int n = 0; n < count; ++n) {
                columns[z * kColumns + n][0] *= symbol[n];
                columns[z * kColumns + n][1] *= symbol[n];
            }
        }
        fftwf_execute_dft(z_back_.get(), columns, columns);
        for (int z = kMargin; z < kMargin + z_.samples; ++z)
            std::memcpy(row(y, z) + first, columns + z * kColumns,
                        sizeof(fftwf_complex) * static_cast<std::size_t>(count));
    }
}

void FarField::multiply(core::ThreadPool& pool) {
    const auto threads = static_cast<std::size_t>(pool.thread_count());
    const std::size_t of_thread = product(z_.period, kColumns, 1);
    if (column_threads_ < threads) {
        columns_ = owned<FftwComplexes>(fftwf_alloc_complex(of_thread * threads));
        column_threads_ = threads;
    }
    pool.run(static_cast<std::size_t>(y_.period), [&](std::size_t y, int worker) {
        filter_columns(static_cast<int>(y),
                       columns_.get() + of_thread * static_cast<std::size_t>(worker));
    });
}

void FarField::to_samples(SampledField& field, core::ThreadPool& pool) {
    pool.run(static_cast<std::size_t>(z_.samples), [&](std::size_t layer, int) {
        const int k = static_cast<int>(layer);
        fftwf_execute_dft(y_back_.get(), row(0, k + kMargin), row(0, k + kMargin));
        fftwf_execute_dft_c2r(x_back_.get(), row(kMargin, k + kMargin), real_row(kMargin, k + kMargin));
        for (int j = 0; j < y_.samples; ++j) {
            const float* from = real_row(j + kMargin, k + kMargin) + kMargin;
            float* out = field.row(j, k);
            for (int i = 0; i < x_.samples; ++i)
                out[i] += from[i];
        }
    });
}

void FarField::add(const std::vector<Ball>& balls, SampledField& field, core::ThreadPool& pool) {
    PASTOSO_CHECK(serves(field.lattice()));
    clear(pool);
    spread(balls);
    to_frequencies(pool);
    multiply(pool);
    to_samples(field, pool);
}

}  // namespace pastoso::liquid
