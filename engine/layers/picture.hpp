// Pictures that become paint.
#pragma once

#include <cstdint>
#include <vector>

namespace pastoso::layers {

/// Larger ones are not made into paint.
inline constexpr int kMostPictureSide_px = 32768;
inline constexpr double kMostPicturePixels = 1e8;

/// Red, green, blue (encoded sRGB) and coverage of each pixel, row by row from the top. The colour does
/// not depend on the coverage (straight alpha).
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    friend bool operator==(const Picture&, const Picture&) = default;
};

/// A rectangle on the canvas; x right, y down.
struct PicturePlace {
    double x_mm = 0.0, y_mm = 0.0;  ///< upper left corner
    double width_mm = 0.0, height_mm = 0.0;
    friend bool operator==(const PicturePlace&, const PicturePlace&) = default;
};

}  // namespace pastoso::layers
