// A picture made as large as it fits.
#pragma once

#include <QImage>
#include <QPixmap>

namespace pastoso::panels {

/// Sharp on a screen of that pixel ratio; `room` is in pixels of the layout. Null where the picture is.
inline QPixmap fitted(const QImage& picture, const QSize& room, double pixel_ratio) {
    if (picture.isNull()) return {};
    QPixmap pixmap = QPixmap::fromImage(
        picture.scaled(room * pixel_ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    pixmap.setDevicePixelRatio(pixel_ratio);
    return pixmap;
}

}  // namespace pastoso::panels
