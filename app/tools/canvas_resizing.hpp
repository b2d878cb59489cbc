// What follows from a canvas that is cut, made larger, turned, scaled or rotated, before it is done and
// after.
#pragma once

#include "core/orientation.hpp"
#include "document/canvas.hpp"
#include "document/selection.hpp"
#include "tools/hand.hpp"

#include <optional>

#include <glm/vec2.hpp>

namespace pastoso::tools {

/// Which part of the canvas stays where it is: 0 left or top, 1 the middle, 2 right or bottom.
struct Anchor {
    int column = 1, row = 1;
    friend bool operator==(const Anchor&, const Anchor&) = default;
};

/// A canvas of that size, what is new or cut off divided between the sides as the anchor says.
document::ResizeCanvas anchored(const document::CanvasSettings& canvas, double width_mm,
                                double height_mm, const Anchor& anchor);

/// What is added on each side, in whole cells; negative: what is cut off.
struct Margins {
    double left_mm = 0.0, top_mm = 0.0, right_mm = 0.0, bottom_mm = 0.0;
    friend bool operator==(const Margins&, const Margins&) = default;
};

/// Throws InputError as document::resized() does.
Margins margins_of(const document::ResizeCanvas& resize, const document::CanvasSettings& canvas);

/// The smallest canvas that holds what is outlined of the selection (outlined_area()); none without one,
/// where nothing is outlined, and where that is all of the canvas.
std::optional<document::ResizeCanvas> cropped_to(const document::Selection& selection,
                                                 const document::CanvasSettings& canvas);

/// Where on the canvas lies what was on it before: turned about the corner, rotated about it, drawn out
/// from it, then so much further from it.
struct CanvasMove {
    core::Orientation turn{};
    glm::dvec2 shift_mm{0.0, 0.0};
    glm::dvec2 scale{1.0, 1.0};
    double rotated_deg = 0.0;  ///< clockwise

    glm::dvec2 operator()(const glm::dvec2& place_mm) const;
    friend bool operator==(const CanvasMove&, const CanvasMove&) = default;
};

/// That of a canvas that was cut, made larger or turned, or where that was taken back.
CanvasMove move_between(const document::CanvasSettings& before, const document::CanvasSettings& after);

/// The same, or that of one that was scaled or rotated, which is no other change besides.
CanvasMove move_between(const document::BareCanvas& before, const document::BareCanvas& after);

/// How much further from the corner the middle of the canvas came to lie.
glm::dvec2 shift_of_middle_mm(const document::CanvasSettings& before, const CanvasMove& move);

/// How far everything has to be turned, clockwise, for the ruler to be level or upright, whichever is
/// nearer: -45 to 45.
double straightening_deg(const brush::Ruler& ruler);

/// Guides, symmetry and fan where they lay on what was painted.
Hand moved_along(Hand hand, const CanvasMove& move);

}  // namespace pastoso::tools
