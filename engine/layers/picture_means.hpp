// What a picture that is laid on the canvas has in each cell.
#pragma once

#include "grid/shape.hpp"
#include "layers/picture_place.hpp"
#include "layers/projective.hpp"
#include "pigment/colour.hpp"
#include "pigment/image.hpp"

#include <vector>

namespace pastoso::layers {

/// What one row or column of cells has of a picture's rows or columns.
struct AxisCover {
    double share = 0.0;           ///< of the cell that lies on the picture
    int first = 0;                ///< pixel
    std::vector<double> weights;  ///< of the pixels from there on; their sum is 1, none without a share
};

/// The cells from `first` to before `end` on an axis, of a picture of `pixels` pixels from `begin` to
/// `begin + length`, in cells. A cell has the mean of the pixels that it covers, by area; where it is
/// smaller than a pixel, the mean over the length of one about its middle, so that enlargements are
/// interpolated. Beyond the picture's edge its last pixel goes on.
std::vector<AxisCover> axis_covers(double begin, double length, int pixels, int first, int end);

/// The mean of a cell, of light.
struct CoveredColour {
    pigment::LinearRgb colour{};  ///< on a screen; of what covers, 0 where nothing does
    float coverage = 0.0F;        ///< 0 to 1
};

/// Means for any cells. The picture outlives it.
class PictureMeans {
  public:
    PictureMeans(const pigment::Picture& picture, const PicturePlace& place, double cell_mm,
                 const grid::Shape& shape);

    /// The cells of the canvas that the picture touches.
    const grid::Rect& cells() const { return cells_; }
    /// One of these.
    CoveredColour at(int x, int y) const;

  private:
    const pigment::Picture& picture_;
    grid::Rect cells_;
    std::vector<AxisCover> columns_, rows_;  ///< of the cells
};

/// The picture on `width` x `height` pixels that `map` takes its own to, each the mean of what its place
/// was before (footprint.hpp); nothing beside it.
pigment::Picture resampled(const pigment::Picture& picture, const Projective& map, int width,
                           int height);

/// The picture in at most so many pixels a side, each the mean of what it covers; as it is where it has
/// no more.
pigment::Picture reduced(pigment::Picture picture, int most_width, int most_height);

}  // namespace pastoso::layers
