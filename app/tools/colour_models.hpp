// The colours of a screen in the terms that painters choose them by.
#pragma once

#include "pigment/hex_colour.hpp"

#include <array>

namespace pastoso::tools {

enum class ColourModel {
    Rgb,   ///< red, green, blue of encoded sRGB, 0 to 255
    Hsv,   ///< hue 0 to 360, saturation and value 0 to 100 %
    Oklch  ///< lightness 0 to 100 %, chroma 0 to 0.4, hue 0 to 360 (Ottosson 2020)
};

using Channels = std::array<double, 3>;

struct ChannelText {
    const char* letter;
    const char* name;
    double most;  ///< from 0
    int decimals;
};

using ChannelTexts = std::array<ChannelText, 3>;

const ChannelTexts& channels_of(ColourModel model);

/// Greys have hue 0.
Channels channels_from(ColourModel model, const pigment::Srgb8& colour);

/// A colour of Oklch outside sRGB is brought in, half by clipping and half by greying.
pigment::Srgb8 colour_from(ColourModel model, const Channels& channels);

/// Lightness 0 to 1, a and b of OKLab, in which equal distances look alike (Ottosson 2020).
Channels oklab(const pigment::Srgb8& colour);

/// The colour of a screen nearest to it.
pigment::Srgb8 colour_of_oklab(const Channels& lab);

/// An angle brought to 0 to 360, 360 itself left out.
double turned_deg(double angle_deg);

/// Whether sRGB has the colour of these channels of Oklch, without bringing anything in.
bool in_srgb(const Channels& oklch);

/// The most chroma that sRGB has at a lightness, %, and a hue, degrees; to 1e-4. 0 where it has none.
double most_chroma(double lightness, double hue_deg);

}  // namespace pastoso::tools
