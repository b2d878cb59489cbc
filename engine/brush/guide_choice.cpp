#include "brush/guide_choice.hpp"

#include <cmath>
#include <utility>

namespace pastoso::brush {

std::vector<PenSample> GuideChoice::add(const PenSample& sample) {
    const bool line = std::holds_alternative<StraightLine>(guide_.form);
    if (!line && !is_open()) return {sample};
    held_.push_back(sample);
    const PenSample& down = held_.front();
    const bool far = std::hypot(sample.x_mm - down.x_mm, sample.y_mm - down.y_mm) >= kFirstWay_mm;
    return far && !line ? choose() : std::vector<PenSample>{};
}

std::vector<PenSample> GuideChoice::end() {
    if (held_.empty()) return {};
    return is_open() ? choose() : straightened(std::move(held_), guide_.turn_across);
}

bool GuideChoice::is_open() const {
    return guide_.strength > 0.0 && (std::holds_alternative<VanishingPoints>(guide_.form) ||
                                     std::holds_alternative<Grid>(guide_.form));
}

std::vector<PenSample> GuideChoice::choose() {
    guide_ = chosen_for_stroke(guide_, held_.front(), held_.back());
    return std::exchange(held_, {});
}

}  // namespace pastoso::brush
