// Milk on its way into the tea: a stream from above, by the recipe and by the painter's hand.
#pragma once

#include "liquid/flow/velocity.hpp"
#include "liquid/tea/parcel.hpp"
#include "liquid/tea/tea_settings.hpp"

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
    struct Stream {
        double seconds = 0.0;  ///< since it began
        int parcels = 0;       ///< that have come of it
        friend bool operator==(const Stream&, const Stream&) = default;
    };
    struct State {
        Stream recipe, hand;
        std::optional<glm::vec2> hand_m;  ///< where the hand pours
        double poured_m3 = 0.0;
        std::uint32_t places = 0;  ///< of the sequence that parcels are placed by, so far
        friend bool operator==(const State&, const State&) = default;
    };

    const State& state() const { return state_; }
    void set_state(const State& state) { state_ = state; }

    /// What flows in during a step: parcels in a cylinder below the level, as far down as each has come
    /// since it was due, and the velocity of the stream on the faces there. Across the stream they lie
    /// at points of the R2 sequence (M. Roberts 2018): with the time they fill it evenly, and its skin
    /// is smooth.
    void pour(const TeaSettings& settings, std::vector<Parcel>& parcels, VelocityField& velocity);

    /// See MilkTea::pour_by_hand().
    void pour_by_hand(std::optional<glm::vec2> at_m) { state_.hand_m = at_m; }

    /// See MilkTea::pour_recipe().
    void pour_recipe(bool pours, const TeaSettings& settings) {
        state_.recipe = {pours ? 0.0 : settings.pour_s, 0};
    }
    bool recipe_flows(const TeaSettings& settings) const {
        return state_.recipe.seconds < settings.pour_s && settings.milk_m3 > 0.0;
    }

    double poured_m3() const { return state_.poured_m3; }

  private:
    /// What a step pours into.
    struct Pouring {
        const TeaSettings& settings;
        std::vector<Parcel>& parcels;
        VelocityField& velocity;
    };

    void pour_from(Stream& stream, const glm::vec2& at_m, int most, const Pouring& into);
    void pour_parcel(const glm::vec2& at_m, float way_m, const Pouring& into);
    glm::vec2 next_place(const TeaSettings& settings);

    State state_;
};

}  // namespace pastoso::liquid
