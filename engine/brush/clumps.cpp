#include "brush/clumps.hpp"

#include <algorithm>
#include <limits>

namespace pastoso::brush {
namespace {

/// Of a bristle that is not down: beyond all others.
constexpr double kNowhere_mm = std::numeric_limits<double>::infinity();

}  // namespace

void Clumps::find(const std::vector<BristlePose>& poses, const HandPose& hand, double radius_mm) {
    if (places_.size() != poses.size()) {
        places_.clear();
        for (int bristle = 0; bristle < static_cast<int>(poses.size()); ++bristle)
            places_.push_back({0.0, bristle});
        to_edge_mm_.resize(poses.size());
    }
    sort_by_side(poses, hand);
    const auto lifted = std::find_if(places_.begin(), places_.end(),
                                     [](const Place& place) { return place.side_mm == kNowhere_mm; });
    for (auto first = places_.begin(); first != lifted;) {
        auto last = first;
        while (last + 1 != lifted && (last + 1)->side_mm - last->side_mm <= 2.0 * radius_mm)
            ++last;
        for (auto place = first; place <= last; ++place)
            to_edge_mm_[place->bristle] =
                std::min(place->side_mm - first->side_mm, last->side_mm - place->side_mm);
        first = last + 1;
    }
}

void Clumps::sort_by_side(const std::vector<BristlePose>& poses, const HandPose& hand) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        Place place = places_[i];
        const BristlePose& pose = poses[place.bristle];
        place.side_mm = pose.down ? side_mm(pose, hand) : kNowhere_mm;
        std::size_t to = i;
        for (; to > 0 && places_[to - 1].side_mm > place.side_mm; --to)
            places_[to] = places_[to - 1];
        places_[to] = place;
    }
}

}  // namespace pastoso::brush
