#include "files/file_head.hpp"

#include "core/error.hpp"
#include "core/text_file.hpp"

#include <fstream>

namespace pastoso::files {
namespace {

std::ifstream opened(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw core::InputError(path.string() + ": cannot be opened.");
    return stream;
}

}  // namespace

std::string file_head(const std::filesystem::path& path, std::size_t bytes) {
    std::ifstream stream = opened(path);
    std::string head(bytes, '\0');
    stream.read(head.data(), static_cast<std::streamsize>(bytes));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    return head;
}

void replace_head(const std::filesystem::path& path, std::size_t replaced, std::string_view head) {
    core::write_aside(path, [&](const std::filesystem::path& temporary) {
        std::ifstream source = opened(path);
        source.seekg(static_cast<std::streamoff>(replaced));
        std::ofstream target(temporary, std::ios::binary);
        target.write(head.data(), static_cast<std::streamsize>(head.size()));
        target << source.rdbuf();
        target.flush();
        if (!target || source.bad())
            throw core::InputError(path.string() + ": cannot be written (the disk may be full).");
    });
}

}  // namespace pastoso::files
