#include "liquid/tea/milk_jug.hpp"

#include "core/elementary.hpp"
#include "core/r2_sequence.hpp"
#include "core/random.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace pastoso::liquid {
namespace {

/// A glass takes so much milk by hand, and none above this distance from its rim.
constexpr double kMostMilkInCup = 0.5, kBelowRim_m = 0.002;
/// Parcels begin a little under the level.
constexpr float kStreamStart_m = 0.0015F;
constexpr double kStreamRise_per_s = 8.0;
/// At the lip; slower streams would be wider than any lip.
constexpr double kLeastLipSpeed_m_s = 0.02;
/// A parcel that lacks so much of its time is due: the last one must not be lost to rounding.
constexpr double kDueSoon = 1e-6;
/// A stream that is shorter is not seen.
constexpr float kShortestStream_m = 1e-4F;
constexpr std::uint32_t kPourStream = 0x3071U;

double lip_speed_m_s(const TeaSettings& settings) {
    return std::max(settings.pour_speed_m_s, kLeastLipSpeed_m_s);
}

/// How long milk falls.
double fall_s(const TeaSettings& settings) {
    const double lip_m_s = lip_speed_m_s(settings);
    // The mean of a speed that grows evenly is that of its ends.
    return 2.0 * settings.pour_height_m / (lip_m_s + fallen_speed_m_s(lip_m_s, settings.pour_height_m));
}

/// Of a stream that began to arrive `seconds` ago.
double speed_at_level_m_s(const TeaSettings& settings, double seconds) {
    const double begun = 1.0 - core::exponential(-kStreamRise_per_s * seconds);
    return fallen_speed_m_s(settings.pour_speed_m_s * begun, settings.pour_height_m);
}

MilkStream stream_of(const TeaSettings& settings, float level) {
    MilkStream stream;
    stream.lip_m = level + static_cast<float>(settings.pour_height_m);
    stream.lip_speed_m_s = static_cast<float>(lip_speed_m_s(settings));
    stream.lip_radius_m = static_cast<float>(settings.pour_radius_m);
    return stream;
}

/// A column under the level.
struct Column {
    glm::vec2 at_m;
    float radius_m, high_m, low_m;
};

/// The share of a face across z, of the box half a cell around it, that a column takes.
float covered(const Column& column, const glm::vec3& face_m, float cell_m) {
    const float half_m = 0.5F * cell_m;
    const float along_m =
        std::min(column.high_m, face_m.z + half_m) - std::max(column.low_m, face_m.z - half_m);
    const float aside_m = column.radius_m - glm::distance(glm::vec2(face_m), column.at_m);
    return std::clamp(along_m / cell_m, 0.0F, 1.0F) * std::clamp(aside_m / cell_m + 0.5F, 0.0F, 1.0F);
}

/// What flows in takes the place of what was there, with its own speed: so much momentum comes in.
void push_column(const Column& column, float speed_m_s, VelocityField& velocity) {
    const grid::BoxShape& shape = velocity.shape();
    const int first = std::max(static_cast<int>(column.low_m / shape.cell_m), 1),
              last = std::min(static_cast<int>(column.high_m / shape.cell_m) + 1, shape.nz - 1);
    for (int k = first; k <= last; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                const glm::vec3 face_m =
                    shape.cell_m * (glm::vec3(i, j, k) + glm::vec3(0.5F, 0.5F, 0.0F));
                const float share = covered(column, face_m, shape.cell_m);
                float& w = velocity.z.at(i, j, k);
                w += share * (-speed_m_s - w);
            }
}

/// A place outside of a cup's level.
glm::vec2 taken_to_wall(const glm::vec2& at_m, const Cup& cup) {
    const glm::vec2 from_axis_m = at_m - cup.axis_m;
    const float radius_m = cup.inner_radius_m(cup.level_m), way_m = glm::length(from_axis_m);
    return way_m > radius_m ? cup.axis_m + from_axis_m * (radius_m / way_m) : at_m;
}

double most_poured_m3(const TeaSettings& settings) {
    const Cup& cup = settings.cup;
    const double full_m3 = tea_volume_m3(cup);
    const double top_m =
        std::max(static_cast<double>(cup.level_m),
                 std::min(static_cast<double>(cup.rim_m) - kBelowRim_m, settings.box_m));
    const double brimful_m3 = tea_volume_m3(filled_to(cup, static_cast<float>(top_m)));
    return std::min(settings.milk_m3 + brimful_m3 - full_m3, kMostMilkInCup * full_m3);
}

/// Half a parcel more than is left does: the last one must not be lost to rounding.
bool fits(float parcel_m3, double poured_m3, double most_m3) {
    return poured_m3 + 0.5 * static_cast<double>(parcel_m3) <= most_m3;
}

}  // namespace

float level_m(const TeaSettings& settings, double poured_m3) {
    const double volume_m3 = tea_volume_m3(settings.cup) - settings.milk_m3 + poured_m3;
    const float top_m = std::min(settings.cup.rim_m, static_cast<float>(settings.box_m));
    return std::min(level_at_volume_m(settings.cup, volume_m3), top_m);
}

