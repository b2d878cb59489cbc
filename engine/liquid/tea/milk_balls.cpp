#include "liquid/tea/milk_balls.hpp"

#include "core/elementary.hpp"
#include "core/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace pastoso::liquid {
namespace {

constexpr std::uint32_t kBallStream = 0xBA11U;

/// Of intervals between balls: this much of the mean always passes, the rest is drawn by lot.
constexpr double kLeastInterval = 0.4;

}  // namespace

/// The usual seed's stream is kBallStream.
float MilkBalls::drawn(const TeaSettings& settings) {
    const std::uint32_t seed = core::scramble(settings.seed) ^ core::scramble(TeaSettings{}.seed);
    return core::uniform_noise(state_.draws++, kBallStream ^ seed);
}

void MilkBalls::nucleate(double time_s, const TeaSettings& settings, std::span<Parcel> parcels) {
    if (time_s <= state_.next_s || parcels.empty()) return;
    const double wait = -core::natural_log(static_cast<double>(drawn(settings)) + 1e-6);
    state_.next_s += settings.ball_interval_s * (kLeastInterval + (1.0 - kLeastInterval) * wait);

    const Parcel* highest = nullptr;
    for (int i = 0; i < settings.ball_candidates; ++i) {
        const auto lot = static_cast<std::size_t>(static_cast<double>(drawn(settings)) *
                                                  static_cast<double>(parcels.size()));
        const Parcel& parcel = parcels[std::min(lot, parcels.size() - 1)];
        if (parcel.ball < 0 && (highest == nullptr || parcel.position_m.z > highest->position_m.z))
            highest = &parcel;
    }
    if (highest == nullptr) return;
    const double spread =
        settings.ball_radius_spread * (2.0 * static_cast<double>(drawn(settings)) - 1.0);
    const auto radius_m = static_cast<float>(settings.ball_radius_m * (1.0 + spread));
    const glm::vec3 middle_m = highest->position_m;
    for (Parcel& parcel : parcels) {
        const glm::vec3 from_middle = parcel.position_m - middle_m;
        if (parcel.ball < 0 && glm::dot(from_middle, from_middle) < radius_m * radius_m)
            parcel.ball = state_.count;
    }
    ++state_.count;
}

std::vector<BallMass> MilkBalls::masses(std::span<const Parcel> parcels) const {
    std::vector<BallMass> masses(static_cast<std::size_t>(state_.count));
    for (const Parcel& parcel : parcels) {
        if (parcel.ball < 0) continue;
        BallMass& ball = masses[static_cast<std::size_t>(parcel.ball)];
        const auto volume_m3 = static_cast<double>(parcel.volume_m3);
        ball.middle_m += volume_m3 * glm::dvec3(parcel.position_m);
        ball.volume_m3 += volume_m3;
    }
    for (BallMass& ball : masses)
        if (ball.volume_m3 > 0.0) ball.middle_m /= ball.volume_m3;
    return masses;
}

glm::vec3 drawn_back(const glm::vec3& position_m, const BallMass& ball, const TeaSettings& settings,
                     double dt_s) {
    const double burst_m = static_cast<double>(settings.cup.level_m) - settings.burst_depth_m;
    if (ball.middle_m.z > burst_m) return position_m;
    const glm::dvec3 from_middle = glm::dvec3(position_m) - ball.middle_m;
    const double distance_m = glm::length(from_middle);
    const double radius_m = std::cbrt(0.75 / std::numbers::pi * ball.volume_m3);
    const double reach_m = settings.cohesion_reach * radius_m;
    if (distance_m <= reach_m || distance_m >= settings.cohesion_limit_m) return position_m;
    const double share = 1.0 - core::exponential(-dt_s / settings.cohesion_s);
    return position_m - glm::vec3(from_middle * (share * (distance_m - reach_m) / distance_m));
}

}  // namespace pastoso::liquid
