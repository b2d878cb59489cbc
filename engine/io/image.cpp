#include "io/image.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "io/exr_header.hpp"
#include "io/files.hpp"
#include "io/images_library.hpp"
#include "io/png_chunks.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <string_view>

namespace pastoso::io {
namespace {

constexpr std::size_t kMaxPngBytes = std::size_t{1} << 34;

struct Format {
    const char* extension;
    const char* name;
    bool holds_uint8, holds_uint16, holds_linear;
};
constexpr Format kFormats[] = {
    {".png", "png", true, true, false},    {".tif", "tiff", true, true, false},
    {".tiff", "tiff", true, true, false},  {".jpg", "jpeg", true, false, false},
    {".jpeg", "jpeg", true, false, false}, {".exr", "openexr", false, false, true},
};

const Format& format_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    for (const Format& format : kFormats) {
        if (extension == format.extension) return format;
    }
    throw core::InputError(
        path.string() +
        ": a picture is saved as .png, .tif, .jpg or .exr; this name ends in none of them.");
}

bool holds(const Format& format, int sample_type) {
    if (sample_type == kPastosoUint8) return format.holds_uint8;
    return sample_type == kPastosoUint16 ? format.holds_uint16 : format.holds_linear;
}

const char* describe(int sample_type) {
    if (sample_type == kPastosoUint8) return "8-bit";
    if (sample_type == kPastosoData) return "single-precision";
    return sample_type == kPastosoUint16 ? "16-bit" : "linear";
}

/// The colours of a working space as PNG's cICP names them (ITU-T H.273): primaries of BT.709 or of
/// Display P3, the curve of sRGB, no matrix, full range.
std::string code_points(pigment::WorkingSpace space) {
    const char primaries = space == pigment::WorkingSpace::Srgb ? 1 : 12;
    return {primaries, 13, 0, 1};
}

/// `finish` is called with the name of the file as it was written, before it takes its place.
void write_pixels(const std::filesystem::path& path, PastosoPixels pixels,
                  const std::function<void(const std::filesystem::path&)>& finish = {}) {
    const Format& format = format_of(path);
    if (!holds(format, pixels.sample_type)) {
        throw core::InputError(path.string() + ": " + format.extension + " files do not hold " +
                               describe(pixels.sample_type) + " pictures.");
    }
    pixels.format = format.name;
    const ImagesLibrary& library = images_library();
    core::write_aside(path, [&](const std::filesystem::path& temporary) {
        std::array<char, 512> error{};
        if (library.write(&pixels, temporary.c_str(), error.data(), error.size()) != 0) {
            throw core::InputError(path.string() + ": " + error.data() + ".");
        }
        if (finish) finish(temporary);
    });
}

/// `values` are the image's, `channels` a pixel.
template <class Image, class Values>
PastosoPixels pixels_of(const Image& image, const Values& values, int channels, int sample_type,
                        double px_per_mm) {
    PASTOSO_CHECK_OP(values.size(), ==, std::size_t{1} * channels * image.width * image.height);
    PastosoPixels pixels{};
    pixels.data = values.data();
    pixels.width = image.width;
    pixels.height = image.height;
    pixels.channels = channels;
    pixels.sample_type = sample_type;
    pixels.px_per_mm = px_per_mm;
    pixels.software = "Pastoso";
    pixels.png_effort = 6;
    return pixels;
}
template <class Image>
PastosoPixels pixels_of(const Image& image, int sample_type, double px_per_mm) {
    return pixels_of(image, image.rgb, 3, sample_type, px_per_mm);
}

template <class Image>
void write_encoded(const std::filesystem::path& path, const Image& image, int sample_type,
                   double px_per_mm, const IccProfile& profile) {
    const IccProfile embedded = profile.empty() ? icc_profile(image.space) : profile;
    PastosoPixels pixels = pixels_of(image, sample_type, px_per_mm);
    pixels.icc_profile = embedded.data();
    pixels.icc_bytes = embedded.size();
    write_pixels(path, pixels, [&](const std::filesystem::path& written) {
        if (!profile.empty() || std::string_view(format_of(path).name) != "png") return;
        const std::string file = core::read_text_file(written, kMaxPngBytes);
        core::write_text_file(written, with_png_chunk(file, "cICP", code_points(image.space)));
    });
}

/// libpng passes over a damaged profile; the painter should hear of it.
bool has_unread_profile(const std::filesystem::path& path) {
    return has_png_chunk(core::read_text_file(path, kMaxPngBytes), "iCCP");
}

}  // namespace

