#include "appearance/picture_view.hpp"

#include <cstring>

namespace pastoso::appearance {

QImage view_of(const pigment::Image8& picture) {
    return QImage(picture.rgb.data(), picture.width, picture.height, 3 * picture.width,
                  QImage::Format_RGB888);
}

QImage view_of_rgba(const std::vector<std::uint8_t>& rgba, int width, int height) {
    return QImage(rgba.data(), width, height, 4 * width, QImage::Format_RGBA8888);
}

pigment::Picture picture_of(const QImage& image) {
    const QImage rgba = image.convertToFormat(QImage::Format_RGBA8888);
    pigment::Picture picture{rgba.width(), rgba.height(), {}};
    const std::size_t row_bytes = std::size_t{4} * rgba.width();
    picture.rgba.resize(row_bytes * rgba.height());
    for (int y = 0; y < rgba.height(); ++y)
        std::memcpy(&picture.rgba[row_bytes * y], rgba.constScanLine(y), row_bytes);
    return picture;
}

}  // namespace pastoso::appearance
