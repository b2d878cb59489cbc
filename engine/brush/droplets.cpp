#include "brush/droplets.hpp"

#include "brush/spill.hpp"
#include "core/elementary.hpp"
#include "core/random.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::brush {
namespace {

/// Volumes of drops spread over this many powers of e to each side of the mean.
constexpr double kVolumeSpread = 2.3;
/// Drops that fly on are drawn out: the share of the flight that their mark is long.
constexpr double kStreakShare = 0.08;
/// A drawn-out mark is made of this many caps, each smaller than the one before.
constexpr int kStreakCaps = 4;

}  // namespace

double cap_radius_mm(double volume_mm3, double steepness) {
    return std::cbrt(2.0 * volume_mm3 / (core::kPi * steepness));
}

void Droplets::begin(const HandPose& hand, std::uint32_t seed, MediaExchange* media) {
    media_ = media;
    seed_ = seed;
    drawn_ = 0;
    owed_mm3_ = 0.0;
    way_.assign(1, {hand, 0.0});
    const DropletPreset& preset = brush_.preset.droplets;
    next_mm3_ = preset.touch_mm3 * next_volume_mm3() / preset.drop_mm3;
    if (next_mm3_ > 0.0) let_fall(way_.back());
    next_mm3_ = next_volume_mm3();
}

void Droplets::follow(const HandPose& hand, double speed_mm_s) {
    way_.push_back({hand, speed_mm_s});
}

void Droplets::pass_time(double seconds) {
    const double flow = way_.back().hand.flow * way_.back().hand.press;
    owed_mm3_ += brush_.preset.droplets.rate_mm3_s * flow * seconds;
    if (brush_.held.front().volume_mm3 <= 0.0) owed_mm3_ = 0.0;
    while (owed_mm3_ >= next_mm3_) {
        owed_mm3_ -= next_mm3_;
        const auto index = static_cast<std::size_t>(random() * static_cast<float>(way_.size()));
        let_fall(way_[std::min(index, way_.size() - 1)]);
        next_mm3_ = next_volume_mm3();
    }
    way_.erase(way_.begin(), way_.end() - 1);
}

void Droplets::let_fall(const Place& place) {
    const DropletPreset& preset = brush_.preset.droplets;
    const HandPose& hand = place.hand;
    const double angle = 2.0 * core::kPi * random();
    const double evenly = std::sqrt(random());
    const double centred = random() * evenly;
    const double distance_mm =
        brush_.tip.half_width_mm * hand.spread * (evenly + preset.centring * (centred - evenly));
    const double flight_mm = preset.throw_s * place.speed_mm_s * (0.5 + random());
    const double u = distance_mm * std::cos(angle) * (brush_.tip.mirrored ? -1.0 : 1.0);
    const double v = distance_mm * std::sin(angle);
    land(hand.x_mm + u * hand.cos_rotation - v * hand.sin_rotation + flight_mm * hand.travel_x,
         hand.y_mm + u * hand.sin_rotation + v * hand.cos_rotation + flight_mm * hand.travel_y,
         kStreakShare * flight_mm, hand);
}

void Droplets::land(double x_mm, double y_mm, double streak_mm, const HandPose& hand) {
    const double radius_mm = cap_radius_mm(next_mm3_, brush_.preset.droplets.steepness);
    Contents& bottle = brush_.held.front();
    const int caps = streak_mm > radius_mm ? kStreakCaps : 1;
    double left_mm3 = std::min(next_mm3_, bottle.volume_mm3);
    for (int cap = 0; cap < caps; ++cap) {
        const double volume_mm3 = cap + 1 < caps ? 0.5 * left_mm3 : left_mm3;
        const double along_mm = caps > 1 ? streak_mm * cap / (caps - 1) : 0.0;
        const double cap_mm = radius_mm * std::cbrt(volume_mm3 / next_mm3_);
        const grid::Rect cells = put_down(bottle, volume_mm3, x_mm + along_mm * hand.travel_x,
                                          y_mm + along_mm * hand.travel_y, cap_mm,
                                          core::scramble(seed_ + drawn_), film_, cells_, media_);
        changed_ = grid::bounding_box(changed_, cells);
        left_mm3 -= volume_mm3;
    }
    if (media_ != nullptr) settle_exchange(*media_, film_, brush_);
}

double Droplets::next_volume_mm3() {
    const DropletPreset& preset = brush_.preset.droplets;
    const double spread = preset.variation * kVolumeSpread;
    const double power = spread * (2.0 * random() - 1.0);
    // The mean of e^power over the spread is sinh(spread) / spread.
    const double up = core::exponential(spread);
    const double mean = spread > 1e-6 ? 0.5 * (up - 1.0 / up) / spread : 1.0;
    return preset.drop_mm3 * core::exponential(power) / mean;
}

float Droplets::random() {
    return core::uniform_noise(drawn_++, seed_);
}

grid::Rect Droplets::take_changed_cells() {
    return std::exchange(changed_, {});
}

}  // namespace pastoso::brush
