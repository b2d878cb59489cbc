#include "files/png_chunks.hpp"

#include "core/check.hpp"
#include "files/byte_order.hpp"

#include <array>
#include <cstdint>

namespace pastoso::files {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kTypeBytes = 4;

/// Around a chunk's data: its length, its type and its checksum.
constexpr std::size_t kFrameBytes = 4 + kTypeBytes + 4;

constexpr std::array<std::uint32_t, 256> crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t value = byte;
        for (int bit = 0; bit < 8; ++bit)
            value = value & 1U ? 0xEDB88320U ^ (value >> 1) : value >> 1;
        table[byte] = value;
    }
    return table;
}
constexpr std::array<std::uint32_t, 256> kCrcTable = crc_table();

/// The cyclic redundancy check of ISO 3309, as PNG uses it.
std::uint32_t crc(std::string_view bytes) {
    std::uint32_t value = 0xFFFFFFFFU;
    for (const char byte : bytes)
        value = kCrcTable[(value ^ static_cast<unsigned char>(byte)) & 0xFFU] ^ (value >> 8);
    return ~value;
}

}  // namespace

bool is_png(std::string_view file) {
    return file.starts_with(kSignature);
}

bool has_png_chunk(std::string_view file, std::string_view type) {
    if (!is_png(file)) return false;
    for (std::size_t place = kSignature.size(); place + kFrameBytes <= file.size();) {
        const std::string_view here = file.substr(place + 4, kTypeBytes);
        if (here == type) return true;
        if (here == "IDAT") return false;
        place += kFrameBytes + big_endian_at(file, place);
    }
    return false;
}

std::string with_png_chunk(std::string_view file, std::string_view type, std::string_view data) {
    PASTOSO_CHECK(is_png(file));
    PASTOSO_CHECK_OP(type.size(), ==, kTypeBytes);
    const std::size_t place = kSignature.size() + kFrameBytes + big_endian_at(file, kSignature.size());
    const std::string named = std::string(type) + std::string(data);
    std::string result(file.substr(0, place));
    result += big_endian(static_cast<std::uint32_t>(data.size())) + named + big_endian(crc(named));
    result += file.substr(place);
    return result;
}

}  // namespace pastoso::files
