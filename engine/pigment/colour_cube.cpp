#include "pigment/colour_cube.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::pigment {
namespace {

constexpr int kLast = ColourCube::kSide - 1;
constexpr std::array<int, 3> kStride = {1, ColourCube::kSide, ColourCube::kSide* ColourCube::kSide};

/// Where a colour lies along one side.
struct GridPlace {
    int step;
    float share;  ///< of the way to the next one
};

GridPlace place_of(float value) {
    const float along = kLast * std::sqrt(std::clamp(value, 0.0F, 1.0F));
    const int step = std::min(static_cast<int>(along), kLast - 1);
    return {step, along - static_cast<float>(step)};
}

void add(ColourCube::Node& sum, float weight, const ColourCube::Node& node) {
    for (int i = 0; i < 3; ++i)
        sum.shown[i] += weight * node.shown[i];
    sum.outside += weight * node.outside;
}

ColourCube::Node interpolated(const ColourCube& cube, const EncodedRgb& colour) {
    int at = 0;
    std::array<std::pair<float, int>, 3> ways;  // from the nearest darker node along each side
    for (int i = 0; i < 3; ++i) {
        const GridPlace place = place_of(colour[i]);
        at += place.step * kStride[i];
        ways[i] = {place.share, kStride[i]};
    }
    if (ways[0].first < ways[1].first) std::swap(ways[0], ways[1]);
    if (ways[1].first < ways[2].first) std::swap(ways[1], ways[2]);
    if (ways[0].first < ways[1].first) std::swap(ways[0], ways[1]);
    ColourCube::Node sum{{}, 0.0F};
    float left = 1.0F;
    for (const auto& [share, stride] : ways) {
        add(sum, left - share, cube.nodes[at]);
        left = share;
        at += stride;
    }
    add(sum, left, cube.nodes[at]);
    return sum;
}

}  // namespace

EncodedRgb shown_by(const ColourCube& cube, const EncodedRgb& colour) {
    const ColourCube::Node found = interpolated(cube, colour);
    return found.outside > 0.0F ? kGamutMark : found.shown;
}

bool changes_nothing(const ColourCube& cube) {
    constexpr float kUnseen = 0.5F / 255.0F;
    std::size_t index = 0;
    for (int blue = 0; blue <= kLast; ++blue)
        for (int green = 0; green <= kLast; ++green)
            for (int red = 0; red <= kLast; ++red, ++index) {
                const ColourCube::Node& node = cube.nodes[index];
                const std::array<int, 3> steps = {red, green, blue};
                for (int i = 0; i < 3; ++i)
                    if (std::abs(node.shown[i] - ColourCube::value_at(steps[i])) > kUnseen) return false;
                if (node.outside > 0.0F) return false;
            }
    return true;
}

}  // namespace pastoso::pigment
