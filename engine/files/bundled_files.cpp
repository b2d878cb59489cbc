#include "files/bundled_files.hpp"

#include "core/error.hpp"
#include "core/looking.hpp"
#include "core/resources.hpp"
#include "core/text.hpp"
#include "core/text_file.hpp"

namespace pastoso::files {

namespace fs = std::filesystem;

std::vector<std::string> bundled_names(const std::string& folder) {
    std::vector<std::string> names;
    for (const fs::path& file : core::files_in(core::resource_path(folder), ".json"))
        names.push_back(file.stem().string());
    return names;
}

fs::path scene_path(const std::string& path_or_name, const std::string& folder) {
    const fs::path path = path_or_name;
    if (path.has_extension() || path.has_parent_path() || core::is_there(path)) return path;
    const fs::path bundled = core::resource_path(folder) / (path_or_name + ".json");
    if (!core::is_there(bundled)) {
        throw core::InputError("There is no scene \"%1\"; give a file ending in .json, or one of: %2.",
                               path_or_name, core::listed(bundled_names(folder)));
    }
    return bundled;
}

}  // namespace pastoso::files
