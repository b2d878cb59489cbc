#include "recordings/picture_json.hpp"

#include "files/base64.hpp"
#include "files/image.hpp"

#include <memory>
#include <utility>

namespace pastoso::recordings {

namespace {

std::shared_ptr<const pigment::Picture> read_png(const files::JsonPlace& png, double& pixels) {
    const auto file = files::from_base64(png.text());
    if (!file) png.fail("the picture is no base64.");
    auto picture = std::make_shared<pigment::Picture>();
    png.guard([&] { *picture = files::decode_png(*file); });
    pixels += 1.0 * picture->width * picture->height;
    if (pixels > kMostRecordedPixels)
        png.fail(
            "the pictures of this recording are too large; at most 500 million pixels in all are read.");
    return picture;
}

}  // namespace

files::Json picture_place_json(const layers::PicturePlace& place) {
    return {{"x_mm", place.x_mm},
            {"y_mm", place.y_mm},
            {"width_mm", place.width_mm},
            {"height_mm", place.height_mm}};
}

layers::PicturePlace read_picture_place(const files::JsonPlace& place) {
    return {place.entry("x_mm").number(), place.entry("y_mm").number(), place.entry("width_mm").number(),
            place.entry("height_mm").number()};
}

files::Json paint_picture_json(const document::PaintPicture& paint) {
    files::Json json = picture_place_json(paint.place);
    json["name"] = paint.name;
    json["png"] = files::base64(files::png_file(*paint.picture));
    return json;
}

document::PaintPicture read_paint_picture(const files::JsonPlace& place, double& pixels) {
    place.allow_only({"name", "x_mm", "y_mm", "width_mm", "height_mm", "png"});
    return {place.entry("name").text(), read_picture_place(place), read_png(place.entry("png"), pixels)};
}

files::Json lay_tracing_json(const document::LayTracing& lay) {
    if (!lay.picture) return files::Json::object();
    files::Json json = picture_place_json(lay.place);
    json["png"] = files::base64(files::png_file(*lay.picture));
    return json;
}

document::LayTracing read_lay_tracing(const files::JsonPlace& place, double& pixels) {
    place.allow_only({"x_mm", "y_mm", "width_mm", "height_mm", "png"});
    if (place.value().empty()) return {};
    const layers::PicturePlace lies = read_picture_place(place);
    return {read_png(place.entry("png"), pixels), lies};
}

files::Json set_tracing_json(const document::SetTracing& set) {
    files::Json json = picture_place_json(set.place);
    json["opacity"] = set.opacity;
    return json;
}

document::SetTracing read_set_tracing(const files::JsonPlace& place) {
    place.allow_only({"x_mm", "y_mm", "width_mm", "height_mm", "opacity"});
    return {read_picture_place(place), place.entry("opacity").number()};
}

}  // namespace pastoso::recordings
