// Pictures in layers as Photoshop's files (.psd), which most painting programs open.
#pragma once

#include "core/output_file.hpp"
#include "pigment/image.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace pastoso::files {

/// The longest side that the format holds.
inline constexpr int kLongestPsd_px = 30000;

struct PsdLayer {
    std::string name;  ///< UTF-8
    bool visible = true;
    pigment::Image8 picture;
    std::vector<std::uint8_t> cover;  ///< opacity, a value a pixel; empty: opaque
};

/// All of one size, in sRGB.
struct PsdPicture {
    pigment::Image8 merged;        ///< what programs show that do not care for layers
    std::vector<PsdLayer> layers;  ///< from below
    double px_per_mm = 1.0;
};

/// Writes it packed (PackBits), with the profile of sRGB. Of names the first 255 bytes are kept for
/// programs that know no Unicode. Throws InputError for more than kLongestPsd_px a side, and where the
/// file would be larger than 2 GB, which the format does not hold. (Adobe Photoshop File Formats
/// Specification, November 2019.)
void write_psd(const PsdPicture& picture, core::OutputFile& file);

/// A row as PackBits packs it: runs of three and more equal bytes as their number and the byte.
std::string packed_bits(const std::string& row);

}  // namespace pastoso::files
