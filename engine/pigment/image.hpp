// Pictures as plain values, whatever they show and wherever they come from or go to.
#pragma once

#include "core/orientation.hpp"
#include "pigment/working_space.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::pigment {

/// A picture of linear-light values, row by row from the top, three floats a pixel.
struct LinearImage {
    int width = 0, height = 0;
    std::vector<float> rgb;
    WorkingSpace space = WorkingSpace::Srgb;
};

/// The same encoded for screens: eight bits, sRGB transfer curve, three bytes a pixel.
struct Image8 {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
    WorkingSpace space = WorkingSpace::Srgb;
};

/// The same in sixteen bits.
struct Image16 {
    int width = 0, height = 0;
    std::vector<std::uint16_t> rgb;
    WorkingSpace space = WorkingSpace::Srgb;
};

/// Larger pictures are read by nothing and made into nothing.
inline constexpr int kMostPictureSide_px = 32768;
inline constexpr double kMostPicturePixels = 1e8;

/// Red, green, blue (encoded sRGB) and coverage of each pixel, row by row from the top. The colour does
/// not depend on the coverage (straight alpha).
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    friend bool operator==(const Picture&, const Picture&) = default;
};

/// The picture turned and mirrored.
Picture turned(const Picture& picture, const core::Orientation& turn);

/// Linear to 8 or 16 bits with the curve of sRGB, in the picture's own space; values outside its gamut
/// are brought in half by clipping, half by desaturation.
Image8 encode_srgb8(const LinearImage& image);
Image16 encode_srgb16(const LinearImage& image);

}  // namespace pastoso::pigment
