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
        "%1: a picture is saved as .png, .tif, .jpg, .webp or .exr; this name ends in none of them.",
        path.string());
}

bool holds(const Format& format, Sample sample) {
    if (sample == Sample::Uint8) return format.holds_uint8;
    if (sample == Sample::Uint16) return format.holds_uint16;
    return sample == Sample::Half ? format.holds_half : format.holds_single;
}

core::Message describe(Sample sample) {
    if (sample == Sample::Uint8) return core::message("8-bit pictures");
    if (sample == Sample::Uint16) return core::message("16-bit pictures");
    return sample == Sample::Half ? core::message("linear pictures")
                                  : core::message("single-precision pictures");
}

}  // namespace

void check_layout(const std::filesystem::path& path, const ImageLayout& layout) {
    const Format& format = format_of(path);
    if (!holds(format, layout.sample)) {
        throw core::InputError("%1: %2 files do not hold %3.", path.string(), format.extension,
                               describe(layout.sample));
    }
    check_picture_size(path, layout.width, layout.height);
}

void check_picture_size(const std::filesystem::path& path, int width, int height) {
    const Format& format = format_of(path);
    if (std::max(width, height) <= format.most_px) return;
    throw core::InputError("%1: %2 files hold at most %3 pixels a side; this picture has %4 x %5.",
                           path.string(), format.extension, format.most_px, width, height);
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
