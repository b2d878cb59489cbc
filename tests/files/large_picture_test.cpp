// A picture of the most pixels that are read, which takes next to nothing on the disk.
#include "core/memory.hpp"
#include "files/image.hpp"
#include "files/image_writer.hpp"
#include "files/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace pastoso::files {
namespace {

class LargePictureTest : public TemporaryFolder {};

TEST_F(LargePictureTest, TakesLittleMoreThanItsPixels) {
    constexpr int kSide_px = 10000, kRowsAtOnce = 100;
    const std::filesystem::path path = folder / "large.png";
    ImageLayout layout;
    layout.width = layout.height = kSide_px;
    layout.holds_colours = false;
    layout.channel_count = 1;
    core::write_aside(path, [&](core::OutputFile& file) {
        ImageWriter writer(file, layout);
        const std::vector<std::uint8_t> rows(std::size_t{kSide_px} * kRowsAtOnce, 100);
        for (int y = 0; y < kSide_px; y += kRowsAtOnce)
            writer.write_rows(rows.data(), kRowsAtOnce);
        writer.finish();
    });
    EXPECT_LT(std::filesystem::file_size(path), std::uintmax_t{2} << 20);
    EXPECT_EQ(read_picture(path).picture.height, kSide_px);
    // 400 MB of red, green, blue and alpha, and the rows in hand.
    EXPECT_LT(core::peak_memory_bytes(), std::size_t{700} << 20);
    EXPECT_EQ(read_grey_image(path).height, kSide_px);
    EXPECT_LT(core::peak_memory_bytes(), std::size_t{1100} << 20);
}

}  // namespace
}  // namespace pastoso::files
