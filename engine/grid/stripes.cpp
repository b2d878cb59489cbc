#include "grid/stripes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pastoso::grid {
namespace {

/// Both ends included; none where low > high.
struct Interval {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void include(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
};

/// Where a disc crosses the level y.
void cross_disc(const Point& middle, double radius, double y, Interval& crossed) {
    const double rise = y - middle.y;
    if (std::abs(rise) > radius) return;
    const double half = std::sqrt(radius * radius - rise * rise);
    crossed.include(middle.x - half);
    crossed.include(middle.x + half);
}

/// Where an edge crosses the level y, the same whichever way it runs.
void cross_edge(const Point& a, const Point& b, double y, Interval& crossed) {
    const Point& low = a.y < b.y ? a : b;
    const Point& high = a.y < b.y ? b : a;
    if (y < low.y || y > high.y) return;
    if (low.y == high.y) {
        crossed.include(a.x);
        crossed.include(b.x);
    } else {
        crossed.include(low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x));
    }
}

/// Where the rectangle along a piece of the line crosses the level y.
void cross_piece(const Point& a, const Point& b, double radius, double y, Interval& crossed) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length == 0.0) return;
    const double aside_x = -(b.y - a.y) / length * radius, aside_y = (b.x - a.x) / length * radius;
    const std::array corners{Point{a.x + aside_x, a.y + aside_y}, Point{b.x + aside_x, b.y + aside_y},
                             Point{b.x - aside_x, b.y - aside_y}, Point{a.x - aside_x, a.y - aside_y}};
    for (std::size_t i = 0; i < corners.size(); ++i)
        cross_edge(corners[i], corners[(i + 1) % corners.size()], y, crossed);
}

void choose(const Interval& crossed, std::vector<std::uint8_t>& chosen) {
    const auto count = static_cast<double>(chosen.size());
    const double begin = std::clamp(std::ceil(crossed.low - 0.5), 0.0, count);
    const double end = std::clamp(std::floor(crossed.high - 0.5) + 1.0, 0.0, count);
    if (begin < end)
        std::fill(chosen.begin() + static_cast<std::ptrdiff_t>(begin),
                  chosen.begin() + static_cast<std::ptrdiff_t>(end), kWhole);
}

bool reaches(const Point& a, const Point& b, double radius, double y) {
    return y >= std::min(a.y, b.y) - radius && y <= std::max(a.y, b.y) + radius;
}

}  // namespace

Mask stripe_mask(Shape shape, const std::vector<Point>& line, double radius, StripeEnds ends) {
    const bool round = ends == StripeEnds::Round;
    return mask_by_rows(shape, [&](int row, std::vector<std::uint8_t>& chosen) {
        const double y = row + 0.5;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const Point& a = line[i];
            const Point& b = line[std::min(i + 1, line.size() - 1)];
            if (!reaches(a, b, radius, y)) continue;
            Interval crossed;
            if (round) cross_disc(a, radius, y, crossed);
            if (round) cross_disc(b, radius, y, crossed);
            cross_piece(a, b, radius, y, crossed);
            choose(crossed, chosen);
        }
    });
}

}  // namespace pastoso::grid
