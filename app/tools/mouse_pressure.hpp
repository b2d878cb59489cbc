// How hard a mouse presses, which cannot tell: always alike, or the lighter the faster it goes.
#pragma once

#include "tools/pen_settings.hpp"

#include <cstdint>

#include <glm/vec2.hpp>

namespace pastoso::tools {

/// Follows a mouse, or a finger, on the screen. Its speed is steadied by a one-pole filter in time,
/// solved exactly for a speed that is constant from event to event, so that the same movement presses
/// alike however often the mouse tells of it.
class MousePressure {
  public:
    /// At a moment and a place on the screen, in pixels of the layout: zooming changes nothing.
    void moved_to(const glm::dvec2& place_px, std::uint64_t time_ms);

    /// The pressure that was chosen, at a standstill; by speed, less the faster it goes, down to a
    /// quarter.
    double pressure(const MouseSettings& mouse) const;

    double speed_px_s() const { return speed_px_s_; }

  private:
    bool started_ = false;
    glm::dvec2 place_px_{};
    double way_px_ = 0.0;  ///< gone since the clock last moved
    std::uint64_t time_ms_ = 0;
    double speed_px_s_ = 0.0;
};

}  // namespace pastoso::tools
