#include "view/masking_skin.hpp"

#include <algorithm>

namespace pastoso::view {
namespace {

/// Of the slanting stripes, in pixels of the picture.
constexpr int kStripe_px = 6;

/// Premultiplied.
constexpr QRgb kLight = qRgba(118, 112, 84, 118), kDark = qRgba(30, 40, 58, 118);

QImage skin_of(const grid::Mask& cells) {
    const grid::Shape shape = cells.shape();
    const int side = std::max(shape.width, shape.height);
    const int block = (side + MaskingSkin::kMostSide_px - 1) / MaskingSkin::kMostSide_px;
    QImage picture((shape.width + block - 1) / block, (shape.height + block - 1) / block,
                   QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    for (int y = 0; y < picture.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < picture.width(); ++x)
            if (cells.at(x * block, y * block) != 0)
                row[x] = (x + y) / kStripe_px % 2 == 0 ? kLight : kDark;
    }
    return picture;
}

}  // namespace

const QImage& MaskingSkin::picture(const document::Masking& masking) {
    if (masking == masking_) return picture_;
    masking_ = masking;
    picture_ = masking.cells ? skin_of(*masking.cells) : QImage();
    return picture_;
}

}  // namespace pastoso::view
