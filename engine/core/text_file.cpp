#include "core/text_file.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/looking.hpp"
#include "core/output_file.hpp"
#include "core/regular_file.hpp"

namespace pastoso::core {

std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes) {
    const RegularFile file(path);
    if (file.bytes() > max_bytes) {
        throw InputError("%1: is larger than the %2 bytes that are read at most.", path.string(),
                         max_bytes);
    }
    const auto size = static_cast<std::size_t>(file.bytes());
    std::string text = file.text_at(0, size);
    if (text.size() < size) throw InputError("%1: cannot be read to its end.", path.string());
    return text;
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, std::string_view extension) {
    std::vector<std::filesystem::path> files;
    for (std::filesystem::path& path : entries_of(folder)) {
        if (path.extension() == extension) files.push_back(std::move(path));
    }
    std::sort(files.begin(), files.end());
    return files;
}

void write_text_file(const std::filesystem::path& path, std::string_view text) {
    write_aside(path, [&](OutputFile& file) { file.append(text); });
}

}  // namespace pastoso::core
