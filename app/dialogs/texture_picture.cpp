#include "dialogs/texture_picture.hpp"

#include "layers/texture/texture_relief.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::dialogs {
namespace {

/// Brightness of paste that rises by so much a millimetre to the right and downwards, 0 to 255.
int brightness(double rise_x, double rise_y) {
    constexpr double kLight[3] = {-0.6, -0.55, 0.58};
    const double towards = -rise_x * kLight[0] - rise_y * kLight[1] + kLight[2];
    const double lit = towards / std::sqrt(1.0 + rise_x * rise_x + rise_y * rise_y);
    return static_cast<int>(std::lround(255.0 * std::clamp(0.12 + 0.98 * lit, 0.0, 1.0)));
}

}  // namespace

QImage texture_picture(const layers::Texture& texture, const QSize& size_px, double px_per_mm) {
    const int width = size_px.width(), height = size_px.height();
    // A row and a column more, for what rises to the last pixels.
    const layers::CellHeights heights_mm =
        layers::texture_heights(texture, {0, 0, width + 1, height + 1}, 1.0 / px_per_mm);
    QImage picture(size_px, QImage::Format_Grayscale8);
    for (int y = 0; y < height; ++y) {
        const float* here = &heights_mm[static_cast<std::size_t>(y) * (width + 1)];
        const float* below = here + width + 1;
        uchar* row = picture.scanLine(y);
        for (int x = 0; x < width; ++x)
            row[x] = static_cast<uchar>(
                brightness(px_per_mm * (here[x + 1] - here[x]), px_per_mm * (below[x] - here[x])));
    }
    return picture;
}

}  // namespace pastoso::dialogs
