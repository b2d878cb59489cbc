#include "brush/wick.hpp"

#include <algorithm>

namespace pastoso::brush {
namespace {

/// Moves shares of both contents across.
void exchange(Contents& a, Contents& b, double share_of_a, double share_of_b) {
    const double volume_mm3 = a.volume_mm3 * share_of_a - b.volume_mm3 * share_of_b;
    a.volume_mm3 -= volume_mm3;
    b.volume_mm3 += volume_mm3;
    for (int k = 0; k < film::kPaintChannels; ++k) {
        const double amount = a.paint[k] * share_of_a - b.paint[k] * share_of_b;
        a.paint[k] -= amount;
        b.paint[k] += amount;
    }
}

double share_of(double amount_mm3, const Contents& contents) {
    return contents.volume_mm3 > 0.0 ? std::min(1.0, amount_mm3 / contents.volume_mm3) : 0.0;
}

}  // namespace

void wick_paint(Brush& brush, double length_mm) {
    const double wick = std::min(1.0, brush.preset.exchange.wick * length_mm);
    if (wick <= 0.0) return;
    for (const auto& [first, second] : brush.tip.neighbours) {
        Contents &a = brush.held[first], &b = brush.held[second];
        const double both_ways_mm3 = 0.5 * wick * std::min(a.volume_mm3, b.volume_mm3);
        const double one_way_mm3 = 0.25 * wick * (a.volume_mm3 - b.volume_mm3);
        exchange(a, b, share_of(both_ways_mm3 + std::max(one_way_mm3, 0.0), a),
                 share_of(both_ways_mm3 + std::max(-one_way_mm3, 0.0), b));
    }
}

}  // namespace pastoso::brush
