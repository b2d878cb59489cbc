// Small pictures of what canvases are made of, as the engine lights it.
#pragma once

#include <string>

#include <QImage>
#include <QPixmap>
#include <QSize>

namespace pastoso::start {

/// A bare piece of a support that has a name, about as large as life on the screen.
QImage support_picture(const std::string& support, const QSize& size_px);

/// That picture with an edge, which it needs on a light ground.
QPixmap edged(QImage picture);

/// A canvas of that size in the middle of `room`, drawn to a scale, and covered with the picture of its
/// support.
QPixmap sheet_picture(const QSizeF& size_mm, double px_per_mm, const QSize& room, const QImage& support,
                      double pixel_ratio);

}  // namespace pastoso::start
