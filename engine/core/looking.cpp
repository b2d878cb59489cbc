#include "core/looking.hpp"

#include <system_error>

namespace pastoso::core {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) noexcept {
    std::error_code unseen;
    return fs::exists(path, unseen);
}

bool is_folder(const fs::path& path) noexcept {
    std::error_code unseen;
    return fs::is_directory(path, unseen);
}

bool is_regular_file(const fs::path& path) noexcept {
    std::error_code unseen;
    return fs::is_regular_file(path, unseen);
}

std::vector<fs::path> entries_of(const fs::path& folder) {
    std::vector<fs::path> entries;
    std::error_code failure;
    fs::directory_iterator entry(folder, failure);
    for (; !failure && entry != fs::directory_iterator(); entry.increment(failure))
        entries.push_back(entry->path());
    return entries;
}

fs::path absolute_path(const fs::path& path) {
    std::error_code failure;
    fs::path absolute = fs::absolute(path, failure);
    return failure ? path : absolute;
}

}  // namespace pastoso::core
