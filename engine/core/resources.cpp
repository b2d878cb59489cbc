#include "core/resources.hpp"

#include <cstdlib>

#include "core/error.hpp"
#include "core/looking.hpp"

namespace pastoso::core {
namespace {

std::filesystem::path& named_prefix() {
    static std::filesystem::path prefix;
    return prefix;
}

}  // namespace

std::filesystem::path program_folder() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

std::filesystem::path installed_prefix() {
    return named_prefix().empty() ? program_folder().parent_path() : named_prefix();
}

void set_installed_prefix(const std::filesystem::path& prefix) {
    named_prefix() = prefix;
}

std::filesystem::path resource_path(const std::filesystem::path& relative) {
    const char* override_folder = std::getenv("PASTOSO_RESOURCES");
    const std::filesystem::path folder = override_folder != nullptr
                                             ? std::filesystem::path(override_folder)
                                             : installed_prefix() / "share" / "pastoso";
    std::filesystem::path path = folder / relative;
    if (!is_there(path)) {
        throw InputError(
            "%1: this file of the program itself is missing; reinstall it or set PASTOSO_RESOURCES to "
            "the "
            "folder that holds it.",
            path.string());
    }
    return path;
}

}  // namespace pastoso::core
