// A rendered picture on its way into a file: which colours it is kept in, and how finely.
#pragma once

#include "files/image_writer.hpp"

#include <filesystem>
#include <string>

namespace pastoso::files {

struct PictureEncoding {
    int depth_bits = 8;    ///< 8 or 16 for a channel of .png and .tif; 32, linear light, of .tif
    IccProfile profile{};  ///< of read_icc_profile(); empty: the picture's own working space
    int quality = 95;      ///< of .jpg and .webp, 1 to 100
};

/// What a picture should be kept in, as users name it.
struct PictureColours {
    pigment::WorkingSpace space = pigment::WorkingSpace::Srgb;  ///< to render it in
    IccProfile profile{};                                       ///< to convert it to; empty: none
};

/// "srgb", "display-p3", or the path of an ICC profile (then rendered in Display P3, the wider of the
/// two, and converted). Throws InputError as read_icc_profile() does.
PictureColours picture_colours(const std::string& name_or_path);

/// Whether a picture can be written to `path` like this, asked before the work that it takes: throws
/// InputError where check_image_path() does, when the format does not hold that depth, or when an ICC
/// profile is asked for in a format of linear light.
void check_picture_path(const std::filesystem::path& path, const PictureEncoding& encoding);

/// What a file at `path` holds of a picture in this space and encoding. Throws like
/// check_picture_path().
ImageLayout picture_layout(const std::filesystem::path& path, int width, int height,
                           pigment::WorkingSpace space, const PictureEncoding& encoding,
                           double px_per_mm);

/// The next rows of such a file.
void write_picture_rows(ImageWriter& writer, const ImageLayout& layout,
                        const pigment::LinearImage& rows);

/// Encodes and writes the picture as the ending of `path` and `encoding` say; EXR takes its linear
/// values as they are. Throws like check_picture_path() and write_image().
void write_picture(const std::filesystem::path& path, const pigment::LinearImage& image,
                   const PictureEncoding& encoding, double px_per_mm = 0.0);

}  // namespace pastoso::files
