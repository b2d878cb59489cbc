// Which format a picture file has, by what it holds and never by its name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pastoso::files {

enum class PictureFormat { None, Png, Jpeg, Tiff, WebP, OpenExr, Hdr, Bmp, Gif, Psd, Pnm, Targa };

/// How many of a file's first bytes the functions below look at; a file may have fewer.
inline constexpr std::size_t kPictureHeadBytes = 64;

PictureFormat picture_format(std::string_view head);

/// OpenImageIO's name of its reader: "tiff". Nothing for None.
const char* reader_name(PictureFormat format);

/// The formats' names for people: "PNG, JPEG, ...".
inline constexpr const char* kPictureFormats =
    "PNG, JPEG, TIFF, WebP, OpenEXR, Radiance HDR, BMP, GIF, Photoshop, PNM and Targa";

struct PictureSize {
    std::int64_t width = 0, height = 0;  ///< 0: not told by the first bytes
};

/// What the header says where libraries make room for the whole picture as soon as they open it (WebP,
/// GIF, BMP, Photoshop, Targa); of others, nothing.
PictureSize told_size(PictureFormat format, std::string_view head);

}  // namespace pastoso::files
