// Dragging guides over the canvas by their handles.
#pragma once

#include "tools/guide_handles.hpp"

#include <optional>

namespace pastoso::interactions {

/// Knows which handle the pointer holds. Places are millimetres on the canvas.
class GuideDrag {
  public:
    /// Takes hold of the handle within reach; false where there is none.
    bool press(const tools::Hand& hand, const glm::dvec2& place_mm, const glm::dvec2& canvas_mm,
               double reach_mm);

    bool active() const { return handle_.has_value(); }
    void release() { handle_.reset(); }

    /// The guide with the handle's point moved as far as the pointer was, wherever it was pressed.
    /// Nothing when no handle is held, or when its guide was taken away meanwhile.
    std::optional<tools::Guide> move(const tools::Hand& hand, const glm::dvec2& place_mm,
                                     bool square) const;

  private:
    std::optional<tools::Handle> handle_;
    glm::dvec2 canvas_mm_{};
    glm::dvec2 offset_mm_{};  ///< from where it was pressed to the handle's point
};

}  // namespace pastoso::interactions
