#include "tools/export_names.hpp"

#include "core/looking.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace pastoso::tools {
namespace {

using Path = std::filesystem::path;

/// In small letters, and of two names of one ending the one that the formats have.
std::string ending_of(const Path& path) {
    const std::string ending = core::lower_case(path.extension().string());
    if (ending == ".tiff") return ".tif";
    return ending == ".jpeg" ? ".jpg" : ending;
}

bool is_known(const std::string& ending) {
    if (ending.empty()) return false;
    for (std::size_t form = 0; form < kExportForms; ++form) {
        for (const ExportFormat& format : export_formats(static_cast<ExportForm>(form)))
            if (ending == format.ending) return true;
    }
    return false;
}

}  // namespace

Path with_ending(const Path& path, const ExportFormat& format) {
    const std::string ending = ending_of(path);
    if (ending == format.ending) return path;
    Path result = path;
    if (is_known(ending)) result.replace_extension();
    return result += format.ending;
}

std::optional<std::size_t> format_of(const Path& path, ExportForm form, std::size_t present) {
    const std::string ending = ending_of(path);
    if (ending.empty()) return {};
    const auto formats = export_formats(form);
    if (ending == formats[present].ending) return present;
    for (std::size_t i = 0; i < formats.size(); ++i)
        if (ending == formats[i].ending) return i;
    return {};
}

bool is_taken(const Path& path, ExportForm form) {
    const std::vector<Path> files =
        form == ExportForm::Maps ? recordings::map_paths(path) : std::vector<Path>{path};
    return std::any_of(files.begin(), files.end(), core::is_there);
}

Path untaken(const Path& path, ExportForm form) {
    Path result = path;
    for (int number = 2; is_taken(result, form); ++number)
        result = path.parent_path() /
                 (path.stem().string() + "-" + std::to_string(number) + path.extension().string());
    return result;
}

}  // namespace pastoso::tools
