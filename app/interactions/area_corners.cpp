#include "interactions/area_corners.hpp"

#include "interactions/area_drag.hpp"

#include <utility>

#include <glm/geometric.hpp>

namespace pastoso::interactions {
namespace {

/// The hand that clicks twice, or on a corner, misses it by less.
constexpr double kNear_px = 6.0;

}  // namespace

void AreaCorners::begin(const glm::dvec2& place_mm, grid::Combination how) {
    corners_mm_ = {place_mm};
    pointer_mm_ = place_mm;
    how_ = how;
}

bool AreaCorners::closes(const glm::dvec2& place_mm, double px_mm) const {
    const auto is_on = [&](const glm::dvec2& corner_mm) {
        return glm::distance(place_mm, corner_mm) < kNear_px * px_mm;
    };
    return is_on(corners_mm_.back()) || (corners_mm_.size() >= 3 && is_on(corners_mm_.front()));
}

void AreaCorners::add(const glm::dvec2& place_mm) {
    pointer_mm_ = place_mm;
    if (corners_mm_.size() < document::kMostOutlinePoints) corners_mm_.push_back(place_mm);
}

void AreaCorners::take_back() {
    corners_mm_.pop_back();
}

std::vector<glm::vec2> AreaCorners::outline_mm() const {
    std::vector<glm::vec2> points(corners_mm_.begin(), corners_mm_.end());
    points.emplace_back(pointer_mm_);
    return points;
}

std::optional<document::SelectArea> AreaCorners::close(double px_mm) {
    return area_within(std::exchange(corners_mm_, {}), how_, px_mm);
}

}  // namespace pastoso::interactions
