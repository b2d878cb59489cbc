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
    FirstPoint,     ///< a vanishing point
    SecondPoint,
    ThirdPoint,
    Horizon,     ///< turns the horizon of a single vanishing point
    GridMiddle,  ///< moves all of it
    GridAlong,   ///< a crossing along the first lines: turns the grid, and spaces the other lines
    GridAcross,  ///< one along the others: their direction, and how far the first lines are apart
};

/// A point that lies beside the canvas has its handle at the edge that is nearest to it.
struct PlacedHandle {
    Handle handle;
    glm::dvec2 place_mm{};
    glm::dvec2 point_mm{};  ///< that it moves, there or beside the canvas
};

/// The handles of what lies on a canvas of that size.
std::vector<PlacedHandle> guide_handles(const Hand& hand, const glm::dvec2& canvas_mm);

/// The nearest handle to a place, at most `reach_mm` away.
std::optional<PlacedHandle> handle_at(const std::vector<PlacedHandle>& handles,
                                      const glm::dvec2& place_mm, double reach_mm);

using Guide = std::variant<brush::Symmetry, brush::PenGuide>;

/// The guide after the point of a handle was dragged to a place. `square` turns in steps of 15 degrees,
/// and keeps an ellipse in proportion. The guide lies there (guide_handles() has given the handle).
Guide dragged(const Hand& hand, Handle handle, const glm::dvec2& place_mm, bool square);

}  // namespace pastoso::tools
