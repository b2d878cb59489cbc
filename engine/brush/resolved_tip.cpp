#include "brush/resolved_tip.hpp"

#include "brush/cell_mean.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pastoso::brush {
namespace {

/// Half width of the mean over a groove, in cells: of a flat one, and what a slope of 1 at its sides
/// adds. Steep ones leave dots unless the mean is wide; flat ones would be lost in it.
constexpr double kFlatGrooveMean_cells = 0.97, kSteepness_cells = 0.72;
/// Of the means over hairs and over a knife's scratches.
constexpr double kHairMean_cells = 2.5, kScratchMean_cells = 3.2;
/// Of a cell in whose middle a footprint ends: half of it, and as much more as keeps the volume of
/// strokes where a soft footprint hardly closes the gap at its rim.
constexpr double kRimCover = 0.64;
/// A table of sixteen segments is looked up within registers.
constexpr int kLeastSegments = 16;
/// Scratches of a knife's edge against the hairs of a brush.
constexpr double kKnifeHairs = 0.6;
/// Height of a groove's bottom above tau, in depths of the groove.
constexpr double kGrooveRise = 0.25;
/// What weighs less is not touched: soft footprints have a wide rim of next to nothing.
constexpr double kLeastTouch = 0.04;
/// Keeps means finite at the ends of a footprint.
constexpr double kLeastWeight = 1e-6;

using Heights = std::vector<double>;

/// The crown whose footprint has the flatness, mean fourth power of the radius over the square of its
/// mean square, of 1 - rho^4 and a cell together. The softest has 1.6, the tip's own 64/45.
double crown_of(double radius_cells) {
    const double tip2 = radius_cells * radius_cells, cell2 = kFirmCellSquare;
    const double square = 0.375 * tip2 + cell2;
    const double fourth = 0.2 * tip2 * tip2 + 1.5 * tip2 * cell2 + 1.7 * cell2 * cell2;
    const double flatness = fourth / (square * square);
    return 1.0 / (1.0 - std::sqrt(std::max(0.0, 4.0 - 2.5 * flatness))) - 2.0;
}

double weight(double rho, double crown) {
    return (1.0 - rho * rho) * (1.0 + crown * rho * rho);
}

/// Sum of (1 - rho^2) (1 + crown rho^2) over its disc, in areas of the disc.
double mean_weight(double crown) {
    return (3.0 + crown) / 6.0;
}

/// Mean square of rho under that weight.
double mean_square(double crown) {
    return (2.0 + crown) / (6.0 + 2.0 * crown);
}

/// Radius, of 1, beyond which the weight is below kLeastTouch.
double reach_of(double crown) {
    // With x = rho^2: crown x^2 + (1 - crown) x = 1 - kLeastTouch, the root written for crown = 0 too.
    const double b = 1.0 - crown, rest = 1.0 - kLeastTouch;
    return std::sqrt(2.0 * rest / (b + std::sqrt(b * b + 4.0 * crown * rest)));
}

/// What a cell adds to the mean square radius.
double cell_square(double crown) {
    return kSoftCellSquare + 0.5 * (1.0 + crown) * (kFirmCellSquare - kSoftCellSquare);
}

/// Half width of the mean over a groove that is `groove` of the film deep.
double groove_mean_cells(const Tip& tip, const PaintPreset& paint) {
    const double steepness = 2.0 * paint.groove * paint.film_mm / tip.radius_mm;
    return kFlatGrooveMean_cells + kSteepness_cells * steepness;
}

/// Heights of the hairs between their tips, s from -1 to 1.
double hair_at(const Tip& tip, int bristle, double s) {
    const double place = 0.5 * (s + 1.0) * tip.hairs_per_bristle;
    const int left = std::min(static_cast<int>(place), tip.hairs_per_bristle - 1);
    const float* hairs = tip.hairs_of(bristle) + left;
    return hairs[0] + (place - left) * (hairs[1] - hairs[0]);
}

/// Weight of the tip's own footprint at s across it.
double own_weight(const Tip& tip, double s) {
    return tip.rigid ? 1.0 - std::abs(s) : weight(s, 1.0);
}

/// What profiles are means of: places across a footprint, and the weights they have for each place of
/// the resolved one.
class Means {
  public:
    /// Means over triangles of half width `mean_mm`.
    Means(const Tip& tip, const ResolvedTip& resolved, double mean_mm) : count_(resolved.segments + 1) {
        const double own_mm = tip.rigid ? tip.lane_mm : tip.radius_mm;
        const double resolved_mm = tip.rigid ? resolved.lane_mm : resolved.radius_mm;
        // A little more than one spacing: no place is alone in its mean.
        const double reach = std::max(mean_mm / own_mm, 2.002 / resolved.segments);
        for (int k = 0; k < count_; ++k) {
            const double middle = std::clamp(place(k) * resolved_mm / own_mm, -1.0, 1.0);
            const auto row = static_cast<std::ptrdiff_t>(shares_.size());
            for (int j = 0; j < count_; ++j) {
                const double near = std::max(0.0, 1.0 - std::abs(place(j) - middle) / reach);
                shares_.push_back(near * (kLeastWeight + own_weight(tip, place(j))));
            }
            const double sum = std::accumulate(shares_.begin() + row, shares_.end(), 0.0);
            std::for_each(shares_.begin() + row, shares_.end(), [sum](double& share) { share /= sum; });
        }
    }

