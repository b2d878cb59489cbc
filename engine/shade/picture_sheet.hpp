// Pictures beside each other, for looking at several at once.
#pragma once

#include "shade/render.hpp"

#include <vector>

namespace pastoso::shade {

/// The picture `factor` times larger, every pixel interpolated linearly between the centres of the four
/// around it (on the encoded values, as image viewers do); beyond the outermost centres their values.
pigment::Image8 enlarged(const pigment::Image8& picture, int factor);

/// The picture in the middle of one of that size, middle grey around it; what has no room is cut off.
pigment::LinearImage framed(const pigment::LinearImage& picture, int width, int height);

/// Rows of pictures with white between them. Columns are as wide and rows as high as their largest
/// picture; smaller ones stand at the upper left. The first row holds a picture; all are of its colour
/// space.
pigment::Image8 arranged(const std::vector<std::vector<pigment::Image8>>& rows, int gap_px);

}  // namespace pastoso::shade
