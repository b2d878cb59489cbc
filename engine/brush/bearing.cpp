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

/// The wet surface that the tool found. The tile that was looked into last is kept open: places that are
/// asked for one after the other are mostly of one.
class FoundSurface {
  public:
    FoundSurface(const film::FilmState& film, const PassMap& pass) : film_(film), pass_(pass) {}

    float at_mm(Cell cell) {
        const int tile = film_.shape.tile_at(cell.x, cell.y);
        if (tile != tile_) open(tile);
        const int i = grid::Shape::cell_in_tile(cell.x, cell.y);
        return support_mm_[i] + film::thickness_mm(found_.at(i, thickness_[i]));
    }
    /// At a place, or the nearest one on the canvas.
    float at_mm(double x_mm, double y_mm) { return at_mm(nearest_cell(film_, x_mm, y_mm)); }

    /// What carries a hair: the highest below its tuft, as of the dry surface.
    float below_tuft_mm(double x_mm, double y_mm, double tuft_mm) {
        const Cell middle = nearest_cell(film_, x_mm, y_mm);
        const Cell low = nearest_cell(film_, x_mm - tuft_mm, y_mm - tuft_mm);
        const Cell high = nearest_cell(film_, x_mm + tuft_mm, y_mm + tuft_mm);
        return std::max({at_mm(middle), at_mm({low.x, middle.y}), at_mm({high.x, middle.y}),
                         at_mm({middle.x, low.y}), at_mm({middle.x, high.y})});
    }

  private:
    void open(int tile) {
        tile_ = tile;
        thickness_ = film_.thickness.read(tile);
        support_mm_ = film_.support_mm.read(tile);
        found_ = pass_.read(tile);
    }

    const film::FilmState& film_;
    const PassMap& pass_;
    int tile_ = -1;
    const std::int32_t* thickness_ = nullptr;
    film::TileHeights support_mm_;
    FoundTile found_;
};

float mean_found_surface_mm(FoundSurface& surface, const std::vector<BristlePose>& poses) {
    double sum_mm = 0.0;
    int count = 0;
    for (const BristlePose& pose : poses) {
        if (!pose.down) continue;
        sum_mm += surface.at_mm(pose.x_mm, pose.y_mm);
        ++count;
    }
    return count > 0 ? static_cast<float>(sum_mm / count) : 0.0F;
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
    FoundSurface surface(film, pass);
    const float mean_mm = rides && bearing.is_edge ? mean_found_surface_mm(surface, poses) : 0.0F;
    for (int i = 0; i < static_cast<int>(poses.size()); ++i) {
        BristlePose& pose = poses[static_cast<std::size_t>(i)];
        if (!pose.down) continue;
        const float dry_mm =
            pose.support_mm + bearing.rigidity * (bearing.edge_support_mm - pose.support_mm);
        const float lowest_mm = std::max(dry_mm, pose.bearing_mm - bearing.sinking_mm);
        pose.ride = 0.0F;
        pose.bearing_mm = lowest_mm;
        if (!rides) continue;
        const float wet_mm = bearing.is_edge
                                 ? edge_surface_mm(bearing, surface.at_mm(pose.x_mm, pose.y_mm), mean_mm)
                                 : surface.below_tuft_mm(pose.x_mm, pose.y_mm, bearing.tuft_mm);
        pose.ride = bearing.is_edge ? uneven_ride(bearing, i) : hair_ride(bearing, wet_mm - dry_mm);
        pose.bearing_mm = std::max(lowest_mm, dry_mm + pose.ride * (wet_mm - dry_mm));
    }
}

}  // namespace pastoso::brush
