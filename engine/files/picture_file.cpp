#include "files/picture_file.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "files/image.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::files {
namespace {

/// Values of 0 to 1 in whole steps.
template <class Image>
Image in_steps(const pigment::LinearImage& image, float steps) {
    Image result{image.width, image.height, {}, image.space};
    result.rgb.reserve(image.rgb.size());
    for (const float value : image.rgb) {
        result.rgb.push_back(static_cast<typename decltype(result.rgb)::value_type>(
            std::lround(steps * std::clamp(value, 0.0F, 1.0F))));
    }
    return result;
}

Sample sample_of(const std::filesystem::path& path, int depth_bits) {
    if (is_linear_format(path)) return Sample::Half;
    if (depth_bits == 32) return Sample::Single;
    return depth_bits == 16 ? Sample::Uint16 : Sample::Uint8;
}

}  // namespace

PictureColours picture_colours(const std::string& name_or_path) {
    if (core::lower_case(name_or_path) == "srgb") return {};
    if (core::lower_case(name_or_path) == "display-p3") return {pigment::WorkingSpace::DisplayP3, {}};
    return {pigment::WorkingSpace::DisplayP3, read_icc_profile(name_or_path)};
}

void check_picture_path(const std::filesystem::path& path, const PictureEncoding& encoding) {
    check_image_path(path);
    const Sample sample = sample_of(path, encoding.depth_bits);
    if (!holds(path, sample)) {
        throw core::InputError("%1: %2 files do not hold %3-bit pictures.", path.string(),
                               path.extension().string(), encoding.depth_bits);
    }
    if (encoding.profile.empty() || sample == Sample::Uint8 || sample == Sample::Uint16) return;
    if (sample == Sample::Half)
        throw core::InputError("%1: this format holds linear light, which needs no ICC profile.",
                               path.string());
    throw core::InputError("%1: 32 bits a channel hold linear light, which needs no ICC profile.",
                           path.string());
}

ImageLayout picture_layout(const std::filesystem::path& path, int width, int height,
                           pigment::WorkingSpace space, const PictureEncoding& encoding,
                           double px_per_mm) {
    PASTOSO_CHECK(encoding.depth_bits == 8 || encoding.depth_bits == 16 || encoding.depth_bits == 32);
    check_picture_path(path, encoding);
    ImageLayout layout;
    layout.width = width;
    layout.height = height;
    layout.sample = sample_of(path, encoding.depth_bits);
    layout.px_per_mm = px_per_mm;
    layout.quality = encoding.quality;
    layout.space = space;
    layout.profile = encoding.profile;
    check_layout(path, layout);
    return layout;
}

void write_picture_rows(ImageWriter& writer, const ImageLayout& layout,
                        const pigment::LinearImage& rows) {
    const bool converted = !layout.profile.empty();
    if (layout.sample == Sample::Half || layout.sample == Sample::Single) {
        writer.write_rows(rows.rgb.data(), rows.height);
    } else if (layout.sample == Sample::Uint16) {
        const pigment::Image16 encoded =
            converted ? in_steps<pigment::Image16>(in_profile(rows, layout.profile), 65535.0F)
                      : pigment::encode_srgb16(rows);
        writer.write_rows(encoded.rgb.data(), rows.height);
    } else {
        const pigment::Image8 encoded =
            converted ? in_steps<pigment::Image8>(in_profile(rows, layout.profile), 255.0F)
                      : pigment::encode_srgb8(rows);
        writer.write_rows(encoded.rgb.data(), rows.height);
    }
}

void write_picture(const std::filesystem::path& path, const pigment::LinearImage& image,
                   const PictureEncoding& encoding, double px_per_mm) {
    const ImageLayout layout =
        picture_layout(path, image.width, image.height, image.space, encoding, px_per_mm);
    core::write_aside(path, [&](core::OutputFile& file) {
        ImageWriter writer(file, layout);
        write_picture_rows(writer, layout, image);
        writer.finish();
    });
}

}  // namespace pastoso::files
