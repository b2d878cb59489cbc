// Controls in a tool bar that stands upright.
#pragma once

namespace pastoso::panels {

/// Of the widest of them.
inline constexpr int kUprightWidth_px = 68;

}  // namespace pastoso::panels
