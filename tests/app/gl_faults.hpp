// An OpenGL driver that is worse than the one there is: Qt asks this program for the driver's functions
// before it asks the driver (tests/app/CMakeLists.txt exports them).
#pragma once

namespace pastoso::tests {

struct GlFaults {
    int largest_texture = 0;     ///< a side, in texels; 0: the driver's own
    bool out_of_memory = false;  ///< where a texture is made
    bool reset = false;          ///< the card was
};

/// Those from now on.
GlFaults& gl_faults();

}  // namespace pastoso::tests