void check_image_path(const std::filesystem::path& path) {
    format_of(path);
    check_writable(path);
}

std::string png_file(const shade::Image8& image, double px_per_mm) {
    const IccProfile profile = icc_profile(image.space);
    PastosoPixels pixels = pixels_of(image, kPastosoUint8, px_per_mm);
    pixels.icc_profile = profile.data();
    pixels.icc_bytes = profile.size();
    pixels.format = "png";
    pixels.png_effort = 2;
    const ImagesLibrary& library = images_library();
    PastosoFile file{};
    std::array<char, 512> error{};
    if (library.encode(&pixels, &file, error.data(), error.size()) != 0)
        throw core::InputError(std::string("A picture ") + error.data() + ".");
    const std::string bytes(file.bytes, file.count);
    library.free_file(&file);
    return with_png_chunk(bytes, "cICP", code_points(image.space));
}

bool is_linear_format(const std::filesystem::path& path) {
    return format_of(path).holds_linear;
}

bool holds_16_bits(const std::filesystem::path& path) {
    return format_of(path).holds_uint16;
}

void write_image(const std::filesystem::path& path, const shade::Image8& image, double px_per_mm,
                 const IccProfile& profile) {
    write_encoded(path, image, kPastosoUint8, px_per_mm, profile);
}

void write_image(const std::filesystem::path& path, const Image16& image, double px_per_mm,
                 const IccProfile& profile) {
    write_encoded(path, image, kPastosoUint16, px_per_mm, profile);
}

void write_image(const std::filesystem::path& path, const shade::LinearImage& image, double px_per_mm) {
    const Chromaticities chromaticities = chromaticities_of(image.space);
    PastosoPixels pixels = pixels_of(image, kPastosoFloat, px_per_mm);
    pixels.chromaticities = chromaticities.data();
    write_pixels(path, pixels);
}

void write_image(const std::filesystem::path& path, const GreyImage& image, double px_per_mm) {
    write_pixels(path, pixels_of(image, image.values, 1, kPastosoData, px_per_mm));
}

shade::LinearImage read_colour_image(const std::filesystem::path& path, pigment::WorkingSpace space) {
    check_readable(path);
    check_exr_header(path);
    const ImagesLibrary& library = images_library();
    PastosoColours colours{};
    std::array<char, 512> error{};
    if (library.read_colours(path.c_str(), &colours, error.data(), error.size()) != 0) {
        library.free_colours(&colours);
        throw core::InputError(path.string() + ": " + error.data() + ".");
    }
    shade::LinearImage image{colours.width, colours.height, {}, space};
    image.rgb.assign(colours.rgb, colours.rgb + std::size_t{3} * colours.width * colours.height);
    StoredColour stored;
    stored.linear = colours.is_linear != 0;
    if (colours.icc_profile != nullptr) stored.profile.assign(colours.icc_profile, colours.icc_bytes);
    if (colours.has_chromaticities != 0)
        std::copy_n(colours.chromaticities, 8, stored.chromaticities.emplace().begin());
    library.free_colours(&colours);
    if (stored.profile.empty() && has_unread_profile(path)) {
        throw core::InputError(path.string() + ": holds an ICC profile that is none (it is damaged).");
    }
    into_working_space(image, stored, path.string());
    return image;
}

GreyImage read_grey_image(const std::filesystem::path& path) {
    check_readable(path);
    check_exr_header(path);
    const ImagesLibrary& library = images_library();
    PastosoGrey grey{};
    std::array<char, 512> error{};
    if (library.read_grey(path.c_str(), &grey, error.data(), error.size()) != 0) {
        throw core::InputError(path.string() + ": " + error.data() + ".");
    }
    GreyImage image{grey.width, grey.height, {}};
    image.values.assign(grey.values, grey.values + std::size_t{1} * grey.width * grey.height);
    library.free(&grey);
    return image;
}

}  // namespace pastoso::io
