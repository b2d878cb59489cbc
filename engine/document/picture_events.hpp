// A picture that is put onto the canvas as paint, as plain data.
#pragma once

#include "layers/picture.hpp"

#include <memory>
#include <string>

namespace pastoso::document {

/// Adds a layer above the active one that holds the picture as dry paint (layers/flat_paint.hpp), and
/// makes it active. Its paint comes out of the tubes.
struct PaintPicture {
    std::string name;            ///< of the layer
    layers::PicturePlace place;  ///< sides of 0.1 to 20000 mm; may reach beyond the canvas
    /// Not null; 1 to layers::kMostPictureSide_px a side, layers::kMostPicturePixels in all.
    std::shared_ptr<const layers::Picture> picture;

    friend bool operator==(const PaintPicture& a, const PaintPicture& b) {
        return a.name == b.name && a.place == b.place &&
               (a.picture == b.picture || *a.picture == *b.picture);
    }
};

}  // namespace pastoso::document
