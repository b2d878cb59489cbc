#include "files/psd_file.hpp"

#include "core/error.hpp"
#include "core/units.hpp"
#include "files/byte_order.hpp"
#include "files/colour_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pastoso::files {
namespace {

constexpr std::size_t kLargestFile = (std::size_t{1} << 31) - 1;
constexpr int kColours = 3;
constexpr std::uint32_t kRgb = 3, kBits = 8, kPacked = 1;
constexpr std::uint32_t kCoverChannel = 0xFFFF;

std::string short_number(std::uint32_t value) {
    return big_endian(value, 2);
}

/// Behind its own length.
std::string counted(const std::string& bytes) {
    return big_endian(static_cast<std::uint32_t>(bytes.size())) + bytes;
}

std::string padded(std::string bytes, std::size_t multiple) {
    bytes.resize((bytes.size() + multiple - 1) / multiple * multiple, '\0');
    return bytes;
}

/// One of the values of all pixels, `stride` apart, packed row by row.
struct PackedChannel {
    std::string lengths;  ///< of the rows
    std::string rows;

    std::size_t size() const { return lengths.size() + rows.size(); }
};

PackedChannel packed_channel(const std::vector<std::uint8_t>& values, int first, int stride, int width,
                             int height) {
    PackedChannel channel;
    std::string row(static_cast<std::size_t>(width), '\0');
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            row[static_cast<std::size_t>(x)] =
                static_cast<char>(values[static_cast<std::size_t>(first) +
                                         (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                          static_cast<std::size_t>(x)) *
                                             static_cast<std::size_t>(stride)]);
        const std::string packed = packed_bits(row);
        channel.lengths += short_number(static_cast<std::uint32_t>(packed.size()));
        channel.rows += packed;
    }
    return channel;
}

std::array<PackedChannel, kColours> packed_colours(const pigment::Image8& image) {
    std::array<PackedChannel, kColours> channels;
    for (int k = 0; k < kColours; ++k)
        channels[static_cast<std::size_t>(k)] =
            packed_channel(image.rgb, k, kColours, image.width, image.height);
    return channels;
}

PackedChannel packed_cover(const PsdLayer& layer, int width, int height) {
    if (!layer.cover.empty()) return packed_channel(layer.cover, 0, 1, width, height);
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return packed_channel(std::vector<std::uint8_t>(pixels, 255), 0, 1, width, height);
}

std::string resource(std::uint32_t number, const std::string& content) {
    const std::string no_name(2, '\0');
    return "8BIM" + short_number(number) + no_name + padded(counted(content), 2);
}

std::string resolution(double px_per_mm) {
    constexpr std::uint32_t kPerInch = 1, kInches = 1;
    const auto per_inch = static_cast<std::uint32_t>(std::lround(px_per_mm * core::kInch_mm * 65536.0));
    const std::string side = big_endian(per_inch) + short_number(kPerInch) + short_number(kInches);
    return side + side;
}

/// The letters of UTF-8 in UTF-16, what is no UTF-8 left out.
std::u16string utf16(const std::string& text) {
    std::u16string letters;
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i]);
        const std::size_t count = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
        if (i + count > text.size()) break;
        std::uint32_t letter = count == 1 ? first : first & (0x7FU >> count);
        for (std::size_t k = 1; k < count; ++k)
            letter = letter << 6U | (static_cast<unsigned char>(text[i + k]) & 0x3FU);
        i += count;
        if (letter < 0x10000) {
            letters += static_cast<char16_t>(letter);
        } else {
            letters += static_cast<char16_t>(0xD7C0U + (letter >> 10U));
            letters += static_cast<char16_t>(0xDC00U + (letter & 0x3FFU));
        }
    }
    return letters;
}

std::string unicode_name(const std::string& name) {
    const std::u16string letters = utf16(name);
    std::string content = big_endian(static_cast<std::uint32_t>(letters.size()));
    for (const char16_t letter : letters)
        content += short_number(letter);
    return "8BIMluni" + counted(padded(content, 4));
}

std::string plain_name(const std::string& name) {
    const std::string start = name.substr(0, 255);
    return padded(std::string(1, static_cast<char>(start.size())) + start, 4);
}

