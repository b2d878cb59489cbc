#include "io/picture_json.hpp"

#include "io/base64.hpp"
#include "io/image.hpp"

#include <memory>
#include <utility>

namespace pastoso::io {

Json paint_picture_json(const document::PaintPicture& paint) {
    return {{"name", paint.name},
            {"x_mm", paint.place.x_mm},
            {"y_mm", paint.place.y_mm},
            {"width_mm", paint.place.width_mm},
            {"height_mm", paint.place.height_mm},
            {"png", base64(png_file(*paint.picture))}};
}

document::PaintPicture read_paint_picture(const JsonPlace& place, double& pixels) {
    place.allow_only({"name", "x_mm", "y_mm", "width_mm", "height_mm", "png"});
    document::PaintPicture paint;
    paint.name = place.entry("name").text();
    paint.place = {place.entry("x_mm").number(), place.entry("y_mm").number(),
                   place.entry("width_mm").number(), place.entry("height_mm").number()};
    const JsonPlace png = place.entry("png");
    const auto file = from_base64(png.text());
    if (!file) png.fail("the picture is no base64.");
    png.guard([&] {
        auto picture = std::make_shared<layers::Picture>(decode_png(*file));
        pixels += 1.0 * picture->width * picture->height;
        paint.picture = std::move(picture);
    });
    if (pixels > kMostRecordedPixels)
        png.fail(
            "the pictures of this recording are too large; at most 500 million pixels in all are read.");
    return paint;
}

}  // namespace pastoso::io
