#include "liquid/fourier.hpp"

#include "core/check.hpp"
#include "liquid/fftw_memory.hpp"

#include <fftw3.h>
#include <mutex>

namespace pastoso::liquid {
struct FourierBox::Plans {
    FftwPlan plane_forward, plane_backward;    ///< of a slice
    FftwPlan across_forward, across_backward;  ///< of a row in all slices

    Plans(const FourierExtent& extent, float* values) {
        const std::lock_guard lock(fftw_planner());
        // Only estimated plans are the same every time. Some boxes' slices begin at no even address.
        const unsigned flags =
            FFTW_ESTIMATE |
            (extent.slice_stride() % 2 == 0 ? 0U : static_cast<unsigned>(FFTW_UNALIGNED));
        auto* complex = reinterpret_cast<fftwf_complex*>(values);
        const int row = static_cast<int>(extent.row_stride()),
                  slice = static_cast<int>(extent.slice_stride());
        const std::array<int, 2> plane = {extent.ny, extent.nx}, real_rows = {extent.ny, 2 * row},
                                 rows = {extent.ny, row};
        plane_forward.reset(fftwf_plan_many_dft_r2c(2, plane.data(), 1, values, real_rows.data(), 1, 0,
                                                    complex, rows.data(), 1, 0, flags));
        plane_backward.reset(fftwf_plan_many_dft_c2r(2, plane.data(), 1, complex, rows.data(), 1, 0,
                                                     values, real_rows.data(), 1, 0, flags));
        const auto across = [&](int sign) {
            return fftwf_plan_many_dft(1, &extent.nz, extent.half(), complex, nullptr, slice, 1, complex,
                                       nullptr, slice, 1, sign, flags);
        };
        across_forward.reset(across(FFTW_FORWARD));
        across_backward.reset(across(FFTW_BACKWARD));
        PASTOSO_CHECK(plane_forward && plane_backward && across_forward && across_backward);
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
        fftwf_execute_dft_r2c(plans_->plane_forward.get(), slice,
                              reinterpret_cast<fftwf_complex*>(slice));
    });
    pool.run(static_cast<std::size_t>(extent_.ny), [&](std::size_t j, int) {
        auto* rows = reinterpret_cast<fftwf_complex*>(row(static_cast<int>(j), 0));
        fftwf_execute_dft(plans_->across_forward.get(), rows, rows);
    });
}

void FourierBox::backward(core::ThreadPool& pool) {
    pool.run(static_cast<std::size_t>(extent_.ny), [&](std::size_t j, int) {
        auto* rows = reinterpret_cast<fftwf_complex*>(row(static_cast<int>(j), 0));
        fftwf_execute_dft(plans_->across_backward.get(), rows, rows);
    });
    pool.run(static_cast<std::size_t>(extent_.nz), [&](std::size_t k, int) {
        float* slice = real_row(0, static_cast<int>(k));
        fftwf_execute_dft_c2r(plans_->plane_backward.get(), reinterpret_cast<fftwf_complex*>(slice),
                              slice);
    });
}

}  // namespace pastoso::liquid
