// Drawing the outline of an area over the canvas.
#pragma once

#include "document/actions/selection_actions.hpp"

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::interactions {

enum class AreaForm { Rectangle, Ellipse, Lasso, Polygon };

/// The area within a closed line; nothing when it is so narrow on the screen that it was a click.
std::optional<document::SelectArea> area_within(const std::vector<glm::dvec2>& outline_mm,
                                                grid::Combination how, double px_mm);

/// Knows the outline between press and release, of all forms but the polygon. Places are millimetres on
/// the canvas.
class AreaDrag {
  public:
    void press(AreaForm form, const glm::dvec2& place_mm, grid::Combination how);
    bool active() const { return form_.has_value(); }
    void cancel() { form_.reset(); }

    /// `px_mm` is as large as a pixel of the screen: a lasso keeps no points that are nearer. `square`
    /// makes both sides of a rectangle, or of that around an ellipse, as long as its longer one.
    void move(const glm::dvec2& place_mm, double px_mm, bool square);

    /// So far, a closed line.
    std::vector<glm::vec2> outline_mm() const;
    const std::vector<glm::dvec2>& points_mm() const { return points_mm_; }
    grid::Combination how() const { return how_; }

    /// Ends the outline. Nothing when it is so narrow on the screen that it was a click.
    std::optional<document::SelectArea> release(double px_mm);

  private:
    void add_to_lasso(const glm::dvec2& place_mm, double px_mm);

    std::optional<AreaForm> form_;
    grid::Combination how_ = grid::Combination::Replace;
    glm::dvec2 pressed_mm_{};
    std::vector<glm::dvec2> points_mm_;  ///< never none; the last one of a lasso follows the pointer
};

}  // namespace pastoso::interactions
