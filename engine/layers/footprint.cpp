#include "layers/footprint.hpp"

#include "core/check.hpp"

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
Range cells_of(const Polygon& polygon, double Point::*coordinate) {
    double low = polygon[0].*coordinate, high = low;
    for (const Point& point : polygon) {
        low = std::min(low, point.*coordinate);
        high = std::max(high, point.*coordinate);
    }
    return {static_cast<int>(std::floor(low)), static_cast<int>(std::ceil(high))};
}

/// Half of a side, at least half a cell long.
Point half_side(double x, double y) {
    const double longer = 0.5 * std::max(1.0, 1.0 / std::hypot(x, y));
    return {longer * x, longer * y};
}

}  // namespace

Affine inverse(const Affine& map) {
    const double determinant = map.a * map.e - map.b * map.d;
    PASTOSO_CHECK(determinant != 0.0);
    const double scale = 1.0 / determinant;
    const Affine turned{scale * map.e, -scale * map.b, 0.0, -scale * map.d, scale * map.a, 0.0};
    const Point shift = turned(map.c, map.f);
    return {turned.a, turned.b, -shift.x, turned.d, turned.e, -shift.y};
}

Footprint::Footprint(const Affine& to_source)
    : to_source_(to_source),
      half_side_{half_side(to_source.a, to_source.d), half_side(to_source.b, to_source.e)},
      area_(4.0 * std::abs(half_side_[0].x * half_side_[1].y - half_side_[1].x * half_side_[0].y)) {}

const std::vector<CellShare>& Footprint::of(int x, int y) {
    const Point middle = to_source_(x + 0.5, y + 0.5);
    const auto corner = [&](double u, double v) {
        return Point{middle.x + u * half_side_[0].x + v * half_side_[1].x,
                     middle.y + u * half_side_[0].y + v * half_side_[1].y};
    };
    corners_ = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    shares_.clear();
    const Range rows = cells_of(corners_, &Point::y);
    for (int row = rows.first; row < rows.end; ++row)
        add_row(corners_, row);
    return shares_;
}

void Footprint::add_row(const Polygon& corners, int row) {
    clip_to_cell(corners, &Point::y, row, clipped_, row_);
    if (row_.size() < 3) return;
    const Range columns = cells_of(row_, &Point::x);
    for (int column = columns.first; column < columns.end; ++column) {
        clip_to_cell(row_, &Point::x, column, clipped_, cell_);
        const double share = area_of(cell_) / area_;
        if (share >= kLeastShare) shares_.push_back({column, row, share});
    }
}

}  // namespace pastoso::layers
