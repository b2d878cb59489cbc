// The programs that show a glass of milk tea on the graphics card.
#pragma once

namespace pastoso::glass {

/// What all that follow a ray for each pixel have in common: before their own words the camera, light,
/// tone and Fresnel's law; after them main(), which calls
///     vec3 trace(vec3 from, vec3 way, float grain_here).
extern const char* const kLightShader;
extern const char* const kMainShader;

/// One triangle that covers the picture, and a ray for each pixel: refracted by glass and tea, through
/// milk, to the table or the sky. The second stands between the two above.
extern const char* const kGlassVertexShader;
extern const char* const kGlassFragmentShader;

}  // namespace pastoso::glass
