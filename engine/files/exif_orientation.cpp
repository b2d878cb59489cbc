#include "files/exif_orientation.hpp"

#include "files/byte_order.hpp"

#include <cstddef>
#include <cstdint>

namespace pastoso::files {

int exif_orientation(std::string_view exif) {
    constexpr std::size_t kEntryBytes = 12;
    constexpr std::uint32_t kOrientation = 274;
    const bool is_big_endian = exif.starts_with("MM");
    if (!is_big_endian && !exif.starts_with("II")) return 1;
    const auto number = [&](std::size_t place, std::size_t bytes) -> std::uint32_t {
        return is_big_endian ? big_endian_at(exif, place, bytes) : little_endian_at(exif, place, bytes);
    };
    const std::size_t directory = number(4, 4);
    const std::uint32_t entries = number(directory, 2);
    for (std::uint32_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + kEntryBytes * i;
        if (entry >= exif.size()) break;
        if (number(entry, 2) != kOrientation) continue;
        const std::uint32_t orientation = number(entry + 8, 2);
        return orientation >= 1 && orientation <= 8 ? static_cast<int>(orientation) : 1;
    }
    return 1;
}

}  // namespace pastoso::files
