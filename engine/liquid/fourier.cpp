#include "liquid/fourier.hpp"

#include "core/check.hpp"

#include <fftw3.h>
#include <mutex>

namespace pastoso::liquid {
namespace {

/// FFTW's planner works for one thread at a time; carrying plans out is free.
std::mutex& planner() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace

struct FourierBox::Plans {
    fftwf_plan plane_forward = nullptr, plane_backward = nullptr;    ///< of a slice
    fftwf_plan across_forward = nullptr, across_backward = nullptr;  ///< of a row in all slices

    Plans(const FourierExtent& extent, float* values) {
        const std::scoped_lock lock(planner());
        // Only estimated plans are the same every time. Some boxes' slices begin at no even address.
        const unsigned flags =
            FFTW_ESTIMATE |
            (extent.slice_stride() % 2 == 0 ? 0U : static_cast<unsigned>(FFTW_UNALIGNED));
        auto* complex = reinterpret_cast<fftwf_complex*>(values);
        const int row = static_cast<int>(extent.row_stride()),
                  slice = static_cast<int>(extent.slice_stride());
        const std::array<int, 2> plane = {extent.ny, extent.nx}, real_rows = {extent.ny, 2 * row},
                                 rows = {extent.ny, row};
        plane_forward = fftwf_plan_many_dft_r2c(2, plane.data(), 1, values, real_rows.data(), 1, 0,
                                                complex, rows.data(), 1, 0, flags);
        plane_backward = fftwf_plan_many_dft_c2r(2, plane.data(), 1, complex, rows.data(), 1, 0, values,
                                                 real_rows.data(), 1, 0, flags);
        const auto across = [&](int sign) {
            return fftwf_plan_many_dft(1, &extent.nz, extent.half(), complex, nullptr, slice, 1, complex,
                                       nullptr, slice, 1, sign, flags);
        };
        across_forward = across(FFTW_FORWARD);
        across_backward = across(FFTW_BACKWARD);
        PASTOSO_CHECK(plane_forward && plane_backward && across_forward && across_backward);
    }
    Plans(const Plans&) = delete;
    Plans& operator=(const Plans&) = delete;
    ~Plans() {
        const std::scoped_lock lock(planner());
        for (const fftwf_plan plan : {plane_forward, plane_backward, across_forward, across_backward})
            if (plan != nullptr) fftwf_destroy_plan(plan);
    }
};

FourierBox::FourierBox(const FourierExtent& extent)
    : extent_(extent),
      values_(2 * extent.count(), 0.0F),
      plans_(std::make_shared<const Plans>(extent, values_.data())) {
    std::fill(values_.begin(), values_.end(), 0.0F);
}
FourierBox::~FourierBox() = default;
FourierBox::FourierBox(FourierBox&&) noexcept = default;
FourierBox& FourierBox::operator=(FourierBox&&) noexcept = default;

void FourierBox::forward(core::ThreadPool& pool) {
    pool.run(static_cast<std::size_t>(extent_.nz), [&](std::size_t k, int) {
        float* slice = real_row(0, static_cast<int>(k));
        fftwf_execute_dft_r2c(plans_->plane_forward, slice, reinterpret_cast<fftwf_complex*>(slice));
    });
    pool.run(static_cast<std::size_t>(extent_.ny), [&](std::size_t j, int) {
        auto* rows = reinterpret_cast<fftwf_complex*>(row(static_cast<int>(j), 0));
        fftwf_execute_dft(plans_->across_forward, rows, rows);
    });
}

void FourierBox::backward(core::ThreadPool& pool) {
    pool.run(static_cast<std::size_t>(extent_.ny), [&](std::size_t j, int) {
        auto* rows = reinterpret_cast<fftwf_complex*>(row(static_cast<int>(j), 0));
        fftwf_execute_dft(plans_->across_backward, rows, rows);
    });
    pool.run(static_cast<std::size_t>(extent_.nz), [&](std::size_t k, int) {
        float* slice = real_row(0, static_cast<int>(k));
        fftwf_execute_dft_c2r(plans_->plane_backward, reinterpret_cast<fftwf_complex*>(slice), slice);
    });
}

}  // namespace pastoso::liquid
