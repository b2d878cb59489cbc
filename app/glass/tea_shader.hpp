// What stands in the programs that show a glass of milk tea (glass/ray_program.hpp).
#pragma once

namespace pastoso::glass {

/// The cup and its inner and outer wall, before either of these:
extern const char* const kCupShader;

/// The light that arrives at the places of a layer of the tea, with its own main().
extern const char* const kTeaLightShader;

/// Rays are refracted by glass and tea and go through milk, to the table or the sky.
extern const char* const kTeaShader;

}  // namespace pastoso::glass
