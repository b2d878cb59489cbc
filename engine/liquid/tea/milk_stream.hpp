// Milk in the air, on its way from the lip of a jug down to the tea.
#pragma once

#include "liquid/vessel/cup.hpp"

#include <cmath>
#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::liquid {

/// The acceleration of what falls.
inline constexpr double kFreeFall_m_s2 = 9.81;

/// A stream in free fall, upright and round. The same volume passes every height z:
///     v^2 = v_lip^2 + 2 g max(lip - z, 0),     r^2 v = r_lip^2 v_lip.
struct MilkStream {
    glm::vec2 at_m{0.0F};               ///< where its axis stands
    float lip_m = 0.0F;                 ///< height of the lip
    float high_m = 0.0F, low_m = 0.0F;  ///< there is milk between these heights alone
    float lip_speed_m_s = 0.1F;         ///< downwards, > 0
    float lip_radius_m = 0.001F;        ///< > 0

    float speed_m_s(float z_m) const;
    float radius_m(float z_m) const { return lip_radius_m * std::sqrt(lip_speed_m_s / speed_m_s(z_m)); }
    friend bool operator==(const MilkStream&, const MilkStream&) = default;
};

/// The speed after so long a way down.
double fallen_speed_m_s(double lip_speed_m_s, double way_m);
/// The way after so much time.
double fallen_way_m(double lip_speed_m_s, double seconds);

/// What is seen of the pouring at one moment.
struct SeenPour {
    float level_m = 0.0F;  ///< of the tea with its milk; 0: as the cup says (old files)
    std::vector<MilkStream> streams;
    friend bool operator==(const SeenPour&, const SeenPour&) = default;
};

/// The cup with its tea as it is seen.
inline Cup cup_in(const SeenPour& pour, const Cup& cup) {
    return pour.level_m > 0.0F ? filled_to(cup, pour.level_m) : cup;
}

/// Whether the stream has come down to a level.
inline bool has_arrived(const MilkStream& stream, float level_m) {
    return stream.low_m <= level_m;
}

}  // namespace pastoso::liquid
