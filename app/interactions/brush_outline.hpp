// The outline of the brush's tip around the pointer: what of the canvas it touches as it is held.
#pragma once

#include "brush/pen_sample.hpp"
#include "brush/preset.hpp"
#include "brush/tip.hpp"

#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::interactions {

class BrushOutline {
  public:
    explicit BrushOutline(const brush::Preset& tool = brush::bundled_presets().front());

    /// From now on it is that tool, as large as it is in hand.
    void set_tool(const brush::Preset& tool);

    /// A closed line, from the pen in millimetres: around all hairs that touch the canvas where the
    /// brush is set down so, or the reach of drops and breath. Around the tip at rest where the
    /// hand does not press enough for a hair to touch.
    std::vector<glm::vec2> around_mm(const brush::PenSample& pen) const;

    /// What the brush sweeps over from place to place, on the canvas in millimetres: closed lines that
    /// bulge nowhere in, all in one direction of turning, each around two places that follow one
    /// another, or around the only one. Places nearer than `gap_mm` to the one before are left out,
    /// but for the last.
    std::vector<std::vector<glm::vec2>> swept_mm(const std::vector<brush::PenSample>& places,
                                                 double gap_mm) const;

    const brush::Preset& tool() const { return tool_; }
    const brush::Tip& tip() const { return tip_; }

  private:
    brush::Preset tool_;
    brush::Tip tip_;
};

/// A closed line around circles of that radius about the points, at least one, that bulges nowhere in.
std::vector<glm::vec2> hull_mm(const std::vector<glm::vec2>& centres_mm, double radius_mm);

/// How the handle leans: from the pen to where its end is seen from above, in pixels of the layout; the
/// more it leans the longer, nothing where it stands nearly upright.
glm::dvec2 handle_px(double tilt_x_deg, double tilt_y_deg);

}  // namespace pastoso::interactions
