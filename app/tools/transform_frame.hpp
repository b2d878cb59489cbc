// The frame by which the paint of a layer is moved, scaled, turned, mirrored and put into perspective.
#pragma once

#include "document/painting.hpp"

#include <array>
#include <optional>

#include <glm/vec2.hpp>

namespace pastoso::tools {

/// A box around paint, and where it is taken. A point p of the canvas comes to
///
///     centre + move + R(turn) diag(scale) (P(p) - centre),
///
/// as in layers::Transform; the centre is that of the box. P takes each corner of the box as far as it
/// is pulled, and keeps straight what is straight; it is none where no corner is.
struct TransformFrame {
    glm::dvec2 corner_mm{};        ///< the upper left one of the box
    glm::dvec2 size_mm{1.0, 1.0};  ///< above 0
    glm::dvec2 move_mm{};
    double turn_deg = 0.0;  ///< clockwise, -180 to 180
    glm::dvec2 scale{1.0,
                     1.0};  ///< below 0 mirrors; document::kLeastScale to kMostScale without its sign

    /// How far the corners are pulled, clockwise from the upper left one, before they are scaled and
    /// turned.
    std::array<glm::dvec2, 4> pull_mm{};

    bool is_distorted() const { return pull_mm != std::array<glm::dvec2, 4>{}; }
    glm::dvec2 centre_mm() const { return corner_mm + 0.5 * size_mm; }
    friend bool operator==(const TransformFrame&, const TransformFrame&) = default;
};

/// The cells in which the active layer holds wet or dry paint, as far as they are selected and not
/// masked; empty where there is none. Clear medium that has dried is not seen.
grid::Rect painted_cells(const document::Snapshot& painting);

/// A frame around cells, at most one cell wider: quarter turns of it bring cells onto cells.
TransformFrame frame_around(const grid::Rect& cells, double cell_mm);

/// Where the frame takes a place of the canvas.
glm::dvec2 placed(const TransformFrame& frame, const glm::dvec2& place_mm);

/// A corner or the middle of a side, where it is now: x is -1 for the left, 0 for the middle, 1 for the
/// right of the box as it was; y likewise from the top.
glm::dvec2 handle_mm(const TransformFrame& frame, const glm::ivec2& side);

/// The eight of them, clockwise from the upper left one.
inline constexpr std::array<glm::ivec2, 8> kFrameHandles = {
    {{-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}}};

/// The four of them that are corners, in the order of TransformFrame::pull_mm.
inline constexpr std::array<glm::ivec2, 4> kFrameCorners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

/// What a press takes hold of.
struct FrameHold {
    enum class Kind { Move, Scale, Distort, Turn } kind = Kind::Move;
    glm::ivec2 side{};  ///< the handle that scales or distorts
    friend bool operator==(const FrameHold&, const FrameHold&) = default;
};

/// A handle within reach scales, or distorts where that is asked for; inside the frame paint is moved,
/// outside turned.
FrameHold hold_at(const TransformFrame& frame, const glm::dvec2& place_mm, double reach_mm,
                  bool distort = false);

/// The frame after what the press took hold of was dragged from one place to another. Moving goes by
/// whole cells. Scaling leaves the opposite corner or side where it is. Distorting takes a corner, or
/// both corners of a side, and leaves the others. `constrained` moves along one axis, keeps proportions,
/// turns to multiples of 15 degrees, and distorts along one axis of the box.
TransformFrame dragged(const TransformFrame& frame, const FrameHold& hold, const glm::dvec2& from_mm,
                       const glm::dvec2& to_mm, bool constrained, double cell_mm);

/// What is to be done to the layer by a frame that is not distorted; none where everything stays as it
/// is. Where nothing but the move could blur the paint, it goes by whole cells.
std::optional<layers::Transform> transform_of(const TransformFrame& frame, double cell_mm);

/// The same by one that is.
layers::Distortion distortion_of(const TransformFrame& frame);

/// Why the paint cannot be distorted so: its corners go round no area, or a side is scaled too far.
/// Empty where it can, and for a frame that is not distorted.
core::Message problem_of(const TransformFrame& frame);

/// By how much the area of the box has grown.
double area_growth(const TransformFrame& frame);

}  // namespace pastoso::tools
