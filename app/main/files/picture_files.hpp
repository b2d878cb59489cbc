// The files of pictures that dialogs offer.
#pragma once

#include <QString>

namespace pastoso::main {

/// As a filter of a file dialog.
inline QString picture_endings() {
    return QStringLiteral(
        "*.png *.jpg *.jpeg *.tif *.tiff *.webp *.exr *.hdr *.bmp *.tga *.gif *.psd *.pgm *.ppm");
}

}  // namespace pastoso::main
