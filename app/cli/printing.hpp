// What subcommands say: names and texts come from files of any origin.
#pragma once

#include <string>

namespace pastoso::cli {

/// std::printf(), with what could command a terminal shown instead (core/printable.hpp).
[[gnu::format(printf, 1, 2)]] void print(const char* format, ...);

/// "pastoso-cli: SENTENCE" on the error stream, shown in the same way.
void complain(const std::string& sentence);

/// Throws InputError where what was printed did not all arrive.
void finish_printing();

}  // namespace pastoso::cli
