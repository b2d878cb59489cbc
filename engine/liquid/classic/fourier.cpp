#include "liquid/classic/fourier.hpp"

#include "core/check.hpp"
#include "liquid/classic/fftw_memory.hpp"
#include "liquid/classic/real_rows.hpp"
#include "liquid/flow/slices.hpp"

#include <fftw3.h>
#include <mutex>
#include <optional>

namespace pastoso::liquid {
namespace {

fftwf_complex* at(float* values) {
    return reinterpret_cast<fftwf_complex*>(values);
}

/// `count` transforms of n values, which lie `stride` apart, the transforms `distance`.
FftwPlan plan_of(int n, int count, std::ptrdiff_t stride, std::ptrdiff_t distance, int sign,
                 float* values) {
    FftwPlan plan(fftwf_plan_many_dft(
        1, &n, count, at(values), nullptr, static_cast<int>(stride), static_cast<int>(distance),
        at(values), nullptr, static_cast<int>(stride), static_cast<int>(distance), sign, FFTW_ESTIMATE));
    PASTOSO_CHECK(plan != nullptr);
    return plan;
}

/// There and back again. Only estimated plans are the same every time.
struct PlanPair {
    FftwPlan forward, backward;

    PlanPair() = default;
    PlanPair(int n, int count, std::ptrdiff_t stride, std::ptrdiff_t distance, float* values)
        : forward(plan_of(n, count, stride, distance, FFTW_FORWARD, values)),
          backward(plan_of(n, count, stride, distance, FFTW_BACKWARD, values)) {}
};

}  // namespace

struct FourierBox::Plans {
    FourierExtent extent;
    std::optional<RealRows> pairs;  ///< of an even number of cells along x; their rows are complex
    PlanPair rows;                  ///< of a slice
    PlanPair columns;               ///< of a slice, a cache line of them together
    PlanPair last_columns;          ///< what that leaves over, if any
    PlanPair across;                ///< a row in all slices

    Plans(const FourierExtent& size, float* values) : extent(size) {
        const std::lock_guard lock(fftw_planner());
        const std::ptrdiff_t row = extent.row_stride();
        constexpr int kTogether = FourierExtent::kLine;
        if (extent.nx % 2 == 0) {
            pairs.emplace(extent.nx);
            rows = PlanPair(extent.nx / 2, extent.ny, 1, row, values);
        } else {
            plan_real_rows(values);
        }
        if (whole_bundles() > 0) columns = PlanPair(extent.ny, kTogether, row, 1, values);
        if (left_over() > 0) last_columns = PlanPair(extent.ny, left_over(), row, 1, values);
        across = PlanPair(extent.nz, extent.half(), extent.slice_stride(), 1, values);
    }

    int whole_bundles() const { return extent.half() / FourierExtent::kLine; }
    int left_over() const { return extent.half() % FourierExtent::kLine; }

    void plan_real_rows(float* values) {
        const int n = extent.nx, row = static_cast<int>(extent.row_stride());
        rows.forward.reset(fftwf_plan_many_dft_r2c(1, &n, extent.ny, values, nullptr, 1, 2 * row,
                                                   at(values), nullptr, 1, row, FFTW_ESTIMATE));
        rows.backward.reset(fftwf_plan_many_dft_c2r(1, &n, extent.ny, at(values), nullptr, 1, row,
                                                    values, nullptr, 1, 2 * row, FFTW_ESTIMATE));
        PASTOSO_CHECK(rows.forward && rows.backward);
    }

    void run_columns(FftwPlan PlanPair::*way, float* slice) const {
        const auto run = [&](const PlanPair& plans, int first) {
            fftwf_complex* values = at(slice) + first;
            fftwf_execute_dft((plans.*way).get(), values, values);
        };
        for (int bundle = 0; bundle < whole_bundles(); ++bundle)
            run(columns, FourierExtent::kLine * bundle);
        if (left_over() > 0) run(last_columns, FourierExtent::kLine * whole_bundles());
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

void FourierBox::forward_slice(int k) {
    float* slice = real_row(0, k);
    if (plans_->pairs) {
        fftwf_execute_dft(plans_->rows.forward.get(), at(slice), at(slice));
        for (int j = 0; j < extent_.ny; ++j)
            plans_->pairs->unfold(real_row(j, k));
    } else {
        fftwf_execute_dft_r2c(plans_->rows.forward.get(), slice, at(slice));
    }
    plans_->run_columns(&PlanPair::forward, slice);
}

void FourierBox::backward_slice(int k) {
    float* slice = real_row(0, k);
    plans_->run_columns(&PlanPair::backward, slice);
    if (plans_->pairs) {
        for (int j = 0; j < extent_.ny; ++j)
            plans_->pairs->fold(real_row(j, k));
        fftwf_execute_dft(plans_->rows.backward.get(), at(slice), at(slice));
    } else {
        fftwf_execute_dft_c2r(plans_->rows.backward.get(), at(slice), slice);
    }
}

void FourierBox::forward_across(int j) {
    fftwf_execute_dft(plans_->across.forward.get(), at(real_row(j, 0)), at(real_row(j, 0)));
}

void FourierBox::backward_across(int j) {
    fftwf_execute_dft(plans_->across.backward.get(), at(real_row(j, 0)), at(real_row(j, 0)));
}

void FourierBox::forward(core::ThreadPool& pool) {
    for_slices(pool, 0, extent_.nz, [&](int k) { forward_slice(k); });
    for_slices(pool, 0, extent_.ny, [&](int j) { forward_across(j); });
}

void FourierBox::backward(core::ThreadPool& pool) {
    for_slices(pool, 0, extent_.ny, [&](int j) { backward_across(j); });
    for_slices(pool, 0, extent_.nz, [&](int k) { backward_slice(k); });
}

}  // namespace pastoso::liquid
