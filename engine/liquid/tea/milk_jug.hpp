// Milk on its way into the tea: a stream from above, by the recipe and by the painter's hand.
#pragma once

#include "liquid/flow/velocity.hpp"
#include "liquid/tea/milk_stream.hpp"
#include "liquid/tea/parcel.hpp"
#include "liquid/tea/tea_settings.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::liquid {

/// How close to the wall parcels come.
inline constexpr float kWallMargin_cells = 0.3F;

/// The height of the tea's surface when so much milk has been poured: that of the cup, once it is the
/// recipe's milk.
float level_m(const TeaSettings& settings, double poured_m3);

inline float milk_per_parcel_m3(const TeaSettings& settings) {
    return static_cast<float>(settings.milk_m3 / settings.parcels);
}

class MilkJug {
  public:
    /// What comes of one tilt of a jug. It begins to leave the lip at 0 s and ends to at `until_s`; it
    /// arrives later, by the time of its fall.
    struct Stream {
        double seconds = 0.0;  ///< since the jug was tilted
        double until_s = 0.0;
        int parcels = 0;       ///< that have come of it
        glm::vec2 at_m{0.0F};  ///< where it falls
        friend bool operator==(const Stream&, const Stream&) = default;
    };
    struct State {
        Stream recipe, hand;
        double poured_m3 = 0.0;
        std::uint32_t places = 0;  ///< of the sequence that parcels are placed by, so far
        friend bool operator==(const State&, const State&) = default;
    };
    /// Of a hand's stream that goes on.
    static constexpr double kNoEnd_s = 1e9;

    /// A jug that begins to pour the recipe's milk.
    explicit MilkJug(const TeaSettings& settings) { pour_recipe(true, settings); }

    const State& state() const { return state_; }
    /// A recipe's stream without an end (old checkpoints) ends as the settings say.
    void set_state(const State& state, const TeaSettings& settings);

    /// What flows in during `dt_s`: at most `room` parcels in a column below the level, as far down as
    /// each has come since it was due, and the column's velocity on the faces there. Across the stream
    /// they lie at points of the R2 sequence (M. Roberts 2018): with the time they fill it evenly, and
    /// its skin is smooth.
    void pour(const TeaSettings& settings, double dt_s, std::size_t room, std::vector<Parcel>& poured,
              VelocityField& velocity);

    /// See MilkTea::pour_by_hand().
    void pour_by_hand(std::optional<glm::vec2> at_m, const Cup& cup);

    /// See MilkTea::pour_recipe().
    void pour_recipe(bool pours, const TeaSettings& settings);
    /// Whether the jug is tilted.
    bool recipe_flows(const TeaSettings& settings) const {
        return state_.recipe.seconds < state_.recipe.until_s && settings.milk_m3 > 0.0;
    }
    /// How fast milk meets the tea during the next `dt_s`; 0: none does.
    double arriving_speed_m_s(const TeaSettings& settings, double dt_s) const;

    double poured_m3() const { return state_.poured_m3; }
    /// No parcel more fits: streams end.
    bool is_full(const TeaSettings& settings) const;
    SeenPour seen(const TeaSettings& settings) const;

  private:
    /// What a step pours into.
    struct Pouring {
        const TeaSettings& settings;
        double dt_s;
        Cup cup;         ///< filled up to the level
        float radius_m;  ///< of a stream there
        double most_m3;  ///< that may have been poured
        std::size_t room;
        std::vector<Parcel>& poured;
        VelocityField& velocity;
    };

    bool can_pour(const TeaSettings& settings) const;
    void pour_from(Stream& stream, int most, const Pouring& into);
    void pour_parcel(const Stream& stream, float way_m, const Pouring& into);
    glm::vec2 next_place(const TeaSettings& settings);

    State state_;
};

}  // namespace pastoso::liquid
