// Pictures that were painted onto a canvas or laid below the paint, in recordings.
#pragma once

#include "document/picture_events.hpp"
#include "files/json_place.hpp"

namespace pastoso::recordings {

/// With the picture itself, as a PNG file in base64.
files::Json paint_picture_json(const document::PaintPicture& paint);

/// `pixels` counts what the pictures of a recording hold in all. Fails beyond kMostRecordedPixels.
document::PaintPicture read_paint_picture(const files::JsonPlace& place, double& pixels);

/// Of a picture that is taken away: an empty object.
files::Json lay_tracing_json(const document::LayTracing& lay);
document::LayTracing read_lay_tracing(const files::JsonPlace& place, double& pixels);

files::Json set_tracing_json(const document::SetTracing& set);
document::SetTracing read_set_tracing(const files::JsonPlace& place);

/// x_mm, y_mm, width_mm and height_mm, beside what else there is.
files::Json picture_place_json(const layers::PicturePlace& place);
layers::PicturePlace read_picture_place(const files::JsonPlace& place);

/// Few bytes of a recording can unfold to many pixels, and a recording can hold many pictures.
inline constexpr double kMostRecordedPixels = 5e8;

}  // namespace pastoso::recordings
