// A picture file that is written a stretch of rows at a time, so that pictures may be larger than
// memory.
#pragma once

#include "files/colour_profile.hpp"
#include "files/images_abi.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::files {

/// How one value of a channel is kept.
enum class Sample { Uint8, Uint16, Half, Single };

struct ImageChannel {
    std::string name;
    Sample sample = Sample::Half;
};

/// What a picture file holds. Rows come from the top, their channels interleaved: bytes, 16-bit words,
/// or floats where the samples are halves or single.
struct ImageLayout {
    int width = 0, height = 0;
    int channel_count = 3;
    Sample sample = Sample::Uint8;
    std::vector<ImageChannel> channels{};  ///< EXR: each by its name; empty: the usual ones
    double px_per_mm = 0.0;                ///< kept as the print resolution; 0: none
    int quality = 95;                      ///< of .jpg and .webp, 1 to 100
    bool holds_colours = true;             ///< otherwise data, such as heights
    pigment::WorkingSpace space = pigment::WorkingSpace::Srgb;
    IccProfile profile{};       ///< of colours that are not encoded in `space`
    std::string description{};  ///< for people who look into the file
};

/// Throws InputError when the name ends in no format for pictures, when that format does not hold such
/// values, or not so many pixels.
void check_layout(const std::filesystem::path& path, const ImageLayout& layout);

/// The last of these alone: throws InputError for a picture of more pixels than the format holds.
void check_picture_size(const std::filesystem::path& path, int width, int height);

class ImageWriter {
  public:
    /// Writes to `file`, in the format of `path`, which stands for it in errors. Files say what their
    /// colours are: encoded ones hold `profile` or that of their space; PNG the same as cICP (ITU-T
    /// H.273) besides, where it is the space's; linear ones in TIFF the profile of linear light, in EXR
    /// chromaticities. Throws InputError as check_layout() does, and when the file cannot be written.
    ImageWriter(const std::filesystem::path& file, const std::filesystem::path& path,
                const ImageLayout& layout);
    ~ImageWriter();
    ImageWriter(const ImageWriter&) = delete;
    ImageWriter& operator=(const ImageWriter&) = delete;

    /// The next rows. Throws InputError when they cannot be written.
    void write_rows(const void* rows, int count);

    /// Completes the file after its last row. Throws InputError when that fails.
    void finish();

  private:
    void check(int status, const char* error) const;
    void add_meaning() const;

    std::filesystem::path file_, path_;
    ImageLayout layout_;
    PastosoWriter* writer_ = nullptr;
};

/// Writes a picture aside from rows that are in memory.
void write_rows_aside(const std::filesystem::path& path, const ImageLayout& layout, const void* rows);

/// A whole PNG file in memory, packed fast rather than small.
std::string encode_png(const ImageLayout& layout, const void* rows);

/// Whether `path` names a format of linear values alone (EXR), and whether one that holds such samples.
bool is_linear_format(const std::filesystem::path& path);
bool holds(const std::filesystem::path& path, Sample sample);

}  // namespace pastoso::files
