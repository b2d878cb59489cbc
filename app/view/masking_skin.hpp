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

    /// Of all the canvas, and nothing where nothing is masked: fluid is a bluish skin with a rounded rim
    /// that shines towards the upper left, tape a strip of warm paper with fibres and a crisp edge.
    /// Paint of any colour shows through. A pixel stands for one cell, or for several of a large canvas.
    /// Null where nothing is masked at all.
    const QImage& picture(const document::Masking& masking);

  private:
    document::Masking masking_;
    QImage picture_;
};

}  // namespace pastoso::view
