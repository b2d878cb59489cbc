// Rows of cells in groups of one SIMD register: shared by the kernels of one instruction set.
#pragma once

#include "film/explicit/halo_block.hpp"
#include "film/face/lanes.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

using Lanes = lanes::stdx::native_simd<float>;
constexpr int kLanes = static_cast<int>(Lanes::size());

[[maybe_unused, gnu::always_inline]] inline Lanes load(const float* values) {
    return Lanes(values, lanes::stdx::element_aligned);
}
[[maybe_unused, gnu::always_inline]] inline void store(float* values, Lanes lanes) {
    lanes.copy_to(values, lanes::stdx::element_aligned);
}

/// The lanes of a register are neighbours in a row of a block, ...
struct AlongRow {
    [[gnu::always_inline]] Lanes operator()(const float* values) const { return load(values); }
};
/// ... or in a column.
struct AlongColumn {
    Lanes operator()(const float* values) const {
        return Lanes([values](int lane) { return values[lane * kBlockStride]; });
    }
};

/// Calls body(x) for groups of kLanes neighbouring cells that cover [first, last); the final group is
/// moved back to end at `last`, so that nothing beyond is touched.
template <class Body>
[[gnu::always_inline]] inline void for_each_lane_group(int first, int last, const Body& body) {
    int x = first;
    for (; x + kLanes <= last; x += kLanes)
        body(x);
    if (x < last) body(last - kLanes);
}

}  // namespace
}  // namespace pastoso::film::PASTOSO_ISA
