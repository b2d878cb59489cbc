// The colours of a colour wheel, pixel by pixel.
#pragma once

#include <QImage>

namespace pastoso::panels {

/// The chroma at the right edge of the field: a little beyond what sRGB has of any hue.
inline constexpr double kFieldChroma = 0.33;

/// Lightness and chroma of the ring's colours: as strong as sRGB has them of nearly every hue.
inline constexpr double kRingLightness = 72.0, kRingChroma = 0.13;

/// A ring between two radii around the middle of a square of `side` pixels, its edges smooth: hue 0 to
/// the right, 90 above, as in diagrams of colour.
QImage hue_ring(int side, double inner, double outer);

/// Colours of one hue: chroma from 0 to kFieldChroma rightwards, lightness from 0 to 100 % upwards.
/// Transparent where sRGB has no such colour.
QImage colour_field(int side, double hue_deg);

/// All colours of one lightness, %, that sRGB has, on a disc of this radius around the middle of a
/// square of `side` pixels: hue and saturation as tools::disc_place() has them.
QImage hue_disc(int side, double radius, double lightness);

}  // namespace pastoso::panels
