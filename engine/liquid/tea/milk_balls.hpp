// Balls of milk: now and then parcels at the top of what has settled become a ball, which warms
// and rises.
#pragma once

#include "liquid/tea/parcel.hpp"
#include "liquid/tea/tea_settings.hpp"

#include <cstdint>
#include <span>

namespace pastoso::liquid {

class MilkBalls {
  public:
    /// What the balls were and when the next one comes; which parcels belong to them, those know.
    struct State {
        double next_s = 0.0;
        int count = 0;            ///< 0 and more
        std::uint32_t draws = 0;  ///< by lot, so far
        friend bool operator==(const State&, const State&) = default;
    };

    explicit MilkBalls(const TeaSettings& settings) : state_{.next_s = settings.first_ball_s} {}

    int count() const { return state_.count; }
    const State& state() const { return state_; }
    void set_state(const State& state) { state_ = state; }

    /// Turns parcels into a ball when it is time: of some parcels drawn by lot the highest, and all
    /// around it that belong to no ball yet.
    void nucleate(double time_s, const TeaSettings& settings, std::span<Parcel> parcels);

  private:
    float drawn(const TeaSettings& settings);

    State state_;
};

}  // namespace pastoso::liquid
