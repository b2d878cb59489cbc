#include "io/image.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "io/files.hpp"
#include "io/images_library.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace pastoso::io {
namespace {

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

void write_pixels(const std::filesystem::path& path, PastosoPixels pixels) {
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
    });
}

template <class Image>
PastosoPixels pixels_of(const Image& image, int sample_type, double px_per_mm) {
    PASTOSO_CHECK_OP(image.rgb.size(), ==, std::size_t{3} * image.width * image.height);
    return {image.rgb.data(), image.width, image.height, 3, sample_type, px_per_mm, nullptr, "Pastoso"};
}

}  // namespace

void check_image_path(const std::filesystem::path& path) {
    format_of(path);
    check_writable(path);
}

bool is_linear_format(const std::filesystem::path& path) {
    return format_of(path).holds_linear;
}

void write_image(const std::filesystem::path& path, const shade::Image8& image, double px_per_mm) {
    write_pixels(path, pixels_of(image, kPastosoUint8, px_per_mm));
}

void write_image(const std::filesystem::path& path, const Image16& image, double px_per_mm) {
    write_pixels(path, pixels_of(image, kPastosoUint16, px_per_mm));
}

void write_image(const std::filesystem::path& path, const shade::LinearImage& image, double px_per_mm) {
    write_pixels(path, pixels_of(image, kPastosoFloat, px_per_mm));
}

void write_image(const std::filesystem::path& path, const GreyImage& image, double px_per_mm) {
    PASTOSO_CHECK_OP(image.values.size(), ==, std::size_t{1} * image.width * image.height);
    write_pixels(path, {image.values.data(), image.width, image.height, 1, kPastosoData, px_per_mm,
                        nullptr, "Pastoso"});
}

GreyImage read_grey_image(const std::filesystem::path& path) {
    check_readable(path);
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
