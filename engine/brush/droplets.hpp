// Paint that falls in drops: from a dropper, a spray can or a flicked brush.
#pragma once

#include "brush/brush.hpp"
#include "brush/cell_batch.hpp"
#include "brush/hand_pose.hpp"
#include "brush/media_exchange.hpp"
#include "film/state.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::brush {

/// a of the cap below.
double cap_radius_mm(double volume_mm3, double steepness);

/// Lets drops of the paint in a bottle (the brush's only element) fall onto the film. They fall evenly
/// in time along the way of the pen, and go on falling while it is held still. A drop that lands is a
/// cap
///
///     h(d) = s a (1 - (d/a)^2),   a = (2 V / (pi s))^(1/3),
///
/// V its volume, s the preset's steepness, as cells see it (put_down). Drops are random by a seed, so
/// that the same pen gives the same drops. Holds on to the brush and the film.
class Droplets {
  public:
    /// `limit` as in CellBatch: what falls beside it stays in the bottle.
    Droplets(Brush& brush, film::FilmState& film, const grid::Mask* limit = nullptr)
        : brush_(brush), film_(film), cells_(limit) {}

    /// The pen comes down: what the preset lets go at once falls here, as one drop. `media` as of
    /// apply(), until the pen lifts.
    void begin(const HandPose& hand, std::uint32_t seed, MediaExchange* media = nullptr);

    /// The pen moves on. `speed_mm_s` is its speed along the travel.
    void follow(const HandPose& hand, double speed_mm_s);

    /// Lets time pass: what the preset lets go in it falls along the way since the last call.
    void pass_time(double seconds);

    /// A rectangle around all cells changed since the last call; empty if none.
    grid::Rect take_changed_cells();

  private:
    /// Where the pen was and how it was held.
    struct Place {
        HandPose hand;
        double speed_mm_s = 0.0;
    };

    void let_fall(const Place& place);
    /// The next drop's mark at a place, drawn out along the travel by `streak_mm`.
    void land(double x_mm, double y_mm, double streak_mm, const HandPose& hand);
    double next_volume_mm3();
    float random();

    Brush& brush_;
    film::FilmState& film_;
    MediaExchange* media_ = nullptr;
    CellBatch cells_;
    std::vector<Place> way_;  ///< since the last drops fell; the newest place last, never empty
    double owed_mm3_ = 0.0;   ///< let go, but not enough for the next drop
    double next_mm3_ = 0.0;   ///< volume of the next drop
    std::uint32_t seed_ = 0, drawn_ = 0;
    grid::Rect changed_;
};

}  // namespace pastoso::brush
