// Rows of cells in groups of one SIMD register: shared by the kernels of one instruction set.
#pragma once

#include "core/lane_memory.hpp"
#include "film/explicit/halo_block.hpp"

namespace pastoso::film {
namespace lanes = core::lanes;
}

namespace pastoso::film::PASTOSO_ISA {
namespace {

using Lanes = lanes::Widest<float>;
constexpr int kLanes = Lanes::kLanes;

[[maybe_unused, gnu::always_inline]] inline Lanes load(const float* values) {
    return lanes::load<Lanes>(values);
}
[[maybe_unused, gnu::always_inline]] inline void store(float* to, Lanes values) {
    lanes::store(to, values);
}

/// The lanes of a register are neighbours in a row of a block, ...
struct AlongRow {
    [[gnu::always_inline]] Lanes operator()(const float* values) const { return load(values); }
};
/// ... or in a column.
struct AlongColumn {
    Lanes operator()(const float* values) const {
        return lanes::generate<Lanes>([values](int lane) { return values[lane * kBlockStride]; });
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