void MilkJug::pour_by_hand(std::optional<glm::vec2> at_m, const Cup& cup) {
    Stream& hand = state_.hand;
    const bool flows = hand.until_s == kNoEnd_s;
    if (at_m && !flows) hand = {.until_s = kNoEnd_s};
    if (at_m) hand.at_m = taken_to_wall(*at_m, cup);
    if (!at_m && flows) hand.until_s = hand.seconds;
}

void MilkJug::pour_recipe(bool pours, const TeaSettings& settings) {
    Stream& recipe = state_.recipe;
    if (pours)
        recipe = {.until_s = settings.pour_s, .at_m = settings.cup.axis_m};
    else
        recipe.until_s = std::min(recipe.until_s, recipe.seconds);
}

void MilkJug::set_state(const State& state, const TeaSettings& settings) {
    state_ = state;
    if (state.recipe.until_s != kNoEnd_s) return;
    state_.recipe.until_s = settings.pour_s;
    state_.recipe.at_m = settings.cup.axis_m;
}

void MilkJug::pour(const TeaSettings& settings, double dt_s, std::size_t room,
                   std::vector<Parcel>& poured, VelocityField& velocity) {
    poured.clear();
    if (!can_pour(settings)) return;
    const float level = level_m(settings, state_.poured_m3);
    const Pouring into{settings,
                       dt_s,
                       filled_to(settings.cup, level),
                       stream_of(settings, level).radius_m(level),
                       most_poured_m3(settings),
                       room,
                       poured,
                       velocity};
    pour_from(state_.recipe, settings.parcels, into);
    pour_from(state_.hand, kMaxParcels, into);
}

/// The stream gains speed; at most so many parcels come of it.
void MilkJug::pour_from(Stream& stream, int most, const Pouring& into) {
    const TeaSettings& settings = into.settings;
    const double fall = fall_s(settings);
    if (stream.seconds >= stream.until_s + fall) return;
    stream.seconds += into.dt_s;
    const double arriving_s = stream.seconds - fall;
    if (arriving_s <= 0.0) return;
    const double speed_m_s = speed_at_level_m_s(settings, arriving_s);
    const double parcel_s = settings.pour_s / settings.parcels;
    const double left_jug_s = std::min(arriving_s, stream.until_s);
    const int due =
        static_cast<int>(std::min(static_cast<double>(most), left_jug_s / parcel_s + kDueSoon));
    for (; stream.parcels < due; ++stream.parcels) {
        const double since_s = arriving_s - parcel_s * (stream.parcels + 1);
        pour_parcel(stream, static_cast<float>(speed_m_s * since_s), into);
    }
    const float way_m = static_cast<float>(speed_m_s * std::min(into.dt_s, arriving_s));
    const float level = into.cup.level_m;
    push_column({stream.at_m, into.radius_m, level, level - way_m}, static_cast<float>(speed_m_s),
                into.velocity);
}

void MilkJug::pour_parcel(const Stream& stream, float way_m, const Pouring& into) {
    const TeaSettings& settings = into.settings;
    const float volume_m3 = milk_per_parcel_m3(settings);
    if (!fits(volume_m3, state_.poured_m3, into.most_m3) || into.poured.size() == into.room) return;
    const glm::vec2 across_m = stream.at_m + into.radius_m * next_place(settings);
    const glm::vec3 place_m(across_m, into.cup.level_m - kStreamStart_m - way_m);
    const float margin_m = kWallMargin_cells * into.velocity.shape().cell_m;
    into.poured.push_back({brought_within(into.cup, place_m, margin_m), volume_m3, 1.0F, -1});
    state_.poured_m3 += static_cast<double>(volume_m3);
}

bool MilkJug::is_full(const TeaSettings& settings) const {
    return !fits(milk_per_parcel_m3(settings), state_.poured_m3, most_poured_m3(settings));
}

bool MilkJug::can_pour(const TeaSettings& settings) const {
    return settings.milk_m3 > 0.0 && !is_full(settings);
}

double MilkJug::arriving_speed_m_s(const TeaSettings& settings, double dt_s) const {
    double fastest_m_s = 0.0;
    if (!can_pour(settings)) return fastest_m_s;
    const double fall = fall_s(settings);
    for (const Stream* stream : {&state_.recipe, &state_.hand}) {
        const double arriving_s = stream->seconds + dt_s - fall;
        if (arriving_s > 0.0 && stream->seconds < stream->until_s + fall)
            fastest_m_s = std::max(fastest_m_s, speed_at_level_m_s(settings, arriving_s));
    }
    return fastest_m_s;
}

SeenPour MilkJug::seen(const TeaSettings& settings) const {
    SeenPour pour{level_m(settings, state_.poured_m3), {}};
    if (!can_pour(settings)) return pour;
    MilkStream seen = stream_of(settings, pour.level_m);
    const auto height_after = [&](double seconds) {
        const double way_m = fallen_way_m(lip_speed_m_s(settings), std::max(seconds, 0.0));
        return std::max(seen.lip_m - static_cast<float>(way_m), pour.level_m);
    };
    for (const Stream* stream : {&state_.recipe, &state_.hand}) {
        seen.at_m = stream->at_m;
        seen.low_m = height_after(stream->seconds);
        seen.high_m = height_after(stream->seconds - stream->until_s);
        if (seen.high_m > seen.low_m + kShortestStream_m) pour.streams.push_back(seen);
    }
    return pour;
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
