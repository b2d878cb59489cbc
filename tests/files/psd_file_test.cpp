// Files in layers, read by another reader than ours.
#include "files/psd_file.hpp"

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "files/image.hpp"
#include "files/temporary_folder.hpp"

#include <algorithm>
#include <random>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

namespace pastoso::files {
namespace {

using testing::HasSubstr;

/// As the format's own description unpacks a row.
std::string unpacked(const std::string& packed) {
    std::string row;
    for (std::size_t i = 0; i < packed.size();) {
        const int head = static_cast<signed char>(packed[i++]);
        if (head >= 0) {
            row.append(packed, i, static_cast<std::size_t>(head) + 1);
            i += static_cast<std::size_t>(head) + 1;
        } else {
            row.append(static_cast<std::size_t>(1 - head), packed[i++]);
        }
    }
    return row;
}

TEST(PackBits, PacksAndUnpacks) {
    EXPECT_EQ(packed_bits("aaaa"),
              "\xFD"
              "a");
    EXPECT_EQ(packed_bits("abc"),
              "\x02"
              "abc");
    EXPECT_EQ(packed_bits("abbb"), std::string("\0a\xFE"
                                               "b",
                                               4));
    EXPECT_EQ(packed_bits(""), "");
    std::mt19937 random(7);
    for (const std::size_t length : {1U, 2U, 127U, 128U, 129U, 255U, 256U, 257U, 1000U})
        for (const unsigned kinds : {1U, 2U, 3U, 200U}) {
            std::string row(length, '\0');
            for (char& value : row)
                value = static_cast<char>(random() % kinds);
            EXPECT_EQ(unpacked(packed_bits(row)), row) << length << " of " << kinds;
            EXPECT_LE(packed_bits(row).size(), length + length / 64 + 2);
        }
}

class PsdFile : public TemporaryFolder {
  protected:
    /// Columns of one value, rows of another, and of the layer a third.
    static pigment::Image8 picture(int shade) {
        pigment::Image8 image{kWidth, kHeight, {}};
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                for (const int value : {3 * x, 5 * y, shade})
                    image.rgb.push_back(static_cast<std::uint8_t>(value));
        return image;
    }
    static std::vector<std::uint8_t> cover() {
        std::vector<std::uint8_t> values;
        for (int i = 0; i < kWidth * kHeight; ++i)
            values.push_back(static_cast<std::uint8_t>(i % 3 == 0 ? 0 : 255));
        return values;
    }
    std::filesystem::path written(const PsdPicture& of) const {
        const std::filesystem::path path = folder / "a.psd";
        core::write_aside(path, [&](core::OutputFile& file) { write_psd(of, file); });
        return path;
    }
    static constexpr int kWidth = 71, kHeight = 43;
    const PsdPicture three_{picture(10),
                            {{"Canvas", true, picture(20), {}},
                             {"L\xC3\xA4sst \xE7\xB5\xB5 \xF0\x9F\x96\x8C", false, picture(30), cover()},
                             {std::string(300, 'n'), true, picture(40), cover()}},
                            8.0};
};

TEST_F(PsdFile, HoldsThePictureAndEveryLayer) {
    const auto input = OIIO::ImageInput::open(written(three_).string());
    ASSERT_NE(input, nullptr) << OIIO::geterror();
    const int shades[] = {10, 20, 30, 40};
    for (int part = 0; part < 4; ++part) {
        ASSERT_TRUE(input->seek_subimage(part, 0)) << part;
        const OIIO::ImageSpec& spec = input->spec();
        ASSERT_EQ(spec.width, kWidth);
        ASSERT_EQ(spec.height, kHeight);
        ASSERT_EQ(spec.nchannels, part == 0 ? 3 : 4);
        std::vector<std::uint8_t> pixels(static_cast<std::size_t>(kWidth * kHeight * spec.nchannels));
        ASSERT_TRUE(input->read_image(part, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data()));
        for (int i = 0; i < kWidth * kHeight; ++i) {
            const std::uint8_t* pixel = &pixels[static_cast<std::size_t>(i * spec.nchannels)];
            const int opacity = part < 2 ? 255 : cover()[static_cast<std::size_t>(i)];
            if (spec.nchannels == 4) {
                ASSERT_EQ(pixel[3], opacity) << part;
            }
            if (opacity == 0) continue;
            ASSERT_EQ(pixel[0], 3 * (i % kWidth)) << part;
            ASSERT_EQ(pixel[1], 5 * (i / kWidth)) << part;
            ASSERT_EQ(pixel[2], shades[part]) << part;
        }
    }
    EXPECT_FALSE(input->seek_subimage(4, 0));
}

TEST_F(PsdFile, TellsNamesInUnicodeAndWhatIsHidden) {
    const std::string file = core::read_text_file(written(three_));
    EXPECT_THAT(file, HasSubstr(std::string("\0L\0\xE4\0s\0s\0t\0 \x7D\x75\0 \xD8\x3D\xDD\x8C", 20)));
    const auto flags_of = [&](std::size_t layer) {
        std::size_t at = 0;
        for (std::size_t i = 0; i <= layer; ++i)
            at = file.find("8BIMnorm", at) + 8;
        return static_cast<unsigned>(file[at + 2]);
    };
    EXPECT_EQ(flags_of(0) & 2U, 0U);
    EXPECT_EQ(flags_of(1) & 2U, 2U);
    EXPECT_EQ(flags_of(2) & 2U, 0U);
    EXPECT_EQ(flags_of(0) & 1U, 0U) << "its opacity may be changed";
}

TEST_F(PsdFile, IsReadAsAPicture) {
    const pigment::LinearImage read = read_colour_image(written(three_));
    EXPECT_EQ(read.width, kWidth);
    EXPECT_EQ(pigment::encode_srgb8(read).rgb, three_.merged.rgb);
}

TEST_F(PsdFile, RefusesMoreThanTheFormatHolds) {
    PsdPicture wide{
        {kLongestPsd_px + 1, 1, std::vector<std::uint8_t>(3 * (kLongestPsd_px + 1))}, {}, 8.0};
    try {
        written(wide);
        ADD_FAILURE();
    } catch (const core::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("a.psd: 30001 x 1 pixels are more than the 30000 a side"));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace pastoso::files
