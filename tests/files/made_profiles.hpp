// ICC profiles whose colours are known in closed form.
#pragma once

#include "files/colour_profile.hpp"

#include <array>

namespace pastoso::tests {

/// Of a screen with these primaries (chromaticities as in files::Chromaticities) and this gamma.
files::IccProfile made_monitor(const files::Chromaticities& xy, double gamma, const char* name = "made");

/// The primaries of sRGB, the red one in the place of the green one and the other way round.
files::Chromaticities swapped_primaries();

/// Of a printer of cyan, magenta, yellow and black on white paper. Its inks are impure: in encoded sRGB
/// a print has kInkPurity of their distance from the grey of the same mean. Colours beyond that get the
/// inks of the purest that there are.
inline constexpr double kInkPurity = 0.6;
files::IccProfile made_printer();

/// How a colour comes from it, both encoded in sRGB.
std::array<double, 3> printed(const std::array<double, 3>& colour);

}  // namespace pastoso::tests
