// What all programs have in common that follow a ray for each pixel.
#pragma once

namespace pastoso::glass {

/// One triangle that covers the picture.
extern const char* const kRayVertexShader;

/// Before the words of a program: the camera, light, tone and Fresnel's law.
extern const char* const kLightShader;

/// After them: main(), which calls
///     vec3 trace(vec3 from, vec3 way, float grain_here).
extern const char* const kMainShader;

}  // namespace pastoso::glass
