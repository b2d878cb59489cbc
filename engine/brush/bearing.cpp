#include "brush/bearing.hpp"

#include "brush/nearest_cell.hpp"
#include "brush/smooth_noise.hpp"

#include <algorithm>

namespace pastoso::brush {
namespace {

/// What rides as one when an edge is between riding and scraping, narrow stripes within wide ones, and
/// for how long.
constexpr int kNarrow_elements = 3, kWide_elements = 8;
constexpr double kStripe_mm = 9.0;
constexpr std::uint32_t kWideStream = 1 << 16;
/// How far apart stripes are: most either ride or scrape, and leave planes with edges, not tubes.
constexpr float kContrast = 1.8F;

/// Thinner paint carries no hair, which is about as thick itself.
constexpr float kCarrying_mm = 0.05F;

/// The wet surface that the tool found at a place, or the nearest one on the canvas.
float found_surface_mm(const film::FilmState& film, const PassMap& pass, double x_mm, double y_mm) {
    const auto [x, y] = nearest_cell(film, x_mm, y_mm);
    const int tile = film.shape.tile_at(x, y), cell = grid::Shape::cell_in_tile(x, y);
    const std::int32_t thickness = film.thickness.read(tile)[cell];
    return film.support_mm.read(tile)[cell] + film::thickness_mm(pass.found(tile, cell, thickness));
}

float mean_found_surface_mm(const film::FilmState& film, const PassMap& pass,
                            const std::vector<BristlePose>& poses) {
    double sum_mm = 0.0;
    int count = 0;
    for (const BristlePose& pose : poses) {
        if (!pose.down) continue;
        sum_mm += found_surface_mm(film, pass, pose.x_mm, pose.y_mm);
        ++count;
    }
    return count > 0 ? static_cast<float>(sum_mm / count) : 0.0F;
}

/// What carries a hair: the highest of the wet surface below its tuft, as of the dry one.
float carrying_surface_mm(const film::FilmState& film, const PassMap& pass, const BristlePose& pose,
                          double tuft_mm) {
    const auto at = [&](double dx_mm, double dy_mm) {
        return found_surface_mm(film, pass, pose.x_mm + dx_mm, pose.y_mm + dy_mm);
    };
    return std::max(
        {at(0.0, 0.0), at(-tuft_mm, 0.0), at(tuft_mm, 0.0), at(0.0, -tuft_mm), at(0.0, tuft_mm)});
}

/// The ride of an element between those that ride and those that scrape.
float uneven_ride(const Bearing& bearing, int element) {
    const auto noise_of = [&](int elements, std::uint32_t stream) {
        const auto stripe = static_cast<std::uint32_t>(element / elements);
        return smooth_noise(bearing.travel_mm / kStripe_mm, bearing.noise_seed + stream + stripe);
    };
    const double noise =
        0.6 * noise_of(kNarrow_elements, 0) + 0.6 * noise_of(kWide_elements, kWideStream);
    const float spread = kContrast * 2.0F * bearing.ride * (1.0F - bearing.ride);
    return std::clamp(bearing.ride + spread * static_cast<float>(noise), 0.0F, 1.0F);
}

float hair_ride(const Bearing& bearing, float depth_mm) {
    return bearing.ride * std::clamp(depth_mm / kCarrying_mm, 0.0F, 1.0F);
}

float edge_surface_mm(const Bearing& bearing, float found_mm, float mean_mm) {
    return found_mm + bearing.rigidity * (mean_mm - found_mm);
}

}  // namespace

float ride_of(const FlexPreset& flex, const HandPose& hand) {
    return static_cast<float>(std::min(1.0, flex.ride * hand.ride));
}

void bear(const Bearing& bearing, const film::FilmState& film, const PassMap& pass,
          std::vector<BristlePose>& poses) {
    const bool rides = bearing.ride > 0.0F;
    const float mean_mm = rides && bearing.is_edge ? mean_found_surface_mm(film, pass, poses) : 0.0F;
    for (int i = 0; i < static_cast<int>(poses.size()); ++i) {
        BristlePose& pose = poses[static_cast<std::size_t>(i)];
        if (!pose.down) continue;
        const float dry_mm =
            pose.support_mm + bearing.rigidity * (bearing.edge_support_mm - pose.support_mm);
        const float lowest_mm = std::max(dry_mm, pose.bearing_mm - bearing.sinking_mm);
        pose.ride = 0.0F;
        pose.bearing_mm = lowest_mm;
        if (!rides) continue;
        const float wet_mm =
            bearing.is_edge
                ? edge_surface_mm(bearing, found_surface_mm(film, pass, pose.x_mm, pose.y_mm), mean_mm)
                : carrying_surface_mm(film, pass, pose, bearing.tuft_mm);
        pose.ride = bearing.is_edge ? uneven_ride(bearing, i) : hair_ride(bearing, wet_mm - dry_mm);
        pose.bearing_mm = std::max(lowest_mm, dry_mm + pose.ride * (wet_mm - dry_mm));
    }
}

}  // namespace pastoso::brush
