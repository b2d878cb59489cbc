#include "io/picture_file.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "io/image.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::io {
namespace {

/// Values of 0 to 1 in whole steps.
template <class Image>
Image in_steps(const shade::LinearImage& image, float steps) {
    Image result{image.width, image.height, {}, image.space};
    result.rgb.reserve(image.rgb.size());
    for (const float value : image.rgb) {
        result.rgb.push_back(static_cast<typename decltype(result.rgb)::value_type>(
            std::lround(steps * std::clamp(value, 0.0F, 1.0F))));
    }
    return result;
}

void write_in_profile(const std::filesystem::path& path, const shade::LinearImage& image,
                      const PictureEncoding& encoding, double px_per_mm) {
    const shade::LinearImage converted = in_profile(image, encoding.profile);
    if (encoding.depth_bits == 16) {
        write_image(path, in_steps<shade::Image16>(converted, 65535.0F), px_per_mm, encoding.profile);
    } else {
        write_image(path, in_steps<shade::Image8>(converted, 255.0F), px_per_mm, encoding.profile);
    }
}

}  // namespace

PictureColours picture_colours(const std::string& name_or_path) {
    if (core::lower_case(name_or_path) == "srgb") return {};
    if (core::lower_case(name_or_path) == "display-p3") return {pigment::WorkingSpace::DisplayP3, {}};
    return {pigment::WorkingSpace::DisplayP3, read_icc_profile(name_or_path)};
}

void check_picture_path(const std::filesystem::path& path, const PictureEncoding& encoding) {
    check_image_path(path);
    if (is_linear_format(path)) {
        if (encoding.profile.empty()) return;
        throw core::InputError(path.string() +
                               ": this format holds linear light, which needs no ICC profile.");
    }
    if (encoding.depth_bits == 16 && !holds_16_bits(path)) {
        throw core::InputError(path.string() + ": " + path.extension().string() +
                               " files do not hold 16-bit pictures.");
    }
}

void write_picture(const std::filesystem::path& path, const shade::LinearImage& image,
                   const PictureEncoding& encoding, double px_per_mm) {
    PASTOSO_CHECK(encoding.depth_bits == 8 || encoding.depth_bits == 16);
    check_picture_path(path, encoding);
    if (is_linear_format(path)) {
        write_image(path, image, px_per_mm);
    } else if (!encoding.profile.empty()) {
        write_in_profile(path, image, encoding, px_per_mm);
    } else if (encoding.depth_bits == 16) {
        write_image(path, shade::encode_srgb16(image), px_per_mm);
    } else {
        write_image(path, shade::encode_srgb8(image), px_per_mm);
    }
}

}  // namespace pastoso::io