    /// From -1 to 1, both ends included.
    double place(int i) const { return 2.0 * i / (count_ - 1) - 1.0; }

    double of(const Heights& heights, int k) const {
        const auto row = shares_.begin() + static_cast<std::ptrdiff_t>(k) * count_;
        return std::inner_product(heights.begin(), heights.end(), row, 0.0);
    }

  private:
    int count_;
    std::vector<double> shares_;
};

std::vector<float> profiles_of(const Tip& tip, const ResolvedTip& resolved, const PaintPreset& paint,
                               double cell_mm) {
    const double hair_mean_cells = tip.rigid ? kScratchMean_cells : kHairMean_cells;
    const Means groove_means(tip, resolved, groove_mean_cells(tip, paint) * cell_mm);
    const Means hair_means(tip, resolved, hair_mean_cells * cell_mm);
    const int count = resolved.segments + 1;
    const double groove = tip.rigid ? 0.0 : paint.groove;
    const double hair = tip.rigid ? kKnifeHairs * paint.hair : paint.hair;
    Heights grooves, hairs(static_cast<std::size_t>(count));
    for (int j = 0; j < count; ++j)
        grooves.push_back(groove * (groove_means.place(j) * groove_means.place(j) + kGrooveRise));
    std::vector<float> profiles;
    profiles.reserve(tip.bristles.size() * hairs.size());
    for (int bristle = 0; bristle < static_cast<int>(tip.bristles.size()); ++bristle) {
        for (int j = 0; j < count; ++j)
            hairs[j] = hair * hair_at(tip, bristle, hair_means.place(j));
        for (int k = 0; k < count; ++k)
            profiles.push_back(
                static_cast<float>(groove_means.of(grooves, k) + hair_means.of(hairs, k)));
    }
    return profiles;
}

}  // namespace

ResolvedTip resolve(const Tip& tip, const PaintPreset& paint, double cell_mm) {
    const double crown = tip.rigid ? 1.0 : crown_of(tip.radius_mm / cell_mm);
    ResolvedTip resolved;
    resolved.crown = static_cast<float>(crown);
    resolved.radius_mm = resolved_radius_mm({mean_square(1.0), mean_square(crown), cell_square(crown)},
                                            tip.radius_mm, cell_mm);
    if (tip.rigid) {
        const LaneOnCells lane = lane_on_cells(tip.lane_mm, cell_mm);
        resolved.lane_core = lane.core;
        resolved.lane_mm = lane.reach_mm;
    }
    resolved.reach_mm = tip.rigid ? std::hypot(resolved.radius_mm, resolved.lane_mm)
                                  : reach_of(crown) * resolved.radius_mm;
    const double along = tip.radius_mm / resolved.radius_mm;
    const double across = tip.rigid ? 1.0 : along;
    resolved.share = static_cast<float>(along * across * mean_weight(1.0) / mean_weight(crown));
    if (!tip.rigid) resolved.cover = static_cast<float>(kRimCover / weight(along, crown));
    resolved.segments = std::max(kLeastSegments, tip.hairs_per_bristle);
    resolved.profiles = profiles_of(tip, resolved, paint, cell_mm);
    return resolved;
}

}  // namespace pastoso::brush
