#include "film/laboratory/front.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pastoso::film {
namespace {

constexpr double kEdgeShare = 0.1;
constexpr double kSmallestWidth_cells = 8.0;

/// Wet width and largest thickness in strips one cell wide across the force; lengths in cells.
struct Strips {
    double first = 0.0;  ///< position along the force where strip 0 begins
    std::vector<double> width, thickness_mm;

    double centre(std::size_t strip) const { return first + static_cast<double>(strip) + 0.5; }
};

template <class Visit>
void for_each_wet_cell(const FilmState& film, const Visit& visit) {
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x)
            if (const double h = thickness_mm(film.thickness.at(x, y)); h > 0.0) visit(x, y, h);
}

/// Each cell is shared between the two strips whose centres enclose its own.
Strips cut_into_strips(const FilmState& film, double direction_x, double direction_y, double edge_mm) {
    const double reach_x = direction_x * film.shape.width, reach_y = direction_y * film.shape.height;
    Strips strips;
    strips.first = std::floor(std::min(0.0, reach_x) + std::min(0.0, reach_y)) - 1.0;
    const double last = std::max(0.0, reach_x) + std::max(0.0, reach_y) + 2.0;
    strips.width.resize(static_cast<std::size_t>(last - strips.first) + 1);
    strips.thickness_mm.resize(strips.width.size());
    for_each_wet_cell(film, [&](int x, int y, double h) {
        const double along = direction_x * (x + 0.5) + direction_y * (y + 0.5) - strips.first - 0.5;
        const auto strip = static_cast<std::size_t>(along);
        const double behind = along - static_cast<double>(strip);
        const double wet = std::min(1.0, h / edge_mm);
        strips.width[strip] += (1.0 - behind) * wet;
        strips.width[strip + 1] += behind * wet;
        double& thickest = strips.thickness_mm[behind < 0.5 ? strip : strip + 1];
        thickest = std::max(thickest, h);
    });
    return strips;
}

/// The foremost strip that is at least half a cell wide.
std::size_t foremost(const Strips& strips) {
    std::size_t strip = strips.width.size() - 1;
    while (strip > 0 && strips.width[strip] < 0.5)
        --strip;
    return strip;
}

/// Where w^2, which is linear near a round tip, would vanish, continued from the two strips behind the
/// foremost one (itself partly dry); not beyond the foremost.
double tip_of(const Strips& strips, std::size_t end) {
    const double width2 = strips.width[end - 1] * strips.width[end - 1];
    const double rise = strips.width[end - 2] * strips.width[end - 2] - width2;
    const double limit = strips.centre(end) + 0.5;
    return rise > 0.0 ? std::min(limit, strips.centre(end - 1) + width2 / rise) : limit;
}

/// Least squares of (w/2)^2 + d^2 = 2 R d over the strips [begin, end), d being the distance to the tip.
double radius_of(const Strips& strips, std::size_t begin, std::size_t end, double tip) {
    double sum_dd = 0.0, sum_dy = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
        const double d = tip - strips.centre(i);
        sum_dd += d * d;
        sum_dy += d * (0.25 * strips.width[i] * strips.width[i] + d * d);
    }
    return 0.5 * sum_dy / sum_dd;
}

}  // namespace

std::optional<Front> front_of(const FilmState& film, const Gravity& gravity) {
    const double force = std::hypot(gravity.x_mm_s2, gravity.y_mm_s2);
    double thickest_mm = 0.0;
    for_each_wet_cell(film, [&](int, int, double h) { thickest_mm = std::max(thickest_mm, h); });
    if (force == 0.0 || thickest_mm == 0.0) return std::nullopt;

    const Strips strips = cut_into_strips(film, gravity.x_mm_s2 / force, gravity.y_mm_s2 / force,
                                          kEdgeShare * thickest_mm);
    const double width = *std::max_element(strips.width.begin(), strips.width.end());
    if (width < kSmallestWidth_cells) return std::nullopt;

    const std::size_t end = foremost(strips);
    const auto depth = static_cast<std::size_t>(std::max(3.0, std::round(0.25 * width)));
    if (end < depth + 1) return std::nullopt;
    const double tip = tip_of(strips, end);
    const double radius = radius_of(strips, end - depth, end, tip);

    double area = 0.0, thickness = 0.0;
    for (std::size_t i = 0; i < strips.width.size(); ++i) {
        const double inside = std::clamp(strips.centre(i) + 0.5 - (tip - 0.5 * width), 0.0, 1.0);
        area += inside * strips.width[i];
        if (inside > 0.0) thickness = std::max(thickness, strips.thickness_mm[i]);
    }
    Front front;
    front.tip_mm = tip * film.cell_mm;
    front.width_mm = width * film.cell_mm;
    front.radius_mm = radius * film.cell_mm;
    front.roundness = 2.0 * radius / width;
    front.fullness = area / (core::kPi * width * width / 8.0);
    front.thickness_mm = thickness;
    return front;
}

}  // namespace pastoso::film
