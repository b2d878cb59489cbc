// Colours between the levels of a screen.
#pragma once

namespace pastoso::appearance {

/// Above this share of the way from a level to the next one a pixel gets the next, 0 to 1: the 64
/// thresholds of an ordered dither (Bayer 1973), which any 8 x 8 pixels hold once. They stand still on
/// the screen, whatever is drawn anew, are alike for red, green and blue, so that greys stay grey, and
/// leave values that are levels as they are. `kFinishShader` has the same.
constexpr float dither_threshold(int x, int y) {
    int order = 0;
    for (int bit = 0; bit < 3; ++bit)
        order = order << 2 | ((x ^ y) >> bit & 1) << 1 | (y >> bit & 1);
    return (static_cast<float>(order) + 0.5F) / 64.0F;
}

/// Of 255 levels, `value` in [0, 1].
constexpr int dithered(float value, float threshold) {
    return static_cast<int>(255.0F * value + threshold);
}

}  // namespace pastoso::appearance
