#include "screen/encoded_pixels.hpp"

#include "pigment/colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

namespace pastoso::screen {
namespace {

/// The curve of sRGB to 16 bits, between the entries of a table over roots: there it is nearly straight.
class Encoder {
  public:
    Encoder() {
        for (int i = 0; i <= kSteps + 1; ++i) {
            const double root = std::min(1.0, static_cast<double>(i) / kSteps);
            values_[i] = static_cast<float>(kMost16 * pigment::encode_srgb(root * root));
        }
    }

    /// Of a value in [0, 1].
    quint16 operator()(float linear) const {
        const float along = kSteps * std::sqrt(linear);
        const int step = static_cast<int>(along);
        const float share = along - static_cast<float>(step);
        return static_cast<quint16>(values_[step] + share * (values_[step + 1] - values_[step]) + 0.5F);
    }

  private:
    static constexpr int kSteps = 2048;
    std::array<float, kSteps + 2> values_{};
};

}  // namespace

QRgba64 encoded(const glm::dvec3& colour) {
    const glm::dvec3 levels = glm::floor(kMost16 * glm::clamp(colour, 0.0, 1.0) + 0.5);
    return qRgba64(static_cast<quint16>(levels.r), static_cast<quint16>(levels.g),
                   static_cast<quint16>(levels.b), 0xFFFF);
}

QRgba64 encoded_light(float red, float green, float blue) {
    static const Encoder encode;
    return qRgba64(encode(red), encode(green), encode(blue), 0xFFFF);
}

}  // namespace pastoso::screen
