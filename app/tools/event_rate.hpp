// How many events a device sends a second, from the times of the latest of them.
#pragma once

#include <cstdint>
#include <deque>

namespace pastoso::tools {

class EventRate {
  public:
    void note(std::uint64_t time_ms);

    /// Over the last half second; 0 until there are two events that tell it.
    double hertz() const;

  private:
    std::deque<std::uint64_t> times_ms_;
};

}  // namespace pastoso::tools
