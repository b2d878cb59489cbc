#include "files/file_access.hpp"

#include "core/error.hpp"
#include "core/output_file.hpp"
#include "core/regular_file.hpp"

#include <cerrno>
#include <cstring>
#include <string>
#include <sys/stat.h>

namespace pastoso::files {
void check_readable(const std::filesystem::path& path) {
    core::RegularFile{path};
}

void check_writable(const std::filesystem::path& path) {
    const core::OutputFile trial(path);
}

void make_folder(const std::filesystem::path& folder) {
    if (::mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST)
        throw core::InputError("%1: cannot be created (%2).", folder.string(), std::strerror(errno));
    check_writable(folder / "file");
}

}  // namespace pastoso::files
