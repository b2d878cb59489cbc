// Colours as a screen is to be given them, as a table.
#pragma once

#include <array>
#include <vector>

namespace pastoso::pigment {

/// Red, green and blue with the curve of sRGB, 0 to 1.
using EncodedRgb = std::array<float, 3>;

/// What is shown in place of colours that a printer has not.
inline constexpr EncodedRgb kGamutMark = {0.5F, 0.5F, 0.5F};

/// For colours on a grid, what is shown for them; between them it is interpolated in tetrahedra, which
/// keep greys grey. The grid is finer in the dark, where curves of screens differ most from that of
/// sRGB: its values are squares of even steps.
struct ColourCube {
    static constexpr int kSide = 49;

    struct Node {
        EncodedRgb shown{};     ///< 0 to 1
        float outside = -1.0F;  ///< above 0 where the colour is to be marked
    };

    std::vector<Node> nodes = std::vector<Node>(std::size_t{kSide} * kSide * kSide);  ///< red is fastest

    /// The colour of a node along one of its sides.
    static constexpr float value_at(int step) {
        const float share = static_cast<float>(step) / (kSide - 1);
        return share * share;
    }
};

/// What is shown for a colour; what lies outside [0, 1] is taken for its nearest.
EncodedRgb shown_by(const ColourCube& cube, const EncodedRgb& colour);

/// Whether all colours are shown as they are, to half of one of 255 levels.
bool changes_nothing(const ColourCube& cube);

}  // namespace pastoso::pigment
