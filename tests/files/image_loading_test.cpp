#include "core/error.hpp"
#include "files/image.hpp"
#include "files/temporary_folder.hpp"

#include <fstream>
#include <iterator>

namespace pastoso::files {
namespace {

class ImageLoadingTest : public TemporaryFolder {};

bool openimageio_is_loaded() {
    std::ifstream maps("/proc/self/maps");
    const std::string text((std::istreambuf_iterator<char>(maps)), std::istreambuf_iterator<char>());
    return text.find("libOpenImageIO") != std::string::npos;
}

TEST_F(ImageLoadingTest, OpenImageIoIsLoadedWithTheFirstImageThatIsNoPngOnly) {
    const pigment::Image8 image{1, 1, {1, 2, 3}};
    EXPECT_FALSE(openimageio_is_loaded());
    EXPECT_THROW(write_image(folder / "a.xyz", image), core::InputError);
    check_image_path(folder / "a.png");
    EXPECT_FALSE(openimageio_is_loaded());
    write_image(folder / "a.png", image);
    png_file(image);
    EXPECT_FALSE(openimageio_is_loaded());
    write_image(folder / "a.tif", image);
    EXPECT_TRUE(openimageio_is_loaded());
}

}  // namespace
}  // namespace pastoso::files
