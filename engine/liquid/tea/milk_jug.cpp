#include "liquid/tea/milk_jug.hpp"

#include "core/elementary.hpp"
#include "core/r2_sequence.hpp"
#include "core/random.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace pastoso::liquid {
namespace {

/// A glass takes so much milk by hand.
constexpr double kMostMilkInCup = 0.5;
/// The stream's speed is given on faces less deep than this; parcels begin a little under the level.
constexpr float kStreamDepth_m = 0.008F, kStreamStart_m = 0.0015F;
constexpr double kStreamRise_per_s = 8.0;
constexpr std::uint32_t kPourStream = 0x3071U;

void push_stream(const glm::vec2& at_m, float speed_m_s, const TeaSettings& settings,
                 VelocityField& velocity) {
    const grid::BoxShape& shape = velocity.shape();
    const float radius_m = static_cast<float>(settings.pour_radius_m), cell_m = shape.cell_m;
    for (int k = 1; k < shape.nz; ++k) {
        if (static_cast<float>(k) * cell_m <= settings.cup.level_m - kStreamDepth_m) continue;
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                const glm::vec2 middle_m =
                    cell_m * glm::vec2(static_cast<float>(i) + 0.5F, static_cast<float>(j) + 0.5F);
                if (glm::distance(middle_m, at_m) < radius_m) velocity.z.at(i, j, k) = -speed_m_s;
            }
    }
}

}  // namespace

void MilkJug::pour(const TeaSettings& settings, std::vector<Parcel>& parcels, VelocityField& velocity) {
    if (settings.milk_m3 <= 0.0) return;
    const Pouring into{settings, parcels, velocity};
    if (recipe_flows(settings)) pour_from(state_.recipe, settings.cup.axis_m, settings.parcels, into);
    if (state_.hand_m)
        pour_from(state_.hand, *state_.hand_m, kMaxParcels, into);
    else
        state_.hand = {};
}

/// The stream gains speed; at most so many parcels come of it.
void MilkJug::pour_from(Stream& stream, const glm::vec2& at_m, int most, const Pouring& into) {
    const TeaSettings& settings = into.settings;
    stream.seconds += settings.step_s;
    const double speed_m_s =
        settings.pour_speed_m_s * (1.0 - core::exponential(-kStreamRise_per_s * stream.seconds));
    const double parcel_s = settings.pour_s / settings.parcels;
    const int due = std::min(most, static_cast<int>(stream.seconds / parcel_s));
    for (; stream.parcels < due; ++stream.parcels) {
        const double since_s = stream.seconds - parcel_s * (stream.parcels + 1);
        pour_parcel(at_m, static_cast<float>(speed_m_s * since_s), into);
    }
    push_stream(at_m, static_cast<float>(speed_m_s), settings, into.velocity);
}

void MilkJug::pour_parcel(const glm::vec2& at_m, float way_m, const Pouring& into) {
    const TeaSettings& settings = into.settings;
    const float volume_m3 = milk_per_parcel_m3(settings);
    const double most_m3 = kMostMilkInCup * tea_volume_m3(settings.cup);
    const bool fits = state_.poured_m3 + static_cast<double>(volume_m3) <= most_m3 &&
                      static_cast<int>(into.parcels.size()) < kMaxParcels;
    if (!fits) return;
    const glm::vec2 across_m = at_m + static_cast<float>(settings.pour_radius_m) * next_place(settings);
    const glm::vec3 place_m(across_m, settings.cup.level_m - kStreamStart_m - way_m);
    const float margin_m = kWallMargin_cells * into.velocity.shape().cell_m;
    into.parcels.push_back({brought_within(settings.cup, place_m, margin_m), volume_m3, 1.0F, -1});
    state_.poured_m3 += static_cast<double>(volume_m3);
}

/// On a disc of radius 1.
glm::vec2 MilkJug::next_place(const TeaSettings& settings) {
    const auto coordinate = [&](double step, std::uint32_t stream) {
        const double begin = core::uniform_noise(stream, kPourStream ^ core::scramble(settings.seed));
        return static_cast<float>(2.0 * core::fraction(begin + step * state_.places) - 1.0);
    };
    for (;;) {
        const glm::vec2 place(coordinate(core::kR2StepX, 0), coordinate(core::kR2StepY, 1));
        ++state_.places;
        if (glm::dot(place, place) <= 1.0F) return place;
    }
}

}  // namespace pastoso::liquid
