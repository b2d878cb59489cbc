#include "files/exr_header.hpp"

#include "files/byte_order.hpp"
#include "files/picture_rows.hpp"

#include <algorithm>
#include <cstdint>

namespace pastoso::files {
namespace {

/// The longest name and type that OpenEXR knows, with their ends.
constexpr std::size_t kNameBytes = 256;

/// The words of a file, from a place that goes forward.
struct Header {
    const core::RegularFile& file;
    std::uint64_t place = 0;

    /// 0 at the end of the file.
    std::uint32_t word_at(std::uint64_t byte) const {
        return little_endian_at(file.text_at(byte, 4), 0);
    }
    std::uint32_t word() {
        place += 4;
        return word_at(place - 4);
    }
    /// Up to its end, a zero.
    std::string name() {
        std::string text = file.text_at(place, kNameBytes);
        text.resize(std::min(text.find('\0'), text.size()));
        place += text.size() + 1;
        return text;
    }
};

/// Corners of boxes are both within them.
void check_window(const Header& header, const std::string& name) {
    const auto number = [&](unsigned i) {
        return static_cast<double>(static_cast<std::int32_t>(header.word_at(header.place + 4U * i)));
    };
    check_picture_size(name, number(2) - number(0) + 1.0, number(3) - number(1) + 1.0);
}

/// Each tile has an entry in a table that is made before one of them is read.
void check_tiles(const Header& header, const std::string& name) {
    constexpr std::uint32_t kLeastSide_px = 8;
    const std::uint32_t width = header.word_at(header.place), height = header.word_at(header.place + 4);
    if (width >= kLeastSide_px && height >= kLeastSide_px) return;
    throw picture_error(
        name,
        core::message("is stored in tiles of %1 x %2 pixels, but 8 a side are the least that are read.",
                      width, height));
}

/// Name, type, size and value of every attribute until an empty name.
void check_attributes(Header& header, const std::string& name) {
    for (std::string attribute = header.name(); !attribute.empty(); attribute = header.name()) {
        header.name();
        const std::uint32_t size = header.word();
        if (header.place > header.file.bytes() || size > header.file.bytes() - header.place)
            throw picture_error(name, core::message("is damaged (its header reaches beyond the end)."));
        if (attribute == "dataWindow") check_window(header, name);
        if (attribute == "tiles") check_tiles(header, name);
        header.place += size;
    }
}

}  // namespace

void check_exr_header(const core::RegularFile& file, const std::string& name) {
    constexpr std::uint32_t kMultiPart = 0x1000;
    Header header{file, 4};
    const bool multi_part = (header.word() & kMultiPart) != 0;
    // The headers of several parts are ended by an empty one.
    do {
        check_attributes(header, name);
    } while (multi_part && header.place < file.bytes() &&
             file.text_at(header.place, 1) != std::string(1, '\0'));
}

}  // namespace pastoso::files
