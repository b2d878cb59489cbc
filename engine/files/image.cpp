#include "files/image.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "files/exr_header.hpp"
#include "files/file_access.hpp"
#include "files/image_writer.hpp"
#include "files/images_library.hpp"
#include "files/png_chunks.hpp"
#include "files/upright.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace pastoso::files {
namespace {

constexpr std::size_t kMaxPngBytes = std::size_t{1} << 34;

/// `values` are the image's, `channels` a pixel.
template <class Image, class Values>
ImageLayout layout_of(const Image& image, const Values& values, int channels, Sample sample,
                      double px_per_mm) {
    PASTOSO_CHECK_OP(values.size(), ==, std::size_t{1} * channels * image.width * image.height);
    ImageLayout layout;
    layout.width = image.width;
    layout.height = image.height;
    layout.channel_count = channels;
    layout.sample = sample;
    layout.px_per_mm = px_per_mm;
    return layout;
}

template <class Image>
void write_colours(const std::filesystem::path& path, const Image& image, Sample sample,
                   double px_per_mm, const IccProfile& profile) {
    ImageLayout layout = layout_of(image, image.rgb, 3, sample, px_per_mm);
    layout.space = image.space;
    layout.profile = profile;
    write_rows_aside(path, layout, image.rgb.data());
}

/// libpng passes over a damaged profile; the painter should hear of it.
bool has_unread_profile(const std::filesystem::path& path) {
    return has_png_chunk(core::read_text_file(path, kMaxPngBytes), "iCCP");
}

}  // namespace

void check_image_path(const std::filesystem::path& path) {
    is_linear_format(path);
    check_writable(path);
}

std::string png_file(const pigment::Image8& image, double px_per_mm) {
    ImageLayout layout = layout_of(image, image.rgb, 3, Sample::Uint8, px_per_mm);
    layout.space = image.space;
    return encode_png(layout, image.rgb.data());
}

std::string png_file(const pigment::Image8& image, double px_per_mm,
                     const std::vector<std::uint8_t>& covered) {
    if (covered.empty()) return png_file(image, px_per_mm);
    PASTOSO_CHECK_OP(3 * covered.size(), ==, image.rgb.size());
    std::vector<std::uint8_t> rgba(4 * covered.size(), 0);
    for (std::size_t i = 0; i < covered.size(); ++i) {
        if (covered[i] == 0) continue;
        std::copy_n(&image.rgb[3 * i], 3, &rgba[4 * i]);
        rgba[4 * i + 3] = covered[i];
    }
    ImageLayout layout = layout_of(image, rgba, 4, Sample::Uint8, px_per_mm);
    layout.space = image.space;
    return encode_png(layout, rgba.data());
}

void write_image(const std::filesystem::path& path, const pigment::Image8& image, double px_per_mm,
                 const IccProfile& profile) {
    write_colours(path, image, Sample::Uint8, px_per_mm, profile);
}

void write_image(const std::filesystem::path& path, const pigment::Image16& image, double px_per_mm,
                 const IccProfile& profile) {
    write_colours(path, image, Sample::Uint16, px_per_mm, profile);
}

void write_image(const std::filesystem::path& path, const pigment::LinearImage& image,
                 double px_per_mm) {
    write_colours(path, image, Sample::Half, px_per_mm, {});
}

void write_image(const std::filesystem::path& path, const GreyImage& image, double px_per_mm) {
    ImageLayout layout = layout_of(image, image.values, 1, Sample::Single, px_per_mm);
    layout.holds_colours = false;
    write_rows_aside(path, layout, image.values.data());
}

namespace {

/// What the module has read, freed at the end.
struct StoredColours {
    explicit StoredColours(const std::filesystem::path& path) {
        check_readable(path);
        check_exr_header(path);
        std::array<char, 512> error{};
        const ImagesLibrary& library = images_library();
        if (library.read_colours(path.c_str(), &values, error.data(), error.size()) == 0) return;
        library.free_colours(&values);
        throw core::InputError(path.string() + ": " + error.data() + ".");
    }
    ~StoredColours() { images_library().free_colours(&values); }
    StoredColours(const StoredColours&) = delete;
    StoredColours& operator=(const StoredColours&) = delete;

