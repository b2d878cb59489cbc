#include "recordings/value_json.hpp"

#include "brush/preset.hpp"
#include "files/base64.hpp"
#include "files/image.hpp"
#include "recordings/paint_json.hpp"
#include "recordings/paint_piece.hpp"

#include <array>
#include <memory>
#include <utility>

namespace pastoso::recordings {
namespace {

using document::Combination;
using document::Surface;
using files::Json;
using files::JsonPlace;

constexpr std::array<std::pair<Combination, const char*>, 4> kCombinations = {
    {{Combination::Replace, "replace"},
     {Combination::Add, "add"},
     {Combination::Subtract, "subtract"},
     {Combination::Intersect, "intersect"}}};

document::CanvasPoint read_point(const JsonPlace& place) {
    if (place.size() != 2) place.fail("a point of an outline has two numbers, x and y.");
    return {place.element(0).number(), place.element(1).number()};
}

}  // namespace

Json value_json(const document::TakeBrush& take) {
    return take.definition.empty() ? Json(take.preset) : Json::parse(take.definition);
}

Json value_json(const std::string& name) {
    return name;
}

Json value_json(const std::optional<film::Medium>& numbers) {
    return Json::parse(film::numbers_to_json(*numbers));
}

Json value_json(const document::PaintRecipe& paint) {
    return paint_json(paint);
}

Json value_json(Combination how) {
    for (const auto& [combination, name] : kCombinations)
        if (combination == how) return name;
    return nullptr;
}

Json value_json(const std::vector<document::CanvasPoint>& outline) {
    Json points = Json::array();
    for (const document::CanvasPoint& point : outline)
        points.push_back({point.x_mm, point.y_mm});
    return points;
}

Json value_json(const std::vector<document::LayerId>& layers) {
    return layers;
}

Json value_json(const document::SharedPicture& picture) {
    return files::base64(files::png_file(*picture));
}

Json value_json(const document::SharedReferencePicture& picture) {
    return files::base64(picture->png);
}

Json value_json(const document::CopiedPaint& paint) {
    return files::base64(piece_bytes(*paint));
}

Json value_json(Surface surface) {
    return surface == Surface::Well ? "well" : "canvas";
}

void ValueReader::read(const JsonPlace& place, const JsonPlace&, document::TakeBrush& take) {
    if (!place.value().is_object()) {
        take.preset = place.text();
        return;
    }
    place.guard([&] {
        const brush::Preset preset =
            brush::parse_preset(place.value().dump(), core::message("the preset"));
        take.preset = preset.name;
        take.definition = brush::preset_to_json(preset);
    });
}

void ValueReader::read(const JsonPlace& place, const JsonPlace&, std::string& name) {
    name = place.text();
}

/// The numbers that are left out are those of the medium of that name.
void ValueReader::read(const JsonPlace& place, const JsonPlace& object,
                       std::optional<film::Medium>& numbers) {
    const JsonPlace name = object.entry("name");
    film::Medium like;
    name.guard([&] { like = film::find_medium(name.text()); });
    numbers = read_medium_numbers(place, like);
}

void ValueReader::read(const JsonPlace& place, const JsonPlace&, document::PaintRecipe& paint) {
    paint = read_paint(place);
}

void ValueReader::read(const JsonPlace& place, const JsonPlace&, Combination& how) {
    const std::string wanted = place.text();
    for (const auto& [combination, name] : kCombinations) {
        if (wanted != name) continue;
        how = combination;
        return;
    }
    place.fail("there is no way \"%1\" to select; they are replace, add, subtract and intersect.",
               wanted);
}

void ValueReader::read(const JsonPlace& place, const JsonPlace&,
                       std::vector<document::CanvasPoint>& outline) {
    for (std::size_t i = 0; i < place.size(); ++i)
        outline.push_back(read_point(place.element(i)));
}

void ValueReader::read(const JsonPlace& place, const JsonPlace&,
                       std::vector<document::LayerId>& layers) {
    for (std::size_t i = 0; i < place.size(); ++i)
        layers.push_back(static_cast<document::LayerId>(place.element(i).integer(1, document::kMostId)));
}

document::ReferencePicture ValueReader::read_png(const JsonPlace& place) {
    auto file = files::from_base64(place.text());
    if (!file) place.fail("the picture is no base64.");
    document::ReferencePicture read{.pixels = {}, .png = std::move(*file)};
    place.guard([&] { read.pixels = files::decode_png(read.png); });
    picture_pixels_ += 1.0 * read.pixels.width * read.pixels.height;
    if (picture_pixels_ > document::kMostRecordedPixels)
        place.fail(
            "the pictures of this recording are too large; at most 500 million pixels in all are read.");
    return read;
}

void ValueReader::read(const JsonPlace& place, const JsonPlace&, document::SharedPicture& picture) {
    picture = std::make_shared<const pigment::Picture>(read_png(place).pixels);
}

void ValueReader::read(const JsonPlace& place, const JsonPlace&,
                       document::SharedReferencePicture& picture) {
    picture = std::make_shared<const document::ReferencePicture>(read_png(place));
}

void ValueReader::read(const JsonPlace& place, const JsonPlace&, document::CopiedPaint& paint) {
    const auto bytes = files::from_base64(place.text());
    if (!bytes) place.fail("the copied paint is no base64.");
    place.guard([&] {
        const PaintPiece piece = piece_of(*bytes, "the copied paint");
        paint = piece.paint;
        piece_bytes_ += piece.unpacked_bytes;
    });
    if (piece_bytes_ > kMostRecordedPieces_bytes)
        place.fail(
            "the paint of other paintings in this recording is too large; at most 16 GB are read.");
}

void ValueReader::read(const JsonPlace& place, const JsonPlace&, Surface& surface) {
    const std::string name = place.text();
    if (name != "canvas" && name != "well")
        place.fail("there is no surface \"%1\"; a stroke is on the \"canvas\" or the \"well\".", name);
    surface = name == "well" ? Surface::Well : Surface::Canvas;
}

}  // namespace pastoso::recordings
