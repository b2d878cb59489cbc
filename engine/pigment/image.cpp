#include "pigment/image.hpp"

#include "pigment/colour.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace pastoso::pigment {
namespace {

/// Finds the level of a linear value in an encoding of kLevels levels: a table over kSteps equal steps
/// gives a level that is not too high, from which it is counted up over the exact borders between
/// levels.
template <class Sample, int kLevels, int kSteps>
class LevelTable {
  public:
    LevelTable() : border_(kLevels + 1), start_(kSteps + 1) {
        for (int level = 1; level < kLevels; ++level) {
            border_[level] = static_cast<float>(decode_srgb((level - 0.5) / (kLevels - 1.0)));
        }
        border_[kLevels] = 2.0F;
        int level = 0;
        for (int i = 0; i <= kSteps; ++i) {
            while (static_cast<float>(i) / kSteps >= border_[level + 1])
                ++level;
            start_[i] = static_cast<Sample>(level);
        }
    }

    /// `linear` in [0, 1].
    Sample level(float linear) const {
        int level = start_[static_cast<int>(linear * kSteps)];
        while (linear >= border_[level + 1])
            ++level;
        return static_cast<Sample>(level);
    }

  private:
    std::vector<float> border_;  ///< the lowest value of each level
    std::vector<Sample> start_;
};

template <class Image, class Table>
Image encode(const LinearImage& image, const Table& table) {
    Image encoded{image.width, image.height, {}, image.space};
    encoded.rgb.resize(image.rgb.size());
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        const LinearRgb fitting =
            into_gamut({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]}, image.space);
        for (int channel = 0; channel < 3; ++channel) {
            encoded.rgb[i + channel] = table.level(fitting[channel]);
        }
    }
    return encoded;
}

}  // namespace

Picture turned(const Picture& picture, const core::Orientation& turn) {
    Picture result{picture.width, picture.height, {}};
    if (turn.swaps_sides()) std::swap(result.width, result.height);
    result.rgba.resize(picture.rgba.size());
    const core::CellsBefore before(turn, picture.width, picture.height);
    auto to = result.rgba.begin();
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            const auto [from_x, from_y] = before(x, y);
            const std::size_t pixel = std::size_t{1} * from_y * picture.width + from_x;
            to = std::copy_n(&picture.rgba[4 * pixel], 4, to);
        }
    return result;
}

Image8 encode_srgb8(const LinearImage& image) {
    static const LevelTable<std::uint8_t, 256, 4096> table;
    return encode<Image8>(image, table);
}

Image16 encode_srgb16(const LinearImage& image) {
    static const LevelTable<std::uint16_t, 65536, 65536> table;
    return encode<Image16>(image, table);
}

}  // namespace pastoso::pigment
