#include "pigment/colour.hpp"
#include "shade/render.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace pastoso::shade {
namespace {

/// Finds the 8-bit level of a linear value: a table gives a level that is not too high, from which it is
/// counted up over the exact borders between levels.
class LevelTable {
  public:
    LevelTable() : start_(kSteps + 1) {
        for (int level = 1; level < 256; ++level) {
            border_[level] = static_cast<float>(pigment::decode_srgb((level - 0.5) / 255.0));
        }
        border_[256] = 2.0F;
        int level = 0;
        for (int i = 0; i <= kSteps; ++i) {
            while (static_cast<float>(i) / kSteps >= border_[level + 1])
                ++level;
            start_[i] = static_cast<std::uint8_t>(level);
        }
    }

    /// `linear` in [0, 1].
    std::uint8_t level(float linear) const {
        int level = start_[static_cast<int>(linear * kSteps)];
        while (linear >= border_[level + 1])
            ++level;
        return static_cast<std::uint8_t>(level);
    }

  private:
    static constexpr int kSteps = 4096;
    std::array<float, 257> border_{};  ///< the lowest value of each level
    std::vector<std::uint8_t> start_;
};

}  // namespace

Image8 encode_srgb8(const LinearImage& image) {
    static const LevelTable table;
    Image8 encoded{image.width, image.height, std::vector<std::uint8_t>(image.rgb.size())};
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        const pigment::LinearRgb fitting =
            pigment::into_gamut({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
        for (int channel = 0; channel < 3; ++channel) {
            encoded.rgb[i + channel] = table.level(fitting[channel]);
        }
    }
    return encoded;
}

}  // namespace pastoso::shade
