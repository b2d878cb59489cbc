#include "area.hpp"

#include "core/random.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pastoso::examples {
namespace {

struct Seed {
    Point at;
    double turn_deg;
    int paint;
    double longer = 0.0, firmer = 0.0;  ///< than the others, from -1 to 1
};

/// Random numbers of one area.
class Chance {
  public:
    explicit Chance(unsigned seed) : seed_(seed) {}
    double operator()() { return core::uniform_noise(next_++, seed_); }
    double around_zero() { return 2.0 * (*this)() - 1.0; }

  private:
    std::uint32_t seed_, next_ = 0;
};

/// The corners of the canvas are not known here; no example is larger. Strokes may begin beyond its
/// edges.
constexpr double kLargestSide_mm = 220.0;
constexpr double kBeyondEdge_mm = 15.0;

/// From the seed of an area to that of how its strokes differ.
constexpr unsigned kVariation = 5000;

Point turned(Point vector, double angle_deg) {
    const double c = std::cos(core::radians(angle_deg)), s = std::sin(core::radians(angle_deg));
    return {c * vector.x - s * vector.y, s * vector.x + c * vector.y};
}

std::optional<int> paint_for(double tone, const Handling& handling, std::size_t paint_count) {
    if (tone < handling.least_tone || tone > handling.most_tone) return std::nullopt;
    const int last = static_cast<int>(paint_count) - 1;
    return std::clamp(static_cast<int>(std::floor(tone * static_cast<double>(paint_count))), 0, last);
}

/// Draws from numbers of its own: what is not varied stays as it was.
void vary(std::vector<Seed>& seeds, const Handling& handling) {
    Chance chance(handling.seed + kVariation);
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        if (handling.shuffled)
            std::swap(seeds[i], seeds[i + static_cast<std::size_t>(chance() * (seeds.size() - i))]);
        seeds[i].longer = chance.around_zero();
        seeds[i].firmer = chance.around_zero();
    }
}

std::vector<Seed> scatter_seeds(const Area& area, std::size_t paint_count, const Handling& handling) {
    Chance chance(handling.seed);
    std::vector<Seed> seeds;
    const int cells = static_cast<int>((kLargestSide_mm + kBeyondEdge_mm) / handling.spacing_mm);
    for (int row = 0; row < cells; ++row) {
        for (int column = 0; column < cells; ++column) {
            const Point at{
                (column + 0.5 * (row % 2) + 0.5 * chance()) * handling.spacing_mm - kBeyondEdge_mm,
                (row + 0.5 * chance()) * handling.spacing_mm - kBeyondEdge_mm};
            const double turn_deg = handling.scatter_deg * chance.around_zero();
            const double tone_shift = handling.scatter_tone * chance.around_zero();
            const bool wanted = chance() < handling.share_painted;
            const double depth = area.depth_mm(at);
            if (!wanted || depth < handling.inset_mm || depth > handling.most_depth_mm) continue;
            const auto paint = paint_for(area.tone(at) + tone_shift, handling, paint_count);
            if (paint) seeds.push_back({at, turn_deg, *paint});
        }
    }
    vary(seeds, handling);
    return seeds;
}

/// Follows the directions from a point for half a stroke, as long as it stays inside; `sign` says which
/// way.
std::vector<Point> follow(const Area& area, const Seed& seed, double sign, const Handling& handling) {
    constexpr int kSteps = 6;
    const double length_mm = handling.length_mm * (1.0 + handling.scatter_length * seed.longer);
    const double step_mm = 0.5 * length_mm / kSteps;
    std::vector<Point> points;
    Point at = seed.at;
    for (int i = 0; i < kSteps; ++i) {
        const Point along = turned(area.direction(at), seed.turn_deg);
        at = at + sign * step_mm / length(along) * along;
        if (area.depth_mm(at) < handling.inset_mm) break;
        points.push_back(at);
    }
    return points;
}

std::optional<Curve> stroke_through(const Area& area, const Seed& seed, const Handling& handling) {
    std::vector<Point> points = follow(area, seed, -1.0, handling);
    std::reverse(points.begin(), points.end());
    points.push_back(seed.at);
    const std::vector<Point> forward = follow(area, seed, 1.0, handling);
    points.insert(points.end(), forward.begin(), forward.end());
    if (points.size() < 4) return std::nullopt;
    return Curve(
        {points.front(), points[points.size() / 3], points[2 * points.size() / 3], points.back()});
}

}  // namespace

Point along_outline(const std::function<double(Point)>& depth_mm, Point at) {
    constexpr double kDelta_mm = 0.5;
    const double across_x = depth_mm(at + Point{kDelta_mm, 0}) - depth_mm(at - Point{kDelta_mm, 0});
    const double across_y = depth_mm(at + Point{0, kDelta_mm}) - depth_mm(at - Point{0, kDelta_mm});
    if (std::hypot(across_x, across_y) < 1e-9) return {1, 0};
    return {-across_y, across_x};
}

void paint_area(Painter& painter, const Area& area, const std::vector<document::LoadPaint>& paints,
                const Handling& handling) {
    const std::vector<Seed> seeds = scatter_seeds(area, paints.size(), handling);
    painter.take(handling.brush, handling.size_mm);
    for (int paint = 0; paint < static_cast<int>(paints.size()); ++paint) {
        int strokes = 0;
        for (const Seed& seed : seeds) {
            const auto curve = seed.paint == paint ? stroke_through(area, seed, handling) : std::nullopt;
            if (!curve) continue;
            if (strokes++ % handling.strokes_per_dip == 0) {
                painter.wipe();
                document::LoadPaint load = paints[paint];
                load.fill = handling.fill;
                painter.dip(load);
            }
            Press press = handling.press;
            press.level *= 1.0 + handling.scatter_press * seed.firmer;
            paint_along(painter, *curve,
                        handling.speed_mm_s * (1.0 + handling.scatter_length * seed.longer), press);
        }
    }
}

}  // namespace pastoso::examples
