#include "files/picture_format.hpp"

#include "files/byte_order.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace pastoso::files {
namespace {

using std::string_view_literals::operator""sv;

bool is_pnm(std::string_view head) {
    return head.size() > 2 && head[0] == 'P' && head[1] >= '1' && head[1] <= '6' &&
           (" \t\r\n#"sv.find(head[2]) != std::string_view::npos);
}

/// Targa has no mark of its own, but few headers are possible (Truevision TGA, version 2.0).
bool is_targa(std::string_view head) {
    constexpr std::size_t kHeaderBytes = 18;
    if (head.size() < kHeaderBytes) return false;
    const std::uint32_t palette = little_endian_at(head, 1, 1), type = little_endian_at(head, 2, 1);
    const std::uint32_t bits = little_endian_at(head, 16, 1);
    constexpr std::array<std::uint32_t, 6> kTypes = {1, 2, 3, 9, 10, 11};
    constexpr std::array<std::uint32_t, 5> kBits = {8, 15, 16, 24, 32};
    return palette <= 1 && std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end() &&
           std::find(kBits.begin(), kBits.end(), bits) != kBits.end() &&
           little_endian_at(head, 12, 2) > 0 && little_endian_at(head, 14, 2) > 0;
}

/// RFC 9649: of the extended format, of a lossless and of a lossy picture.
PictureSize webp_size(std::string_view head) {
    const std::string_view kind = head.substr(std::min<std::size_t>(12, head.size()), 4);
    if (kind == "VP8X")
        return {little_endian_at(head, 24, 3) + 1LL, little_endian_at(head, 27, 3) + 1LL};
    if (kind == "VP8L") {
        const std::uint32_t sides = little_endian_at(head, 21, 4);
        return {(sides & 0x3FFFU) + 1LL, (sides >> 14U & 0x3FFFU) + 1LL};
    }
    return {little_endian_at(head, 26, 2) & 0x3FFFU, little_endian_at(head, 28, 2) & 0x3FFFU};
}

/// Of OS/2 and of Windows; rows from the top have a negative height.
PictureSize bmp_size(std::string_view head) {
    constexpr std::uint32_t kOs2HeaderBytes = 12;
    if (little_endian_at(head, 14, 4) == kOs2HeaderBytes)
        return {little_endian_at(head, 18, 2), little_endian_at(head, 20, 2)};
    const auto side = [&](std::size_t place) {
        return std::abs(std::int64_t{static_cast<std::int32_t>(little_endian_at(head, place, 4))});
    };
    return {side(18), side(22)};
}

}  // namespace

PictureFormat picture_format(std::string_view head) {
    if (head.starts_with("\x89PNG\r\n\x1a\n")) return PictureFormat::Png;
    if (head.starts_with("\xff\xd8\xff")) return PictureFormat::Jpeg;
    for (const std::string_view mark : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv})
        if (head.starts_with(mark)) return PictureFormat::Tiff;
    if (head.starts_with("RIFF") && head.substr(4).size() >= 8 && head.substr(8, 4) == "WEBP")
        return PictureFormat::WebP;
    if (head.starts_with("\x76\x2f\x31\x01")) return PictureFormat::OpenExr;
    if (head.starts_with("#?RADIANCE") || head.starts_with("#?RGBE")) return PictureFormat::Hdr;
    if (head.starts_with("BM") && little_endian_at(head, 14, 4) >= 12) return PictureFormat::Bmp;
    if (head.starts_with("GIF87a") || head.starts_with("GIF89a")) return PictureFormat::Gif;
    if (head.starts_with("8BPS")) return PictureFormat::Psd;
    if (is_pnm(head)) return PictureFormat::Pnm;
    return is_targa(head) ? PictureFormat::Targa : PictureFormat::None;
}

const char* reader_name(PictureFormat format) {
    switch (format) {
        case PictureFormat::Png:
            return "png";
        case PictureFormat::Jpeg:
            return "jpeg";
        case PictureFormat::Tiff:
            return "tiff";
        case PictureFormat::WebP:
            return "webp";
        case PictureFormat::OpenExr:
            return "openexr";
        case PictureFormat::Hdr:
            return "hdr";
        case PictureFormat::Bmp:
            return "bmp";
        case PictureFormat::Gif:
            return "gif";
        case PictureFormat::Psd:
            return "psd";
        case PictureFormat::Pnm:
            return "pnm";
        case PictureFormat::Targa:
            return "targa";
        case PictureFormat::None:
            break;
    }
    return "";
}

PictureSize told_size(PictureFormat format, std::string_view head) {
    switch (format) {
        case PictureFormat::WebP:
            return webp_size(head);
        case PictureFormat::Gif:
            return {little_endian_at(head, 6, 2), little_endian_at(head, 8, 2)};
        case PictureFormat::Bmp:
            return bmp_size(head);
        case PictureFormat::Psd:
            return {big_endian_at(head, 18, 4), big_endian_at(head, 14, 4)};
        case PictureFormat::Targa:
            return {little_endian_at(head, 12, 2), little_endian_at(head, 14, 2)};
        default:
            return {};
    }
}

}  // namespace pastoso::files
