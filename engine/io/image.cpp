#include "io/image.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "io/exr_header.hpp"
#include "io/files.hpp"
#include "io/image_writer.hpp"
#include "io/images_library.hpp"
#include "io/png_chunks.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace pastoso::io {
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

std::string png_file(const shade::Image8& image, double px_per_mm) {
    ImageLayout layout = layout_of(image, image.rgb, 3, Sample::Uint8, px_per_mm);
    layout.space = image.space;
    return encode_png(layout, image.rgb.data());
}

std::string png_file(const shade::Image8& image, double px_per_mm,
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

void write_image(const std::filesystem::path& path, const shade::Image8& image, double px_per_mm,
                 const IccProfile& profile) {
    write_colours(path, image, Sample::Uint8, px_per_mm, profile);
}

void write_image(const std::filesystem::path& path, const Image16& image, double px_per_mm,
                 const IccProfile& profile) {
    write_colours(path, image, Sample::Uint16, px_per_mm, profile);
}

void write_image(const std::filesystem::path& path, const shade::LinearImage& image, double px_per_mm) {
    write_colours(path, image, Sample::Half, px_per_mm, {});
}

void write_image(const std::filesystem::path& path, const GreyImage& image, double px_per_mm) {
    ImageLayout layout = layout_of(image, image.values, 1, Sample::Single, px_per_mm);
    layout.holds_colours = false;
    write_rows_aside(path, layout, image.values.data());
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
