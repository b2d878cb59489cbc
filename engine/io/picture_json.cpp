#include "io/picture_json.hpp"

#include "io/base64.hpp"
#include "io/image.hpp"

#include <memory>
#include <utility>

namespace pastoso::io {

namespace {

std::shared_ptr<const layers::Picture> read_png(const JsonPlace& png, double& pixels) {
    const auto file = from_base64(png.text());
    if (!file) png.fail("the picture is no base64.");
    auto picture = std::make_shared<layers::Picture>();
    png.guard([&] { *picture = decode_png(*file); });
    pixels += 1.0 * picture->width * picture->height;
    if (pixels > kMostRecordedPixels)
        png.fail(
            "the pictures of this recording are too large; at most 500 million pixels in all are read.");
    return picture;
}

}  // namespace

Json picture_place_json(const layers::PicturePlace& place) {
    return {{"x_mm", place.x_mm},
            {"y_mm", place.y_mm},
            {"width_mm", place.width_mm},
            {"height_mm", place.height_mm}};
}

layers::PicturePlace read_picture_place(const JsonPlace& place) {
    return {place.entry("x_mm").number(), place.entry("y_mm").number(), place.entry("width_mm").number(),
            place.entry("height_mm").number()};
}

Json paint_picture_json(const document::PaintPicture& paint) {
    Json json = picture_place_json(paint.place);
    json["name"] = paint.name;
    json["png"] = base64(png_file(*paint.picture));
    return json;
}

document::PaintPicture read_paint_picture(const JsonPlace& place, double& pixels) {
    place.allow_only({"name", "x_mm", "y_mm", "width_mm", "height_mm", "png"});
    return {place.entry("name").text(), read_picture_place(place), read_png(place.entry("png"), pixels)};
}

Json lay_tracing_json(const document::LayTracing& lay) {
    if (!lay.picture) return Json::object();
    Json json = picture_place_json(lay.place);
    json["png"] = base64(png_file(*lay.picture));
    return json;
}

document::LayTracing read_lay_tracing(const JsonPlace& place, double& pixels) {
    place.allow_only({"x_mm", "y_mm", "width_mm", "height_mm", "png"});
    if (place.value().empty()) return {};
    const layers::PicturePlace lies = read_picture_place(place);
    return {read_png(place.entry("png"), pixels), lies};
}

Json set_tracing_json(const document::SetTracing& set) {
    Json json = picture_place_json(set.place);
    json["opacity"] = set.opacity;
    return json;
}

document::SetTracing read_set_tracing(const JsonPlace& place) {
    place.allow_only({"x_mm", "y_mm", "width_mm", "height_mm", "opacity"});
    return {read_picture_place(place), place.entry("opacity").number()};
}

}  // namespace pastoso::io
