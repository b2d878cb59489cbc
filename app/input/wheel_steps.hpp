// The wheel on an airbrush, by notches.
#pragma once

#include <optional>

namespace pastoso::input {

class WheelSteps {
  public:
    /// It stands there now, from -1 to 1: how many notches it was turned, forward as positive ones. None
    /// when it is seen for the first time.
    int moved_to(double wheel);

  private:
    std::optional<double> counted_;  ///< where the latest notch was
};

}  // namespace pastoso::input
