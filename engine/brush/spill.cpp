#include "brush/spill.hpp"

#include "brush/cell_mean.hpp"
#include "brush/nearest_cell.hpp"
#include "brush/transfer.hpp"
#include "core/random.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace pastoso::brush {
namespace {

/// Most of what is held that one call puts down.
constexpr double kLargestShare = 0.95;
/// Least width of a heap, in heights of the paint that lies there.
constexpr double kSpread_heights = 0.9;
/// Mean square radius of a heap, in its radii.
constexpr double kHeapMeanSquare = 1.0 / 3.0;
/// How far beyond its near side the middle of a heap lies, in its widths.
constexpr double kOverhang = 0.75;
/// Bristles this close to the edge of the stroke spill inwards.
constexpr double kEdge_radii = 5.0;

/// The heap 1 - (d / spread)^2 at the batch's cells.
std::vector<double> heap_heights(double spread_mm, const CellBatch& batch) {
    std::vector<double> heights(static_cast<std::size_t>(batch.count()));
    for (int i = 0; i < batch.count(); ++i) {
        const double distance2 = batch.dx_mm[i] * batch.dx_mm[i] + batch.dy_mm[i] * batch.dy_mm[i];
        heights[i] = std::max(0.0, 1.0 - distance2 / (spread_mm * spread_mm));
    }
    return heights;
}

/// Fills the batch's changes with a heap of `quanta` in all. Returns what it wants.
WantedSums plan_heap(double quanta, double spread_mm, CellBatch& batch) {
    const std::vector<double> heights = heap_heights(spread_mm, batch);
    const double heap = std::accumulate(heights.begin(), heights.end(), 0.0);
    WantedSums wanted;
    for (int i = 0; i < batch.count(); ++i) {
        const double capacity_left = film::capacity_left_quanta(batch.thickness[i]);
        const double gain = heap > 0.0 ? quanta * heights[i] / heap : 0.0;
        batch.change[i] = static_cast<std::int32_t>(std::min(gain, capacity_left));
        batch.swap[i] = 0;
        batch.touched[i] = 1.0F;  // over two strata, what does not hide them joins the upper one
        wanted.deposit += batch.change[i];
    }
    return wanted;
}

/// +1 or -1: the side of the travel that a knife's element spills to.
double knife_side(double side_mm, const HandPose& hand, const Swath& swath) {
    const double half_mm = 0.5 * (swath.high_mm - swath.low_mm);
    const double middle_mm = 0.5 * (swath.high_mm + swath.low_mm);
    const double edge_along = hand.cos_rotation * hand.travel_x + hand.sin_rotation * hand.travel_y;
    const double edge_across = hand.sin_rotation * hand.travel_x - hand.cos_rotation * hand.travel_y;
    const double trailing = edge_across > 0.0 ? -edge_along : edge_along;
    return side_mm > middle_mm - half_mm * trailing ? 1.0 : -1.0;
}

double bristle_side(double side_mm, const Swath& swath, double edge_mm, float noise) {
    const double to_middle_mm = 0.5 * (swath.high_mm + swath.low_mm) - side_mm;
    const double half_mm = 0.5 * (swath.high_mm - swath.low_mm);
    const bool at_edge = half_mm - std::abs(to_middle_mm) < edge_mm;
    if (at_edge) return to_middle_mm > 0.0 ? 1.0 : -1.0;
    return noise < 0.5F ? -1.0 : 1.0;
}

}  // namespace

double thickness_at(const film::FilmState& film, double x_mm, double y_mm) {
    const auto [x, y] = nearest_cell(film, x_mm, y_mm);
    return film::thickness_mm(film.thickness.at(x, y));
}

grid::Rect put_down(Contents& held, double volume_mm3, double x_mm, double y_mm, double spread_mm,
                    std::uint32_t dither_seed, film::FilmState& film, CellBatch& scratch,
                    MediaExchange* media) {
    const double radius_mm =
        resolved_radius_mm({kHeapMeanSquare, kHeapMeanSquare, kSoftCellSquare}, spread_mm, film.cell_mm);
    scratch.gather(film, x_mm, y_mm, radius_mm);
    const double quanta = volume_mm3 / (film.cell_mm * film.cell_mm * film::kThicknessQuantum_mm);
    const WantedSums wanted = plan_heap(quanta, radius_mm, scratch);
    if (wanted.deposit == 0) return {};
    return apply_batch(scratch, wanted, {.deposit_share = kLargestShare}, dither_seed, film, held,
                       media);
}

HeapPlace place_beside(const film::FilmState& film, double x_mm, double y_mm, double away_x,
                       double away_y, double beside_mm, double least_mm) {
    const double heaped_mm = thickness_at(film, x_mm + away_x * (beside_mm + least_mm),
                                          y_mm + away_y * (beside_mm + least_mm));
    const double spread_mm = std::max(least_mm, kSpread_heights * heaped_mm);
    const double away_mm = beside_mm + kOverhang * spread_mm;
    return {x_mm + away_x * away_mm, y_mm + away_y * away_mm, spread_mm};
}

grid::Rect spill_overflow(Brush& brush, int bristle, const BristlePose& pose, const HandPose& hand,
                          const Swath& swath, const SpillRates& rates, std::uint32_t dither_seed,
                          film::FilmState& film, CellBatch& scratch, MediaExchange* media) {
    Contents& held = brush.held[bristle];
    const double surplus_mm3 = held.volume_mm3 - brush.preset.exchange.overflow * brush.tip.capacity_mm3;
    if (surplus_mm3 <= 0.0) return {};
    const bool knife = brush.preset.tip.shape == TipShape::Knife;
    const double side = side_mm(pose, hand);
    const float own = core::uniform_noise(static_cast<std::uint32_t>(bristle), rates.jitter_seed);
    const float noise = brush.tip.mirrored ? 1.0F - own : own;
    const double sign = knife ? knife_side(side, hand, swath)
                              : bristle_side(side, swath, kEdge_radii * rates.radius_mm, noise);
    const double to_end_mm = !knife ? 0.0 : sign > 0.0 ? swath.high_mm - side : side - swath.low_mm;
    const double away_x = -hand.travel_y * sign, away_y = hand.travel_x * sign;
    const HeapPlace heap = place_beside(film, pose.x_mm, pose.y_mm, away_x, away_y,
                                        to_end_mm + rates.radius_mm, 0.5 * rates.radius_mm);
    const double part = 1.0 - std::exp(-rates.step_mm / (0.5 * rates.radius_mm));
    return put_down(held, part * surplus_mm3, heap.x_mm, heap.y_mm, heap.spread_mm, dither_seed, film,
                    scratch, media);
}

}  // namespace pastoso::brush
