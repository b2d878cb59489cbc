#include "appearance/picture_view.hpp"

namespace pastoso::appearance {

QImage view_of(const pigment::Image8& picture) {
    return QImage(picture.rgb.data(), picture.width, picture.height, 3 * picture.width,
                  QImage::Format_RGB888);
}

QImage view_of_rgba(const std::vector<std::uint8_t>& rgba, int width, int height) {
    return QImage(rgba.data(), width, height, 4 * width, QImage::Format_RGBA8888);
}

}  // namespace pastoso::appearance
