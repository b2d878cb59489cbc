// The points by which guides are dragged over the canvas.
#pragma once

#include "tools/hand.hpp"

#include <optional>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::tools {

enum class Handle {
    SymmetryCentre,
    MirrorAxis,  ///< turns the mirror about the centre
    RulerStart,
    RulerEnd,
    RulerMiddle,  ///< moves all of it
    EllipseCentre,
    EllipseWidth,   ///< its half width, and how it is turned
    EllipseHeight,  ///< its half height
};

struct PlacedHandle {
    Handle handle;
    glm::dvec2 place_mm{};
};

/// The handles of what lies on the canvas. `axis_mm` is how far from the centre the mirror's handle is.
std::vector<PlacedHandle> guide_handles(const Hand& hand, double axis_mm);

/// The nearest handle to a place, at most `reach_mm` away.
std::optional<PlacedHandle> handle_at(const std::vector<PlacedHandle>& handles,
                                      const glm::dvec2& place_mm, double reach_mm);

using Guide = std::variant<brush::Symmetry, brush::Ruler, brush::EllipseCurve>;

/// The guide after its handle was dragged to a place. `square` turns in steps of 15 degrees, and keeps
/// an ellipse in proportion. The guide lies there (guide_handles() has given the handle).
Guide dragged(const Hand& hand, Handle handle, const glm::dvec2& place_mm, bool square);

}  // namespace pastoso::tools
