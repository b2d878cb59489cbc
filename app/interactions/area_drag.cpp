#include "interactions/area_drag.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::interactions {
namespace {

/// The hand of a click trembles by less.
constexpr double kClick_px = 2.0;

/// Less is finer than the finest cells.
constexpr double kFinest_mm = 0.01;

/// The longer side of both, towards the pointer.
glm::dvec2 squared(const glm::dvec2& sides) {
    const double side = std::max(std::abs(sides.x), std::abs(sides.y));
    return {std::copysign(side, sides.x), std::copysign(side, sides.y)};
}

std::vector<glm::dvec2> rectangle(const glm::dvec2& a, const glm::dvec2& b) {
    return {a, {b.x, a.y}, b, {a.x, b.y}};
}

/// Within the rectangle of those corners. Its points are so near to each other that the lines between
/// them leave the ellipse nowhere by more than kFinest_mm.
std::vector<glm::dvec2> ellipse(const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 middle = 0.5 * (a + b), half = 0.5 * glm::abs(b - a);
    const double radius = std::max({half.x, half.y, kFinest_mm});
    const int count = std::max(
        12, 4 * static_cast<int>(std::ceil(0.25 * core::kPi / std::acos(1.0 - kFinest_mm / radius))));
    std::vector<glm::dvec2> points;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * core::kPi * i / count;
        points.push_back(middle + half * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return points;
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
    pressed_mm_ = place_mm;
    points_mm_ = {place_mm};
}

void AreaDrag::move(const glm::dvec2& place_mm, double px_mm, bool square) {
    if (form_ == AreaForm::Lasso) return add_to_lasso(place_mm, px_mm);
    const glm::dvec2 sides = place_mm - pressed_mm_;
    const glm::dvec2 opposite = pressed_mm_ + (square ? squared(sides) : sides);
    points_mm_ =
        form_ == AreaForm::Ellipse ? ellipse(pressed_mm_, opposite) : rectangle(pressed_mm_, opposite);
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
    return area_within(points_mm_, how_, px_mm);
}

std::optional<document::SelectArea> area_within(const std::vector<glm::dvec2>& outline_mm,
                                                grid::Combination how, double px_mm) {
    if (outline_mm.size() < 3) return std::nullopt;
    glm::dvec2 low = outline_mm.front(), high = low;
    for (const glm::dvec2& point : outline_mm) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    const glm::dvec2 sides = high - low;
    if (std::min(sides.x, sides.y) < kClick_px * px_mm) return std::nullopt;
    document::SelectArea area{.how = how};
    for (const glm::dvec2& point : outline_mm)
        area.outline.push_back({point.x, point.y});
    return area;
}

}  // namespace pastoso::interactions
