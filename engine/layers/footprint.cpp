#include "layers/footprint.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::layers {
namespace {

using grid::Point;
using Polygon = std::vector<Point>;

/// Shares below this come from rounding alone.
constexpr double kLeastShare = 1e-12;

/// The part of a convex polygon where sign (coordinate - border) >= 0.
void clip(const Polygon& polygon, double Point::*coordinate, double border, double sign, Polygon& part) {
    part.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& from = polygon[i];
        const Point& to = polygon[(i + 1) % polygon.size()];
        const double here = sign * (from.*coordinate - border);
        const double there = sign * (to.*coordinate - border);
        if (here >= 0.0) part.push_back(from);
        if ((here >= 0.0) == (there >= 0.0)) continue;
        const double share = here / (here - there);
        part.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
    }
}

/// The part between border and border + 1; `above` is room to work in.
void clip_to_cell(const Polygon& polygon, double Point::*coordinate, int border, Polygon& above,
                  Polygon& part) {
    clip(polygon, coordinate, border, 1.0, above);
    clip(above, coordinate, border + 1.0, -1.0, part);
}

double area_of(const Polygon& polygon) {
    double twice = 0.0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const Point& o = polygon[0];
        const Point& a = polygon[i - 1];
        const Point& b = polygon[i];
        twice += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
    }
    return 0.5 * std::abs(twice);
}

struct Range {
    int first, end;
};
Range cells_of(const Polygon& polygon, double Point::*coordinate, const Range& within) {
    double low = polygon[0].*coordinate, high = low;
    for (const Point& point : polygon) {
        low = std::min(low, point.*coordinate);
        high = std::max(high, point.*coordinate);
    }
    return {static_cast<int>(std::max<double>(within.first, std::floor(low))),
            static_cast<int>(std::min<double>(within.end, std::ceil(high)))};
}

/// Half of a side, at least half a cell long.
Point half_side(const Point& step) {
    const double longer = 0.5 * std::max(1.0, 1.0 / std::hypot(step.x, step.y));
    return {longer * step.x, longer * step.y};
}

}  // namespace

bool comes_from_somewhere(const Projective& to_source, int x, int y) {
    constexpr double kFarthest = 0.5;
    return to_source.depth(x + 0.5, y + 0.5) >= kFarthest;
}

Footprint::Footprint(const Projective& to_source, const grid::Rect& within)
    : to_source_(to_source), within_(within) {}

const std::vector<CellShare>& Footprint::of(int x, int y) {
    shares_.clear();
    if (!comes_from_somewhere(to_source_, x, y)) return shares_;
    const Point middle = to_source_(x + 0.5, y + 0.5);
    const Steps steps = steps_at(to_source_, x + 0.5, y + 0.5);
    const Point right = half_side(steps.right), down = half_side(steps.down);
    const auto corner = [&](double u, double v) {
        return Point{middle.x + u * right.x + v * down.x, middle.y + u * right.y + v * down.y};
    };
    corners_ = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    const double area = 4.0 * std::abs(right.x * down.y - down.x * right.y);
    const Range rows = cells_of(corners_, &Point::y, {within_.y0, within_.y1});
    for (int row = rows.first; row < rows.end; ++row)
        add_row(corners_, area, row);
    return shares_;
}

void Footprint::add_row(const Polygon& corners, double area, int row) {
    clip_to_cell(corners, &Point::y, row, clipped_, row_);
    if (row_.size() < 3) return;
    const Range columns = cells_of(row_, &Point::x, {within_.x0, within_.x1});
    for (int column = columns.first; column < columns.end; ++column) {
        clip_to_cell(row_, &Point::x, column, clipped_, cell_);
        const double share = area_of(cell_) / area;
        if (share >= kLeastShare) shares_.push_back({column, row, share});
    }
}

}  // namespace pastoso::layers
