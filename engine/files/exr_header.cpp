#include "files/exr_header.hpp"

#include "core/error.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <string>

namespace pastoso::files {
namespace {

/// Little-endian; 0 at the end of the file.
std::uint32_t read_word(std::ifstream& file) {
    std::array<unsigned char, 4> bytes{};
    file.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
    return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

std::string read_name(std::ifstream& file) {
    std::string name;
    std::getline(file, name, '\0');
    return name;
}

/// Name, type, size and value of every attribute until an empty name.
void check_attributes(std::ifstream& file, std::uint64_t file_bytes, const std::string& path) {
    for (std::string name = read_name(file); file && !name.empty(); name = read_name(file)) {
        read_name(file);
        const std::uint32_t size = read_word(file);
        const auto here = static_cast<std::int64_t>(file.tellg());
        if (here < 0) return;
        if (size > file_bytes - static_cast<std::uint64_t>(here))
            throw core::InputError(path + ": is damaged (its header reaches beyond the end).");
        file.seekg(size, std::ios::cur);
    }
}

}  // namespace

void check_exr_header(const std::filesystem::path& path) {
    constexpr std::uint32_t kMagic = 20000630, kMultiPart = 0x1000;
    std::ifstream file(path, std::ios::binary);
    if (read_word(file) != kMagic) return;
    const std::uint64_t file_bytes = std::filesystem::file_size(path);
    const bool multi_part = (read_word(file) & kMultiPart) != 0;
    // The headers of several parts are ended by an empty one.
    do {
        check_attributes(file, file_bytes, path.string());
    } while (multi_part && file && file.peek() > 0);
}

}  // namespace pastoso::files
