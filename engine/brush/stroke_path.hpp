// The way of the pen between its events: a smooth curve, cut into steps of equal length.
#pragma once

#include "brush/pen_sample.hpp"

#include <array>
#include <vector>

namespace pastoso::brush {

/// One step of the brush: where the pen is at its end.
struct PathStep {
    PenSample pen;
    double direction_x = 0.0;  ///< of travel, unit length
    double direction_y = 1.0;
    double speed_mm_s = 0.0;
    double travelled_mm = 0.0;  ///< by the pen since it came down
};

/// How the step length is measured. A brush that is pressed down or turned in place slides over the
/// support as well, so that length counts: sqrt(s2 + (press_slide dp)2 + (turn_radius da)2), where s is
/// the way of the tips: sqrt(dx2 + dy2), and what they catch up where pressure falls. At pressure p they
/// trail by trail sqrt(p) / (1 + (stiff_end / p)2), no further than the brush has travelled.
struct PathMeasure {
    double step_mm = 0.1;
    double press_slide_mm = 0.0;  ///< for the whole pressure
    double turn_radius_mm = 0.0;
    double trail_mm = 0.0;
    double stiff_end_pressure = 0.0;
};

/// Joins samples by cubic Hermite pieces whose tangents are finite differences in time, with one sample
/// of look-ahead, and gives out a step after every `step_mm` of length; what is left over is carried to
/// the next piece. The steps do not depend on how densely the same movement was sampled.
class StrokePath {
  public:
    explicit StrokePath(const PathMeasure& measure) : measure_(measure) {}

    /// The tip comes down in place, from no pressure to the sample's. `direction` is taken until it
    /// travels.
    void begin(const PenSample& sample, double direction_x, double direction_y);
    /// Times must increase.
    void add(const PenSample& sample);
    /// The last piece.
    void end();

    /// Of the pen since it came down.
    double travelled_mm() const { return travelled_mm_; }

    /// The steps since the last call.
    std::vector<PathStep> take_steps();

  private:
    void run_last_piece(const PenSample& after);
    void run_straight(const PenSample& to, double speed_mm_s);
    double length_mm(const PenSample& from, const PenSample& to) const;
    double trail_mm(double pressure) const;

    PathMeasure measure_;
    std::vector<PenSample> samples_;  ///< the last three
    PathStep at_;
    double travelled_mm_ = 0.0;
    double since_step_mm_ = 0.0;
    std::vector<PathStep> steps_;
};

}  // namespace pastoso::brush