    PastosoColours values{};
};

pigment::LinearImage linear_image(PastosoColours& colours, const std::filesystem::path& path,
                                  pigment::WorkingSpace space) {
    pigment::LinearImage image{colours.width, colours.height, {}, space};
    image.rgb.assign(colours.rgb, colours.rgb + std::size_t{3} * colours.width * colours.height);
    StoredColour stored;
    stored.linear = colours.is_linear != 0;
    if (colours.icc_profile != nullptr) stored.profile.assign(colours.icc_profile, colours.icc_bytes);
    if (colours.has_chromaticities != 0)
        std::copy_n(colours.chromaticities, 8, stored.chromaticities.emplace().begin());
    if (stored.profile.empty() && has_unread_profile(path)) {
        throw core::InputError(path.string() + ": holds an ICC profile that is none (it is damaged).");
    }
    into_working_space(image, stored, path.string());
    return image;
}

/// Takes the coverage out of colours that are multiplied by it.
void divide_by_alpha(PastosoColours& colours) {
    const std::size_t count = std::size_t{1} * colours.width * colours.height;
    for (std::size_t i = 0; i < count; ++i) {
        const float alpha = colours.alpha[i];
        for (std::size_t k = 0; k < 3; ++k)
            colours.rgb[3 * i + k] = alpha > 0.0F ? colours.rgb[3 * i + k] / alpha : 0.0F;
    }
}

pigment::Picture with_coverage(const pigment::Image8& colours, const float* alpha) {
    pigment::Picture picture{colours.width, colours.height, {}};
    const std::size_t count = colours.rgb.size() / 3;
    picture.rgba.resize(4 * count);
    for (std::size_t i = 0; i < count; ++i) {
        std::copy_n(&colours.rgb[3 * i], 3, &picture.rgba[4 * i]);
        const float share = alpha == nullptr ? 1.0F : std::clamp(alpha[i], 0.0F, 1.0F);
        picture.rgba[4 * i + 3] = static_cast<std::uint8_t>(255.0F * share + 0.5F);
    }
    return picture;
}

/// What programs write that know no resolution.
bool says_nothing(double px_per_mm) {
    const double px_per_inch = std::round(25.4 * px_per_mm);
    return px_per_inch < 1.0 || px_per_inch == 72.0 || px_per_inch == 96.0 || !(px_per_mm < 1e4);
}

}  // namespace

pigment::LinearImage read_colour_image(const std::filesystem::path& path, pigment::WorkingSpace space) {
    StoredColours stored(path);
    return linear_image(stored.values, path, space);
}

StoredPicture read_picture(const std::filesystem::path& path) {
    StoredColours stored(path);
    PastosoColours& values = stored.values;
    if (values.alpha != nullptr && values.colours_have_alpha != 0) divide_by_alpha(values);
    const pigment::LinearImage image = linear_image(values, path, pigment::WorkingSpace::Srgb);
    StoredPicture result{with_coverage(pigment::encode_srgb8(image), values.alpha), 0.0, 0.0};
    if (!says_nothing(values.px_per_mm_x) && !says_nothing(values.px_per_mm_y)) {
        result.width_mm = values.width / values.px_per_mm_x;
        result.height_mm = values.height / values.px_per_mm_y;
    }
    if (values.orientation > 4) std::swap(result.width_mm, result.height_mm);
    result.picture = upright(std::move(result.picture), values.orientation);
    return result;
}

namespace {

struct DecodedPng {
    pigment::Picture picture;
    IccProfile profile;
};

DecodedPng decoded(std::string_view file) {
    const ImagesLibrary& library = images_library();
    PastosoPixels pixels{};
    std::array<char, 512> error{};
    if (library.decode_png(file.data(), file.size(), &pixels, error.data(), error.size()) != 0)
        throw core::InputError("the picture " + std::string(error.data()) + ".");
    DecodedPng png{{pixels.width, pixels.height, {}}, {}};
    png.picture.rgba.assign(pixels.rgba, pixels.rgba + std::size_t{4} * pixels.width * pixels.height);
    if (pixels.icc_profile != nullptr) png.profile.assign(pixels.icc_profile, pixels.icc_bytes);
    library.free_pixels(&pixels);
    return png;
}

void convert_to_srgb(pigment::Picture& picture, const IccProfile& profile) {
    pigment::LinearImage image{picture.width, picture.height, {}};
    const std::size_t count = picture.rgba.size() / 4;
    image.rgb.resize(3 * count);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            image.rgb[3 * i + k] = static_cast<float>(picture.rgba[4 * i + k]) / 255.0F;
    into_working_space(image, {profile, false, {}}, "the picture");
    const pigment::Image8 encoded = pigment::encode_srgb8(image);
    for (std::size_t i = 0; i < count; ++i)
        std::copy_n(&encoded.rgb[3 * i], 3, &picture.rgba[4 * i]);
}

}  // namespace

pigment::Picture decode_png(std::string_view file) {
    return decoded(file).picture;
}

pigment::Picture decode_png_to_srgb(std::string_view file) {
    DecodedPng png = decoded(file);
    if (png.profile.empty() && has_png_chunk(file, "iCCP"))
        throw core::InputError("the picture holds an ICC profile that is none (it is damaged).");
    const bool is_srgb = png.profile.empty() || png.profile == icc_profile(pigment::WorkingSpace::Srgb);
    if (!is_srgb) convert_to_srgb(png.picture, png.profile);
    return png.picture;
}

std::string png_file(const pigment::Picture& picture) {
    return encode_png(layout_of(picture, picture.rgba, 4, Sample::Uint8, 0.0), picture.rgba.data());
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

}  // namespace pastoso::files
