// Pictures in files: they are written in the format of the file's extension, and read in the one that the
// file has. OpenImageIO is loaded at the first use, but not for reading PNG.
#pragma once

#include "files/colour_profile.hpp"
#include "pigment/image.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::files {

/// One value a pixel, row by row from the top; what a picture file calls black is 0 and white 1.
struct GreyImage {
    int width = 0, height = 0;
    std::vector<float> values;
};

/// The formats a picture can be saved in, by extension: .png, .tif and .tiff, .jpg and .jpeg, .webp,
/// .exr.
/// Throws InputError when the extension is another, or when the folder is missing or not writable. To be
/// called before long work whose result goes to `path`.
void check_image_path(const std::filesystem::path& path);

/// These write aside and rename, as ImageWriter does (image_writer.hpp). `px_per_mm` is kept in the file
/// as its print resolution (0: none). Eight bits: PNG, TIFF, JPEG and WebP. Sixteen bits: PNG and TIFF.
/// Linear values: EXR with halves. One value a pixel, for data such as heights: EXR and TIFF with single
/// precision. Encoded values are in the picture's working space, or in `profile`.
/// Throw InputError when the format does not hold such values or the file cannot be written.
void write_image(const std::filesystem::path& path, const pigment::Image8& image, double px_per_mm = 0.0,
                 const IccProfile& profile = {});
void write_image(const std::filesystem::path& path, const pigment::Image16& image,
                 double px_per_mm = 0.0, const IccProfile& profile = {});
void write_image(const std::filesystem::path& path, const pigment::LinearImage& image,
                 double px_per_mm = 0.0);
void write_image(const std::filesystem::path& path, const GreyImage& image, double px_per_mm = 0.0);

/// A whole PNG file, for archives: packed fast rather than small, otherwise as write_image() writes it.
std::string png_file(const pigment::Image8& image, double px_per_mm = 0.0);

/// The same with transparency: 255 or 0 for every pixel, or nothing at all for an opaque picture.
std::string png_file(const pigment::Image8& image, double px_per_mm,
                     const std::vector<std::uint8_t>& covered);

/// Whether the file begins as a picture does that can be read. Throws InputError when it cannot be opened.
bool holds_picture(const std::filesystem::path& path);

/// Reads a picture (open_picture() of picture_rows.hpp says which) into linear light of the working
/// space: by the ICC profile in the file, or the chromaticities of an EXR; what says nothing is sRGB,
/// linear where it holds floats. Grey becomes three equal values; transparency is left out. Throws
/// InputError when it is no image, is too large, is cut off, or holds an ICC profile that is none.
pigment::LinearImage read_colour_image(const std::filesystem::path& path,
                                       pigment::WorkingSpace space = pigment::WorkingSpace::Srgb);

/// A picture with the size that its file gives it.
struct StoredPicture {
    pigment::Picture picture;
    double width_mm = 0.0, height_mm = 0.0;  ///< 0: not said
};

/// The same colours encoded in sRGB, those beyond it brought in (pigment::into_gamut), with the file's
/// transparency, and turned upright as the file says (EXIF). 72 and 96 pixels per inch say nothing of
/// the size: programs write them that know none.
StoredPicture read_picture(const std::filesystem::path& path);

/// A PNG file in memory, its values as they stand there. Throws InputError "the picture ..." when it is
/// damaged or too large.
pigment::Picture decode_png(std::string_view file);

/// The same with its colours in sRGB, by the ICC profile in the file where there is one; those beyond it
/// are brought in (pigment::into_gamut). Throws InputError for a profile that is none, too.
pigment::Picture decode_png_to_srgb(std::string_view file);

/// decode_png() the other way round, exactly; packed fast rather than small.
std::string png_file(const pigment::Picture& picture);

/// Reads a picture as one grey value a pixel: the first of one or two channels, the luminance of three or
/// more, as stored, multiplied by the alpha. Throws InputError as read_colour_image() does, but for
/// profiles, which are not looked at.
GreyImage read_grey_image(const std::filesystem::path& path);

}  // namespace pastoso::files
