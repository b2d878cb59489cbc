// What a picture file holds, and which formats hold it.
#pragma once

#include "files/colour_profile.hpp"

#include <filesystem>
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

/// Whether `path` names a format of linear values alone (EXR), and whether one that holds such samples.
bool is_linear_format(const std::filesystem::path& path);
bool holds(const std::filesystem::path& path, Sample sample);

/// How OpenImageIO calls the format of `path`. Throws InputError when the name ends in none for pictures.
const char* format_name(const std::filesystem::path& path);

}  // namespace pastoso::files
