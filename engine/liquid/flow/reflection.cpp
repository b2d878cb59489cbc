#include "liquid/flow/reflection.hpp"

#include "core/check.hpp"
#include "liquid/flow/slices.hpp"

namespace pastoso::liquid {

void reflect(VelocityField& velocity, const VelocityField& projected, core::ThreadPool& pool) {
    const grid::BoxShape& shape = velocity.shape();
    PASTOSO_CHECK(projected.shape() == shape);
    const std::ptrdiff_t slice = shape.stride_z();
    const int slices = static_cast<int>(shape.sample_count() / static_cast<std::size_t>(slice));
    for_slices(pool, 0, slices, [&](int k) {
        for (const int axis : kAxes) {
            float* values = velocity.along(axis).values().data() + k * slice;
            const float* middle = projected.along(axis).values().data() + k * slice;
            for (std::ptrdiff_t n = 0; n < slice; ++n)
                values[n] = 2.0F * middle[n] - values[n];
        }
    });
}

}  // namespace pastoso::liquid
