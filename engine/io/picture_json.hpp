// Pictures that were painted onto a canvas, in recordings.
#pragma once

#include "document/picture_events.hpp"
#include "io/json_place.hpp"

namespace pastoso::io {

/// With the picture itself, as a PNG file in base64.
Json paint_picture_json(const document::PaintPicture& paint);

/// `pixels` counts what the pictures of a recording hold in all. Fails beyond kMostRecordedPixels.
document::PaintPicture read_paint_picture(const JsonPlace& place, double& pixels);

/// Few bytes of a recording can unfold to many pixels, and a recording can hold many pictures.
inline constexpr double kMostRecordedPixels = 5e8;

}  // namespace pastoso::io
