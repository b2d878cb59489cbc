// How far the paint falls behind the time that it is to run in, told so that words for it do not
// flicker.
#pragma once

namespace pastoso::tools {

/// Of the time that the painter has set, the share in which the paint runs: all of it, a half, a third,
/// a quarter, a fifth, a tenth, or less than that.
enum class Pace { Full, Half, Third, Quarter, Fifth, Tenth, Less };

/// Another pace is told once it has lasted for a second, and is clearly another one: by a tenth beyond
/// the middle between the two.
class PaceWatch {
  public:
    /// The paint keeps up until something else is seen.
    explicit PaceWatch(double now_s) : right_s_(now_s) {}

    /// `share`, 0 and more, is what is measured at this moment, in seconds of any clock that does not
    /// run back. Returns what is told from now on.
    Pace look(double share, double now_s);

    Pace told() const { return told_; }

  private:
    Pace told_ = Pace::Full;
    double right_s_;  ///< when that was last what is seen
};

}  // namespace pastoso::tools
