// What helps to choose colours that go together.
#pragma once

#include "tools/gamut_mask.hpp"
#include "tools/harmony.hpp"

namespace pastoso::tools {

struct ColourAids {
    Harmony harmony = Harmony::None;
    GamutMask mask;
    friend bool operator==(const ColourAids&, const ColourAids&) = default;
};

}  // namespace pastoso::tools
