// Pictures that are put onto the canvas as paint, or below it to be traced, as plain data.
#pragma once

#include "layers/picture_place.hpp"
#include "pigment/image.hpp"

#include <memory>
#include <string>

namespace pastoso::document {

/// Adds a layer above the active one that holds the picture as dry paint (layers/flat_paint.hpp), and
/// makes it active. Its paint comes out of the tubes.
struct PaintPicture {
    std::string name;            ///< of the layer
    layers::PicturePlace place;  ///< sides of 0.1 to 20000 mm; may reach beyond the canvas
    /// Not null; 1 to pigment::kMostPictureSide_px a side, pigment::kMostPicturePixels in all.
    std::shared_ptr<const pigment::Picture> picture;

    friend bool operator==(const PaintPicture& a, const PaintPicture& b) {
        return a.name == b.name && a.place == b.place &&
               (a.picture == b.picture || *a.picture == *b.picture);
    }
};

/// Lays a picture below the paint to be traced, in place of the one before, or takes that away. It is
/// seen in the window alone, and is no paint.
struct LayTracing {
    /// As in PaintPicture; null: none.
    std::shared_ptr<const pigment::Picture> picture;
    layers::PicturePlace place;  ///< as in PaintPicture

    friend bool operator==(const LayTracing& a, const LayTracing& b) {
        return a.place == b.place &&
               (a.picture == b.picture || (a.picture && b.picture && *a.picture == *b.picture));
    }
};
/// Where the tracing picture lies, and how strongly it shows. Nothing happens where there is none.
struct SetTracing {
    layers::PicturePlace place;
    double opacity = 0.5;  ///< 0 to 1
    friend bool operator==(const SetTracing&, const SetTracing&) = default;
};

}  // namespace pastoso::document
