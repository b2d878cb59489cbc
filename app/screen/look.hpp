// What the canvas shows in place of the lit paint, while the painter asks for it.
#pragma once

#include <array>

namespace pastoso::screen {

enum class Look {
    Lit,      ///< as it hangs in its light
    Wet,      ///< how thick the paint is that is still wet, as a tint over a grey picture
    Height,   ///< how high the paint stands above the bare canvas, in steps of colour
    Normals,  ///< where the surface faces: red right, green up, blue out, as exported normals
    Flat,     ///< the paint's colours under even light, without relief
};

/// Whether a look shows where wet paint ends.
bool has_outlines(Look look);

/// The steps of Look::Height from the canvas up, dark to light, encoded as the screen shows them.
using Rgb = std::array<float, 3>;
inline constexpr int kHeightSteps = 10;
extern const std::array<Rgb, kHeightSteps> kHeightColours;

/// Look::Wet: thinner paint has no tint; from the thickest on it is full. Between them every doubling
/// adds as much.
inline constexpr double kThinnestWet_mm = 0.005, kThickestWet_mm = 2.0;
inline constexpr double kFullTint = 0.85;
extern const Rgb kWetTint;  ///< encoded

/// Of the grey picture below the tint: the share of its lightness.
inline constexpr double kGreyShare = 0.7;

/// The share of the tint, 0 to kFullTint.
double wet_tint(double wet_mm);

/// The height at which the scale of Look::Height ends: 1, 2 or 5 times a power of ten, at least a tenth
/// of a millimetre.
double scale_top_mm(double highest_mm);

}  // namespace pastoso::screen
