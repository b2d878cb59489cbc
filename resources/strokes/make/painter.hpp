// A scripted painter: strokes and dips of the brush in order, with the time they take.
#pragma once

#include "brush/preset.hpp"
#include "document/events.hpp"

#include <cstdint>
#include <functional>
#include <string>

namespace pastoso::examples {

/// Where the brush is and how it is held at one moment of a stroke.
struct Touch {
    double x_mm = 0.0, y_mm = 0.0;
    double pressure = 0.4;
    double rotation_deg = 0.0;  ///< 0: the width of the tip lies along x
    double tilt_x_deg = 0.0, tilt_y_deg = 0.0;
};

class Painter {
  public:
    explicit Painter(const document::CanvasSettings& canvas);

    /// `paint_share` of it by volume, the rest is what thins it.
    void use_medium(const std::string& name, double paint_share = 1.0);
    void tilt_canvas(double tilt_deg);
    void wait(double seconds);
    /// Waits for a moment of the session; an error once it is over.
    void wait_until(double moment_s);
    void dry_now();
    void set_symmetry(const brush::Symmetry& symmetry);

    /// Takes a clean brush; every one is a different piece of its kind.
    void take(const std::string& preset, double size_mm = 0.0);
    void dip(const document::LoadPaint& load);
    void wipe();

    /// Squeezes paint onto the mixing well.
    void squeeze(const document::PaintRecipe& paint, double x_mm, double y_mm,
                 double volume_mm3 = 250.0);

    /// The strokes from now on are there.
    void turn_to(document::Surface surface) { surface_ = surface; }

    /// Takes a tool that does not come with the program.
    void take_own(const brush::Preset& preset);

    /// One stroke of `duration_s`; `path` is asked from 0 to 1, at least `least_samples` times.
    void stroke(double duration_s, const std::function<Touch(double)>& path, int least_samples = 4);

    /// The recording, with the paint left to itself for some seconds more.
    document::Recording finish(double seconds_after);

  private:
    std::int64_t tick() const;
    template <class Kind>
    void note(const Kind& action);

    document::Recording recording_;
    double now_s_ = 0.0;
    std::uint32_t brushes_taken_ = 0;
    document::Surface surface_ = document::Surface::Canvas;
};

/// "PB29=2 PW6=1": a mixture by parts.
document::PaintRecipe mixture(const std::string& parts, double strength = 1.0);

/// One paint, or two half-mixed on the brush (`share` of the second, differing from bristle to bristle).
document::LoadPaint load(const document::PaintRecipe& paint, double fill = 1.0);
document::LoadPaint load(const document::PaintRecipe& paint, const document::PaintRecipe& second,
                         double share, double fill = 1.0);

}  // namespace pastoso::examples
