#include "brush/clumps.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pastoso::brush {
namespace {

/// Of a bristle that is not down: beyond all others.
constexpr double kNowhere_mm = std::numeric_limits<double>::infinity();

}  // namespace

void Clumps::find(const std::vector<BristlePose>& poses, const HandPose& hand, double radius_mm) {
    if (order_.size() != poses.size()) {
        order_.resize(poses.size());
        std::iota(order_.begin(), order_.end(), 0);
        sides_mm_.resize(poses.size());
        to_edge_mm_.resize(poses.size());
    }
    for (std::size_t i = 0; i < poses.size(); ++i)
        sides_mm_[i] = poses[i].down ? side_mm(poses[i], hand) : kNowhere_mm;
    sort_by_side();
    const auto side = [&](std::size_t place) { return sides_mm_[order_[place]]; };
    for (std::size_t first = 0; first < order_.size() && side(first) < kNowhere_mm;) {
        std::size_t end = first + 1;
        while (end < order_.size() && side(end) - side(end - 1) <= 2.0 * radius_mm)
            ++end;
        for (std::size_t place = first; place < end; ++place)
            to_edge_mm_[order_[place]] =
                std::min(side(place) - side(first), side(end - 1) - side(place));
        first = end;
    }
}

void Clumps::sort_by_side() {
    for (std::size_t i = 1; i < order_.size(); ++i) {
        const int bristle = order_[i];
        std::size_t place = i;
        for (; place > 0 && sides_mm_[order_[place - 1]] > sides_mm_[bristle]; --place)
            order_[place] = order_[place - 1];
        order_[place] = bristle;
    }
}

}  // namespace pastoso::brush
