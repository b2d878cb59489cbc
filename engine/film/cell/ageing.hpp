// What happens to paint besides flowing: it dries, and what is dry is dissolved again.
#pragma once

#include "film/cell/drying.hpp"

namespace pastoso::film {

/// Both are slow beside the flow and are carried on in intervals, which follow from the ticks alone:
/// drying when ten seconds of it have come together (at most ten times a second of paint time),
/// dissolving every second. In between, a canvas costs nothing.
class AgeingClock {
  public:
    /// What has come together and is not carried out yet.
    struct Pending {
        double drying_s = 0.0;  ///< at the air's speed
        int drying_ticks = 0;
        double dissolving_s = 0.0;
        friend bool operator==(const Pending&, const Pending&) = default;
    };

    /// Lets a tick of paint time pass, but for the cells of `cover`; null: none.
    void tick(double tick_s, const DryingAir& air, FilmState& state, core::ThreadPool& pool,
              const grid::Mask* cover = nullptr);

    const Pending& pending() const { return pending_; }
    void restore(const Pending& pending) { pending_ = pending; }

  private:
    Pending pending_;
};

}  // namespace pastoso::film
