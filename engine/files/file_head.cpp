#include "files/file_head.hpp"

#include "core/regular_file.hpp"

namespace pastoso::files {

std::string file_head(const std::filesystem::path& path, std::size_t bytes) {
    return core::RegularFile(path).text_at(0, bytes);
}

}  // namespace pastoso::files
