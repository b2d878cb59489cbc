// Writes down where the program was when it failed, so that the next start can show it to the painter.
#pragma once

#include <filesystem>
#include <string>

namespace pastoso::crash {

/// From now on a broken invariant, an exception that nobody caught, and the signals SIGSEGV, SIGBUS,
/// SIGFPE, SIGILL and SIGABRT leave a report of this run in `folder` before the program ends as it would
/// have without: `facts`, the reason, and the functions under way. The folder is made where there is
/// none; nothing is guarded where that cannot be. Once in a program.
void guard(const std::filesystem::path& folder, const std::string& facts);

/// More is known by now: the report has these facts instead.
void note_facts(const std::string& facts);

}  // namespace pastoso::crash
