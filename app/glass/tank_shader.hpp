// The program that shows a tank of liquid on the graphics card.
#pragma once

namespace pastoso::glass {

/// A ray for each pixel: through the plates of glass and the liquid, whose surface is the zero of a
/// distance, to solids, the table or the sky. It stands between kLightShader and kMainShader.
extern const char* const kTankShader;

}  // namespace pastoso::glass
