// What other programs open: the pictures of an OpenRaster file (version 0.0.3 of its specification).
#pragma once

#include "shade/render.hpp"

#include <string>
#include <vector>

namespace pastoso::project {

/// The longest side of a thumbnail, which OpenRaster gives.
inline constexpr int kLongestThumbnail_px = 256;

/// The picture made smaller, if it is larger: the mean over each pixel's area.
pigment::LinearImage thumbnail_of(const pigment::LinearImage& picture,
                                  int longest_px = kLongestThumbnail_px);

struct StackLayer {
    std::string name;
    std::string source;  ///< the entry of its picture
    bool visible = true;
};

/// stack.xml of a picture of that size; the uppermost layer comes first.
std::string stack_xml(int width_px, int height_px, double px_per_mm,
                      const std::vector<StackLayer>& layers);

}  // namespace pastoso::project
