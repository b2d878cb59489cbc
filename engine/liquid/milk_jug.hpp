// Milk on its way into the tea: a stream from above, by the recipe and by the painter's hand.
#pragma once

#include "liquid/parcel.hpp"
#include "liquid/tea_settings.hpp"
#include "liquid/velocity.hpp"

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::liquid {

/// How close to the wall parcels come.
inline constexpr float kWallMargin_cells = 0.3F;

inline float milk_per_parcel_m3(const TeaSettings& settings) {
    return static_cast<float>(settings.milk_m3 / settings.parcels);
}

class MilkJug {
  public:
    /// What flows in during a step: parcels on a disc below the level, and the velocity of the stream on
    /// the faces there.
    void pour(const TeaSettings& settings, std::vector<Parcel>& parcels, VelocityField& velocity);

    /// See MilkTea::pour_by_hand().
    void pour_by_hand(std::optional<glm::vec2> at_m) { hand_m_ = at_m; }

    double poured_m3() const { return poured_m3_; }

  private:
    struct Stream {
        double seconds = 0.0;  ///< since it began
        int parcels = 0;       ///< that have come of it
    };
    /// What a step pours into.
    struct Pouring {
        const TeaSettings& settings;
        std::vector<Parcel>& parcels;
        VelocityField& velocity;
    };

    void pour_from(Stream& stream, const glm::vec2& at_m, int most, const Pouring& into);
    void pour_parcels(int count, const glm::vec2& at_m, const Pouring& into);
    float drawn(const TeaSettings& settings);

    Stream recipe_, hand_;
    std::optional<glm::vec2> hand_m_;
    double poured_m3_ = 0.0;
    std::uint32_t draws_ = 0;
};

}  // namespace pastoso::liquid
