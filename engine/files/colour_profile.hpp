// ICC colour profiles: what the numbers in a picture file mean. LittleCMS reads, writes and applies
// them.
#pragma once

#include "core/message.hpp"
#include "pigment/image.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace pastoso::files {

/// A profile as it stands in files: the bytes of ICC.1. Empty: none.
using IccProfile = std::string;

/// The profile of pictures that are encoded in a working space (ICC version 4: matrix and parametric
/// curve, about 600 bytes; always the same bytes). The whites are taken to D50 after Bradford.
IccProfile icc_profile(pigment::WorkingSpace space);

/// The same of pictures that hold the space's linear light.
IccProfile linear_icc_profile(pigment::WorkingSpace space);

/// The profile in a file, for pictures that are to be written in it. Throws InputError when the file
/// holds no ICC profile, one for other than RGB pictures, or one that colours can be read but not
/// written with.
IccProfile read_icc_profile(const std::filesystem::path& path);

/// CIE chromaticities of a linear picture's primaries and white: red x, y, green, blue, white.
using Chromaticities = std::array<float, 8>;
Chromaticities chromaticities_of(pigment::WorkingSpace space);

/// What is known of the numbers that were read from a picture file.
struct StoredColour {
    IccProfile profile;                            ///< goes before all else where there is one
    bool linear = false;                           ///< linear light, otherwise the curve of sRGB
    std::optional<Chromaticities> chromaticities;  ///< of linear values; otherwise those of sRGB
};

/// Takes the values of a picture file (three a pixel) into linear light of the working space, white to
/// white (relative colorimetric); what lies outside the space gets values below 0 or above 1. `name`
/// stands for the picture in errors. Throws InputError when its profile is none or is for other
/// pictures.
void into_working_space(pigment::LinearImage& image, const StoredColour& colour,
                        const core::Message& name);

/// A picture in the colours of a profile, three values of 0 to 1 a pixel: brought into the gamut of its
/// own space first, then converted with the profile's perceptual rendering where it has one, otherwise
/// relative to its white with black matched. `profile` is one that read_icc_profile() returned.
pigment::LinearImage in_profile(const pigment::LinearImage& image, const IccProfile& profile);

}  // namespace pastoso::files
