#include "brush/bearing.hpp"

#include "brush/nearest_cell.hpp"
#include "brush/smooth_noise.hpp"

#include <algorithm>

namespace pastoso::brush {
namespace {

/// What rides as one when an edge is between riding and scraping, and for how long.
constexpr int kStripe_elements = 3;
constexpr double kStripe_mm = 9.0;

/// The wet surface that the tool found below an element, or the nearest one on the canvas.
float found_surface_mm(const film::FilmState& film, const PassMap& pass, const BristlePose& pose) {
    const auto [x, y] = nearest_cell(film, pose.x_mm, pose.y_mm);
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
        sum_mm += found_surface_mm(film, pass, pose);
        ++count;
    }
    return count > 0 ? static_cast<float>(sum_mm / count) : 0.0F;
}

/// The ride of an element between those that ride and those that scrape.
float uneven_ride(const Bearing& bearing, int element) {
    const auto stripe = static_cast<std::uint32_t>(element / kStripe_elements);
    const double noise = smooth_noise(bearing.travel_mm / kStripe_mm, bearing.noise_seed + stripe);
    const float spread = 2.0F * bearing.ride * (1.0F - bearing.ride);
    return std::clamp(bearing.ride + spread * static_cast<float>(noise), 0.0F, 1.0F);
}

}  // namespace

float ride_of(const FlexPreset& flex, const HandPose& hand) {
    return static_cast<float>(std::min(1.0, flex.ride * hand.ride));
}

void bear(const Bearing& bearing, const film::FilmState& film, const PassMap& pass,
          std::vector<BristlePose>& poses) {
    const bool rides = bearing.ride > 0.0F;
    const float mean_mm = rides ? mean_found_surface_mm(film, pass, poses) : 0.0F;
    for (int i = 0; i < static_cast<int>(poses.size()); ++i) {
        BristlePose& pose = poses[static_cast<std::size_t>(i)];
        if (!pose.down) continue;
        const float dry_mm =
            pose.support_mm + bearing.rigidity * (bearing.edge_support_mm - pose.support_mm);
        const float lowest_mm = std::max(dry_mm, pose.bearing_mm - bearing.sinking_mm);
        pose.ride = rides ? uneven_ride(bearing, i) : 0.0F;
        pose.bearing_mm = lowest_mm;
        if (pose.ride <= 0.0F) continue;
        const float found_mm = found_surface_mm(film, pass, pose);
        const float wet_mm = found_mm + bearing.rigidity * (mean_mm - found_mm);
        pose.bearing_mm = std::max(lowest_mm, dry_mm + pose.ride * (wet_mm - dry_mm));
    }
}

}  // namespace pastoso::brush
