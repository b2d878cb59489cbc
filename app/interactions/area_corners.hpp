// Setting the corners of an area one by one.
#pragma once

#include "document/actions/selection_actions.hpp"

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::interactions {

/// Knows the corners of a polygon from its first click to its last. Places are millimetres on the
/// canvas, and `px_mm` is as large as a pixel of the screen.
class AreaCorners {
  public:
    bool active() const { return !corners_mm_.empty(); }
    void cancel() { corners_mm_.clear(); }

    /// How the area is to be combined is asked at the first corner.
    void begin(const glm::dvec2& place_mm, grid::Combination how);

    /// True where the click closes the polygon: on the last corner again, or on the first one.
    bool closes(const glm::dvec2& place_mm, double px_mm) const;

    void add(const glm::dvec2& place_mm);  ///< at most as many as an outline can have
    void take_back();                      ///< the last corner; without any there is no polygon
    void follow(const glm::dvec2& place_mm) { pointer_mm_ = place_mm; }

    /// The corners and the pointer, a closed line.
    std::vector<glm::vec2> outline_mm() const;
    grid::Combination how() const { return how_; }

    /// Ends the polygon. Nothing when it encloses nothing.
    std::optional<document::SelectArea> close(double px_mm);

  private:
    std::vector<glm::dvec2> corners_mm_;
    glm::dvec2 pointer_mm_{};
    grid::Combination how_ = grid::Combination::Replace;
};

}  // namespace pastoso::interactions
