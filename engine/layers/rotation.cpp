#include "layers/rotation.hpp"

#include "layers/picture_means.hpp"
#include "pigment/image.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace pastoso::layers {
namespace {

/// The upright rectangle around one that is turned.
PicturePlace around(const PicturePlace& place, const Projective& turn) {
    const double x0 = place.x_mm, y0 = place.y_mm, x1 = x0 + place.width_mm, y1 = y0 + place.height_mm;
    const grid::Point corners[] = {turn(x0, y0), turn(x1, y0), turn(x1, y1), turn(x0, y1)};
    const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x, corners[3].x});
    const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y, corners[3].y});
    return {left, top, right - left, bottom - top};
}

/// The side of the pixels of the new picture.
double pixel_mm(const pigment::Picture& before, const PicturePlace& place, const PicturePlace& after) {
    const double as_fine = std::min(place.width_mm / before.width, place.height_mm / before.height);
    const double longer_mm = std::max(after.width_mm, after.height_mm);
    return std::max({as_fine, longer_mm / pigment::kMostPictureSide_px,
                     std::sqrt(after.width_mm * after.height_mm / pigment::kMostPicturePixels)});
}

int pixels_along(double side_mm, double pixel_mm) {
    // What is short of a whole pixel by rounding alone is one.
    return std::max(1, static_cast<int>(std::floor(side_mm / pixel_mm + 1e-6)));
}

/// From the place in the picture to that on the canvas, of a pixel's size.
Projective onto_canvas(const PicturePlace& place, double width_px, double height_px) {
    return {place.width_mm / width_px, 0.0, place.x_mm, 0.0, place.height_mm / height_px, place.y_mm};
}

}  // namespace

Projective in_cells(const Rotation& rotation, double cell_mm) {
    Projective map = turn_by(rotation.angle_deg);
    const grid::Point turned = map(rotation.from.x_mm / cell_mm, rotation.from.y_mm / cell_mm);
    map.c = rotation.to.x_mm / cell_mm - turned.x;
    map.f = rotation.to.y_mm / cell_mm - turned.y;
    return map;
}

Tracing rotated(const Tracing& tracing, const Rotation& rotation) {
    const pigment::Picture& before = *tracing.picture;
    const Projective turn = in_cells(rotation, 1.0);
    const PicturePlace place = around(tracing.place, turn);
    const double pixel = pixel_mm(before, tracing.place, place);
    const int width = pixels_along(place.width_mm, pixel), height = pixels_along(place.height_mm, pixel);
    const Projective map =
        followed_by(followed_by(onto_canvas(tracing.place, before.width, before.height), turn),
                    inverse(onto_canvas(place, width, height)));
    return {std::make_shared<const pigment::Picture>(resampled(before, map, width, height)), place,
            tracing.opacity};
}

}  // namespace pastoso::layers
