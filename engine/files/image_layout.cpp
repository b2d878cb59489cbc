#include "files/image_layout.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <algorithm>

namespace pastoso::files {
namespace {

struct Format {
    const char* extension;
    const char* name;
    int most_px;  ///< of a side
    bool holds_uint8, holds_uint16, holds_half, holds_single;
};
constexpr int kAnySide = 1 << 30;
constexpr Format kFormats[] = {
    {".png", "png", kAnySide, true, true, false, false},
    {".tif", "tiff", kAnySide, true, true, false, true},
    {".tiff", "tiff", kAnySide, true, true, false, true},
    {".jpg", "jpeg", 65500, true, false, false, false},
    {".jpeg", "jpeg", 65500, true, false, false, false},
    {".webp", "webp", 16383, true, false, false, false},
    {".exr", "openexr", kAnySide, false, false, true, true},
};

const Format& format_of(const std::filesystem::path& path) {
    const std::string extension = core::lower_case(path.extension().string());
    for (const Format& format : kFormats) {
        if (extension == format.extension) return format;
    }
    throw core::InputError(
        path.string() +
        ": a picture is saved as .png, .tif, .jpg, .webp or .exr; this name ends in none of them.");
}

bool holds(const Format& format, Sample sample) {
    if (sample == Sample::Uint8) return format.holds_uint8;
    if (sample == Sample::Uint16) return format.holds_uint16;
    return sample == Sample::Half ? format.holds_half : format.holds_single;
}

const char* describe(Sample sample) {
    if (sample == Sample::Uint8) return "8-bit";
    if (sample == Sample::Uint16) return "16-bit";
    return sample == Sample::Half ? "linear" : "single-precision";
}

}  // namespace

void check_layout(const std::filesystem::path& path, const ImageLayout& layout) {
    const Format& format = format_of(path);
    if (!holds(format, layout.sample)) {
        throw core::InputError(path.string() + ": " + format.extension + " files do not hold " +
                               describe(layout.sample) + " pictures.");
    }
    check_picture_size(path, layout.width, layout.height);
}

void check_picture_size(const std::filesystem::path& path, int width, int height) {
    const Format& format = format_of(path);
    if (std::max(width, height) <= format.most_px) return;
    throw core::InputError(path.string() + ": " + format.extension + " files hold at most " +
                           std::to_string(format.most_px) + " pixels a side; this picture has " +
                           std::to_string(width) + " x " + std::to_string(height) + ".");
}

bool is_linear_format(const std::filesystem::path& path) {
    return format_of(path).holds_half;
}

bool holds(const std::filesystem::path& path, Sample sample) {
    return holds(format_of(path), sample);
}

const char* format_name(const std::filesystem::path& path) {
    return format_of(path).name;
}

}  // namespace pastoso::files
