#include "brush/wick.hpp"

#include "brush/contents_kernels.hpp"

#include <algorithm>

namespace pastoso::brush {

void wick_paint(Brush& brush, double length_mm) {
    const double wick = std::min(1.0, brush.preset.exchange.wick * length_mm);
    if (wick <= 0.0) return;
    const auto& pairs = brush.tip.neighbours;
    core::kernels<ContentsKernels>().wick(brush.held.data(), pairs.data(),
                                          static_cast<int>(pairs.size()), wick);
}

}  // namespace pastoso::brush
