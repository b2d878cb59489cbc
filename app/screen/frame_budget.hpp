// What a frame costs on this machine, learnt from the frames so far.
#pragma once

namespace pastoso::screen {

/// Predicts the time of shading from a running mean, so that a fast graphics card is never asked for a
/// draft and a slow one never stalls the brush.
class FrameBudget {
  public:
    /// `seconds` were spent on shading `samples` points of the surface.
    void measured(double samples, double seconds);

    double expected_s(double samples) const { return cost_s_ * samples; }

    /// The samples that can be shaded in `seconds`.
    double affordable_samples(double seconds) const { return seconds / cost_s_; }

  private:
    double cost_s_ = 20e-9;  ///< per sample; the start is a guess between the two kinds of machine
};

}  // namespace pastoso::screen
