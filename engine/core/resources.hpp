// Where the program's own data lies.
#pragma once

#include <filesystem>

namespace pastoso::core {

/// The folder that the running program was started from (its executable's folder).
std::filesystem::path program_folder();

/// The folder that holds the program's share/pastoso and lib/pastoso: the one above program_folder(), or
/// the one that set_installed_prefix() has named.
std::filesystem::path installed_prefix();

/// For programs of others that load the engine, whose own folder tells nothing of it. Before anything is
/// read, and while no other thread reads.
void set_installed_prefix(const std::filesystem::path& prefix);

/// The path of a bundled file, for example resource_path("pigments/pigments.csv"). The folder is, in
/// this order: the environment variable PASTOSO_RESOURCES; share/pastoso below installed_prefix().
/// Throws InputError when the file is not there.
std::filesystem::path resource_path(const std::filesystem::path& relative);

}  // namespace pastoso::core
