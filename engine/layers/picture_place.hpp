// Where a picture lies on the canvas.
#pragma once

namespace pastoso::layers {

/// A rectangle on the canvas; x right, y down.
struct PicturePlace {
    double x_mm = 0.0, y_mm = 0.0;  ///< upper left corner
    double width_mm = 0.0, height_mm = 0.0;
    friend bool operator==(const PicturePlace&, const PicturePlace&) = default;
};

}  // namespace pastoso::layers
