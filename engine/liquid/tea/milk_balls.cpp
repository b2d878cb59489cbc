#include "liquid/tea/milk_balls.hpp"

#include "core/elementary.hpp"
#include "core/random.hpp"

#include <algorithm>

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

}  // namespace pastoso::liquid
