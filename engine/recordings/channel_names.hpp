// Names of layers in files whose channels have names.
#pragma once

#include <string>
#include <vector>

namespace pastoso::recordings {

/// What the bare support's own channels begin with; no layer is called that.
inline constexpr const char* kSupportChannels = "support";

/// The names of layers as every program takes them: letters and digits of ASCII and _, no digit first,
/// cut to 60 bytes, no two alike whatever the case. Where nothing is left of a name, "layer_" and the
/// layer's number stand for it, counted from 1.
std::vector<std::string> channel_names(const std::vector<std::string>& names);

}  // namespace pastoso::recordings
