// Text of unknown origin, fit to be printed on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace pastoso::core {

/// The text with whatever could command a terminal shown instead of sent: each control character but the
/// line's end and the tabulator, and each byte that is no UTF-8, becomes "\x1b" and the like.
std::string printable(std::string_view text);

}  // namespace pastoso::core
