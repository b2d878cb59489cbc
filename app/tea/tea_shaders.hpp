// The programs that show a glass of milk tea on the graphics card.
#pragma once

namespace pastoso::tea {

/// The milk's surface: its normal and how far it lies before the eye.
extern const char* const kMilkVertexShader;
extern const char* const kMilkFragmentShader;

/// One triangle that covers the picture, and a ray for each pixel: refracted by glass and tea, through
/// dissolved milk to the milk's surface, the table or the sky.
extern const char* const kGlassVertexShader;
extern const char* const kGlassFragmentShader;

}  // namespace pastoso::tea
