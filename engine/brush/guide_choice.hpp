// What leads a stroke, where its first way decides that.
#pragma once

#include "brush/pen_guide.hpp"

#include <vector>

namespace pastoso::brush {

/// The way of the hand after which a stroke keeps to one direction of a perspective or a grid: long
/// beside its trembling.
inline constexpr double kFirstWay_mm = 4.0;

/// Holds the samples of a stroke back until it is known where they are led: those of a straight line to
/// its end, those under a perspective or a grid for the first 4 mm from where the pen came down. Others
/// pass at once.
class GuideChoice {
  public:
    explicit GuideChoice(const PenGuide& guide = {}) : guide_(guide) {}

    /// The next sample of the stroke. Returns the ones to be followed now, with guide().
    std::vector<PenSample> add(const PenSample& sample);

    /// The pen lifts: returns the ones that are still held back. A straight line is straight.
    std::vector<PenSample> end();

    const PenGuide& guide() const { return guide_; }

  private:
    bool is_open() const;
    std::vector<PenSample> choose();

    PenGuide guide_;
    std::vector<PenSample> held_;
};

}  // namespace pastoso::brush
