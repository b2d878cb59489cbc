// Image files as another program sees them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

namespace pastoso::files {

struct StoredImage {
    OIIO::ImageSpec spec;
    std::vector<float> values;  ///< channels interleaved; integers as 0 to 1

    /// A pixel's value in the channel of this name; fails the test where there is none.
    float at(int x, int y, const std::string& channel) const;
};

/// Fails the test where the file cannot be read.
StoredImage stored_image(const std::filesystem::path& path);

}  // namespace pastoso::files
