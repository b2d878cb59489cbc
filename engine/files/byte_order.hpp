// Numbers as picture files hold them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pastoso::files {

/// The number that stands at `place` in so many bytes (1 to 4), the least significant one first; 0 where
/// the bytes end before it.
inline std::uint32_t little_endian_at(std::string_view bytes, std::size_t place, std::size_t count = 4) {
    if (place > bytes.size() || count > bytes.size() - place) return 0;
    std::uint32_t value = 0;
    for (std::size_t i = count; i-- > 0;)
        value = value << 8U | static_cast<unsigned char>(bytes[place + i]);
    return value;
}

/// The same with the most significant byte first.
inline std::uint32_t big_endian_at(std::string_view bytes, std::size_t place, std::size_t count = 4) {
    if (place > bytes.size() || count > bytes.size() - place) return 0;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i)
        value = value << 8U | static_cast<unsigned char>(bytes[place + i]);
    return value;
}

/// A number in so many bytes (1 to 4), the least significant one first.
inline std::string little_endian(std::uint32_t value, std::size_t count = 4) {
    std::string bytes;
    for (std::size_t i = 0; i < count; ++i)
        bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
    return bytes;
}

/// The same with the most significant byte first.
inline std::string big_endian(std::uint32_t value, std::size_t count = 4) {
    const std::string reversed = little_endian(value, count);
    return {reversed.rbegin(), reversed.rend()};
}

}  // namespace pastoso::files
