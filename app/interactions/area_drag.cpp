#include "interactions/area_drag.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::interactions {
namespace {

/// The hand of a click trembles by less.
constexpr double kClick_px = 2.0;

/// The longer side of both, towards the pointer.
glm::dvec2 squared(const glm::dvec2& sides) {
    const double side = std::max(std::abs(sides.x), std::abs(sides.y));
    return {std::copysign(side, sides.x), std::copysign(side, sides.y)};
}

std::vector<glm::dvec2> rectangle(const glm::dvec2& a, const glm::dvec2& b) {
    return {a, {b.x, a.y}, b, {a.x, b.y}};
}

void drop_every_second(std::vector<glm::dvec2>& points) {
    std::vector<glm::dvec2> kept;
    for (std::size_t i = 0; i < points.size(); i += 2)
        kept.push_back(points[i]);
    kept.push_back(points.back());
    points = std::move(kept);
}

}  // namespace

void AreaDrag::press(AreaForm form, const glm::dvec2& place_mm, grid::Combination how) {
    form_ = form;
    how_ = how;
    points_mm_ = form == AreaForm::Rectangle ? rectangle(place_mm, place_mm) : std::vector{place_mm};
}

void AreaDrag::move(const glm::dvec2& place_mm, double px_mm, bool square) {
    if (form_ == AreaForm::Lasso) return add_to_lasso(place_mm, px_mm);
    const glm::dvec2 first = points_mm_.front();
    const glm::dvec2 sides = place_mm - first;
    points_mm_ = rectangle(first, first + (square ? squared(sides) : sides));
}

void AreaDrag::add_to_lasso(const glm::dvec2& place_mm, double px_mm) {
    const std::size_t count = points_mm_.size();
    if (count > 1 && glm::distance(points_mm_[count - 2], points_mm_.back()) < px_mm)
        points_mm_.back() = place_mm;
    else
        points_mm_.push_back(place_mm);
    if (points_mm_.size() > document::kMostOutlinePoints) drop_every_second(points_mm_);
}

std::vector<glm::vec2> AreaDrag::outline_mm() const {
    return {points_mm_.begin(), points_mm_.end()};
}

std::optional<document::SelectArea> AreaDrag::release(double px_mm) {
    form_.reset();
    glm::dvec2 low = points_mm_.front(), high = low;
    for (const glm::dvec2& point : points_mm_) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    const glm::dvec2 sides = high - low;
    if (points_mm_.size() < 3 || std::min(sides.x, sides.y) < kClick_px * px_mm) return std::nullopt;
    document::SelectArea area{.how = how_};
    for (const glm::dvec2& point : points_mm_)
        area.outline.push_back({point.x, point.y});
    return area;
}

}  // namespace pastoso::interactions
