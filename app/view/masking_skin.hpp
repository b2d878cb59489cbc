// The skin that masking fluid and tape are on the screen: a picture to be drawn over the canvas.
#pragma once

#include "document/masking.hpp"

#include <QImage>

namespace pastoso::view {

/// Keeps the picture for as long as the same is masked.
class MaskingSkin {
  public:
    /// Larger ones take longer to draw than a frame may.
    static constexpr int kMostSide_px = 2048;

    /// Of all the canvas: light and dark stripes that paint of any colour shows through, and nothing
    /// where nothing is masked. A pixel stands for one cell, or for several of a large canvas. Null
    /// where nothing is masked at all.
    const QImage& picture(const document::Masking& masking);

  private:
    document::Masking masking_;
    QImage picture_;
};

}  // namespace pastoso::view
