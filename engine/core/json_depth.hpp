// How deep JSON may be nested.
#pragma once

#include <string>
#include <string_view>

namespace pastoso::core {

/// Deeper than any format of ours.
inline constexpr int kDeepestJson = 64;

/// Throws InputError "FILE: ..." where lists and objects stand deeper within each other than that: a
/// malicious file may nest deeper than the stack of those who go through it. What is no JSON may pass.
void check_json_depth(std::string_view text, const std::string& file);

}  // namespace pastoso::core
