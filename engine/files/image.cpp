#include "files/image.hpp"

#include "core/check.hpp"
#include "files/file_access.hpp"
#include "files/image_writer.hpp"

#include <algorithm>
#include <string>

namespace pastoso::files {
namespace {

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

std::string png_file(const pigment::Picture& picture) {
    return encode_png(layout_of(picture, picture.rgba, 4, Sample::Uint8, 0.0), picture.rgba.data());
}

}  // namespace pastoso::files
