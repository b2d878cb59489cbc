// Cutting the canvas and making it larger, as plain data.
#pragma once

namespace pastoso::document {

/// The canvas becomes this rectangle of its own millimetres, in whole cells. What is added is bare: more
/// of the same cloth, or the outermost heights of an image going on; what is cut off is wiped off. The
/// selection and the tracing picture come along. Guides, symmetry and fan stay at their millimetres,
/// which count from the new corner.
struct ResizeCanvas {
    double x_mm = 0.0, y_mm = 0.0;
    double width_mm = 0.0, height_mm = 0.0;
    friend bool operator==(const ResizeCanvas&, const ResizeCanvas&) = default;
};

}  // namespace pastoso::document
