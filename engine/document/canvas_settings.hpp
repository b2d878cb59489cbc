// What a canvas is made of.
#pragma once

#include "core/orientation.hpp"

#include <string>

namespace pastoso::document {

/// Where a step on a cloth comes to lie on a canvas: (x, y) -> (xx x + xy y, yx x + yy y).
struct ClothMap {
    double xx = 1.0, xy = 0.0, yx = 0.0, yy = 1.0;
    friend bool operator==(const ClothMap&, const ClothMap&) = default;
};

/// The same settings at another resolution give the same canvas, finer or coarser.
struct CanvasSettings {
    double width_mm = 300.0;
    double height_mm = 200.0;
    double px_per_mm = 4.0;         ///< cells per millimetre
    std::string support = "linen";  ///< "linen", "cotton duck", "panel", or "image" with support_image
    std::string support_image{};    ///< path of a height image of the user's own
    double support_relief_mm =
        0.0;  ///< height of its white above its black; 0: the support's own relief
    /// How its cloth has been turned, about a point of its own; an image, as it was stretched.
    core::Orientation support_turn{};
    /// How it has been turned by any angle and drawn out after that, about the same point.
    /// An image has not.
    ClothMap support_map{};
    /// Where on what became of the cloth the canvas begins, in whole cells unless there is a map; of an
    /// image, from where it was stretched.
    double support_x_mm = 0.0, support_y_mm = 0.0;
    friend bool operator==(const CanvasSettings&, const CanvasSettings&) = default;
};

}  // namespace pastoso::document
