// A symmetry as painters set it: which mirrors stand on the canvas.
#pragma once

#include "brush/symmetry.hpp"

namespace pastoso::tools {

/// Both may stand where the symmetry is turned: "upright" is what stood so before.
struct Mirrors {
    bool upright = false;  ///< left and right are alike
    bool level = false;    ///< above and below are alike
    friend bool operator==(const Mirrors&, const Mirrors&) = default;
};

/// With an even number of copies a mirror brings the one across it along.
Mirrors mirrors_of(const brush::Symmetry& symmetry);

/// The symmetry with these mirrors, at the same place and turned as before. Two of them alone are two
/// copies with a mirror; around more copies they are the same mirror.
brush::Symmetry with_mirrors(brush::Symmetry symmetry, const Mirrors& wanted);

}  // namespace pastoso::tools
