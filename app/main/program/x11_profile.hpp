// The profile that a display of X11 has on its root window, where no colord tells of one.
#pragma once

#include <string>

namespace pastoso::main {

/// The bytes of `_ICC_PROFILE` (freedesktop.org, ICC Profiles in X), which is the first screen's; empty
/// where there is none, and on other displays.
std::string x11_profile();

}  // namespace pastoso::main