/// What is said of a layer before the pixels of all.
std::string record(const PsdLayer& layer, const std::array<PackedChannel, kColours>& colours,
                   const PackedChannel& cover) {
    constexpr std::uint32_t kHidden = 2, kFlagsHold = 8, kOpaque = 255, kChannels = 4;
    const auto channel = [](std::uint32_t id, const PackedChannel& packed) {
        return short_number(id) + big_endian(static_cast<std::uint32_t>(packed.size() + 2));
    };
    std::string bytes =
        big_endian(0) + big_endian(0) + big_endian(static_cast<std::uint32_t>(layer.picture.height)) +
        big_endian(static_cast<std::uint32_t>(layer.picture.width)) + short_number(kChannels);
    for (std::uint32_t k = 0; k < kColours; ++k)
        bytes += channel(k, colours[k]);
    bytes += channel(kCoverChannel, cover) + "8BIMnorm" + big_endian(kOpaque, 1) + big_endian(0, 1) +
             big_endian(kFlagsHold | (layer.visible ? 0 : kHidden), 1) + big_endian(0, 1);
    const std::string no_mask = big_endian(0), no_ranges = big_endian(0);
    return bytes + counted(no_mask + no_ranges + plain_name(layer.name) + unicode_name(layer.name));
}

/// How many layers, what each is, and their pixels.
std::string layer_section(const std::vector<PsdLayer>& layers) {
    std::string records = short_number(static_cast<std::uint32_t>(layers.size())), pixels;
    for (const PsdLayer& layer : layers) {
        const auto colours = packed_colours(layer.picture);
        const PackedChannel cover = packed_cover(layer, layer.picture.width, layer.picture.height);
        records += record(layer, colours, cover);
        for (const PackedChannel* channel : {&colours[0], &colours[1], &colours[2], &cover})
            pixels += short_number(kPacked) + channel->lengths + channel->rows;
    }
    const std::string no_global_mask = big_endian(0);
    return counted(padded(records + pixels, 4)) + no_global_mask;
}

std::string merged_section(const pigment::Image8& merged) {
    const auto colours = packed_colours(merged);
    std::string bytes = short_number(kPacked);
    for (const PackedChannel& channel : colours)
        bytes += channel.lengths;
    for (const PackedChannel& channel : colours)
        bytes += channel.rows;
    return bytes;
}

void check_sides(const pigment::Image8& picture, const core::OutputFile& file) {
    if (std::max(picture.width, picture.height) > kLongestPsd_px)
        throw core::InputError("%1: %2 x %3 pixels are more than the %4 a side that a PSD file holds.",
                               file.path().string(), picture.width, picture.height, kLongestPsd_px);
}

}  // namespace

std::string packed_bits(const std::string& row) {
    constexpr std::size_t kMost = 128, kLeastRun = 3;
    const auto run_at = [&row](std::size_t place) {
        std::size_t end = place + 1;
        while (end < row.size() && end - place < kMost && row[end] == row[place])
            ++end;
        return end - place;
    };
    std::string packed;
    for (std::size_t i = 0; i < row.size();) {
        if (const std::size_t run = run_at(i); run >= kLeastRun) {
            packed += static_cast<char>(257 - run);
            packed += row[i];
            i += run;
            continue;
        }
        std::size_t end = i + 1;
        while (end < row.size() && end - i < kMost && run_at(end) < kLeastRun)
            ++end;
        packed += static_cast<char>(end - i - 1);
        packed.append(row, i, end - i);
        i = end;
    }
    return packed;
}

void write_psd(const PsdPicture& picture, core::OutputFile& file) {
    check_sides(picture.merged, file);
    constexpr std::uint32_t kVersion = 1, kResolution = 0x03ED, kProfile = 0x040F;
    const std::string no_colour_table = big_endian(0);
    const std::string head = "8BPS" + short_number(kVersion) + std::string(6, '\0') +
                             short_number(kColours) +
                             big_endian(static_cast<std::uint32_t>(picture.merged.height)) +
                             big_endian(static_cast<std::uint32_t>(picture.merged.width)) +
                             short_number(kBits) + short_number(kRgb) + no_colour_table;
    const std::string resources = counted(resource(kResolution, resolution(picture.px_per_mm)) +
                                          resource(kProfile, icc_profile(pigment::WorkingSpace::Srgb)));
    const std::string layers = layer_section(picture.layers);
    const std::string merged = merged_section(picture.merged);
    if (head.size() + resources.size() + layers.size() + merged.size() > kLargestFile)
        throw core::InputError("%1: a PSD file of these layers would be larger than 2 GB.",
                               file.path().string());
    for (const std::string& part : {head, resources, counted(layers), merged})
        file.append(part);
}

}  // namespace pastoso::files
