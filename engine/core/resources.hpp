// Where the program's own data lies.
#pragma once

#include <filesystem>

namespace pastoso::core {

/// The folder that the running program was started from (its executable's folder).
std::filesystem::path program_folder();

/// The path of a bundled file, for example resource_path("pigments/pigments.csv"). The folder is, in this
/// order: the environment variable PASTOSO_RESOURCES; ../share/pastoso beside the program's folder.
/// Throws InputError when the file is not there.
std::filesystem::path resource_path(const std::filesystem::path& relative);

}  // namespace pastoso::core
