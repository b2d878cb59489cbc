#include "files/stored_image.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace pastoso::files {

float StoredImage::at(int x, int y, const std::string& channel) const {
    const int k = spec.channelindex(channel);
    EXPECT_GE(k, 0) << channel;
    if (k < 0) return 0.0F;
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(spec.width) + static_cast<std::size_t>(x);
    return values[pixel * static_cast<std::size_t>(spec.nchannels) + static_cast<std::size_t>(k)];
}

StoredImage stored_image(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    StoredImage image;
    EXPECT_TRUE(input != nullptr) << OIIO::geterror();
    if (input == nullptr) return image;
    image.spec = input->spec();
    image.values.resize(image.spec.image_pixels() * static_cast<std::size_t>(image.spec.nchannels));
    EXPECT_TRUE(
        input->read_image(0, 0, 0, image.spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data()))
        << input->geterror();
    return image;
}

}  // namespace pastoso::files
