#include "core/units.hpp"
#include "files/file_head.hpp"
#include "files/image.hpp"
#include "files/picture_format.hpp"
#include "files/picture_rows.hpp"
#include "files/png_rows.hpp"
#include "files/upright.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace pastoso::files {
namespace {

/// Read at once: small beside a picture of any size, many enough for the work that each time begins
/// with.
constexpr int kPixelsAtOnce = 1 << 20;

/// As picture_error() has it.
const std::string kInMemory{};

/// Calls take(y, count, values) for all rows, `count` of them at a time. Throws picture_error() where a
/// value is no number, or the file ends too early.
template <class Take>
void for_rows(PictureRows& rows, const std::string& name, Take&& take) {
    const PictureHead& head = rows.head();
    const int whole = std::max(1, kPixelsAtOnce / (head.width * head.rows_at_once)) * head.rows_at_once;
    const std::size_t row_values = std::size_t{1} * head.width * head.channels();
    std::vector<float> values(row_values * static_cast<std::size_t>(std::min(whole, head.height)));
    for (int y = 0; y < head.height; y += whole) {
        const int count = std::min(whole, head.height - y);
        rows.read(count, values.data());
        const auto end = values.begin() + static_cast<std::ptrdiff_t>(row_values) * count;
        if (!std::all_of(values.begin(), end, [](float value) { return std::isfinite(value); }))
            throw picture_error(name, core::message("holds a value that is not a finite number."));
        take(y, count, values.data());
    }
    rows.finish();
}

/// The luminance of three channels (Rec. 709 weights on the stored values), else the first.
float grey_of(const float* channels, int colours) {
    return colours < 3 ? channels[0]
                       : 0.2126F * channels[0] + 0.7152F * channels[1] + 0.0722F * channels[2];
}

/// Three values a pixel; where `divided`, those multiplied by their alpha as if they were not.
pigment::LinearImage colours_of(const PictureHead& head, const float* values, int count, bool divided,
                                pigment::WorkingSpace space) {
    pigment::LinearImage image{head.width, count, {}, space};
    const std::size_t pixels = std::size_t{1} * head.width * count;
    image.rgb.resize(3 * pixels);
    for (std::size_t i = 0; i < pixels; ++i, values += head.channels()) {
        const float alpha = divided && head.colours_have_alpha ? values[head.colours] : 1.0F;
        for (std::size_t k = 0; k < 3; ++k)
            image.rgb[3 * i + k] = alpha > 0.0F ? values[head.colours < 3 ? 0 : k] / alpha : 0.0F;
    }
    return image;
}

void check_profile(const PictureHead& head, const std::string& name) {
    if (head.profile_is_damaged)
        throw picture_error(name, core::message("holds an ICC profile that is none (it is damaged)."));
}

/// What programs write that know no resolution.
bool says_nothing(double px_per_mm) {
    const double px_per_inch = std::round(core::kInch_mm * px_per_mm);
    return px_per_inch < 1.0 || px_per_inch == 72.0 || px_per_inch == 96.0 || !(px_per_mm < 1e4);
}

std::uint8_t in_eight_bits(float value) {
    return static_cast<std::uint8_t>(255.0F * std::clamp(value, 0.0F, 1.0F) + 0.5F);
}

pigment::Picture empty_picture(const PictureHead& head) {
    pigment::Picture picture{head.width, head.height, {}};
    picture.rgba.resize(std::size_t{4} * head.width * head.height);
    return picture;
}

core::Message called(const std::string& name) {
    return name.empty() ? core::message("the picture") : core::Message::verbatim(name);
}

/// The picture's colours in sRGB, those beyond it brought in, with its alpha.
pigment::Picture srgb_picture(PictureRows& rows, const std::string& name) {
    const PictureHead& head = rows.head();
    check_profile(head, name);
    pigment::Picture picture = empty_picture(head);
    for_rows(rows, name, [&](int y, int count, const float* values) {
        pigment::LinearImage image = colours_of(head, values, count, true, pigment::WorkingSpace::Srgb);
        into_working_space(image, head.meaning, called(name));
        const pigment::Image8 encoded = pigment::encode_srgb8(image);
        std::uint8_t* to = &picture.rgba[std::size_t{4} * y * head.width];
        for (std::size_t i = 0; i < encoded.rgb.size() / 3; ++i, to += 4, values += head.channels()) {
            std::copy_n(&encoded.rgb[3 * i], 3, to);
            to[3] = head.has_alpha ? in_eight_bits(values[head.colours]) : 255;
        }
    });
    return picture;
}

/// The picture's values as they stand in the file.
pigment::Picture stored_picture(PictureRows& rows, const std::string& name) {
    const PictureHead& head = rows.head();
    pigment::Picture picture = empty_picture(head);
    for_rows(rows, name, [&](int y, int count, const float* values) {
        std::uint8_t* to = &picture.rgba[std::size_t{4} * y * head.width];
        for (int i = 0; i < head.width * count; ++i, to += 4, values += head.channels()) {
            for (int k = 0; k < 3; ++k)
                to[k] = in_eight_bits(values[head.colours < 3 ? 0 : k]);
            to[3] = head.has_alpha ? in_eight_bits(values[head.colours]) : 255;
        }
    });
    return picture;
}

/// Of a file in memory.
std::unique_ptr<PictureRows> memory_rows(std::string_view file) {
    return png_rows(
        [file](void* to, std::size_t count) mutable {
            const std::size_t got = file.copy(static_cast<char*>(to), count);
            file.remove_prefix(got);
            return got;
        },
        kInMemory);
}

}  // namespace

bool holds_picture(const std::filesystem::path& path) {
    return picture_format(file_head(path, kPictureHeadBytes)) != PictureFormat::None;
}

pigment::LinearImage read_colour_image(const std::filesystem::path& path, pigment::WorkingSpace space) {
    const std::unique_ptr<PictureRows> rows = open_picture(path);
    const PictureHead& head = rows->head();
    const std::string name = path.string();
    check_profile(head, name);
    pigment::LinearImage image{head.width, head.height, {}, space};
    image.rgb.reserve(std::size_t{3} * head.width * head.height);
    for_rows(*rows, name, [&](int, int count, const float* values) {
        pigment::LinearImage part = colours_of(head, values, count, false, space);
        into_working_space(part, head.meaning, called(name));
        image.rgb.insert(image.rgb.end(), part.rgb.begin(), part.rgb.end());
    });
    return image;
}

StoredPicture read_picture(const std::filesystem::path& path) {
    const std::unique_ptr<PictureRows> rows = open_picture(path);
    const PictureHead& head = rows->head();
    StoredPicture result{srgb_picture(*rows, path.string()), 0.0, 0.0};
    if (!says_nothing(head.px_per_mm_x) && !says_nothing(head.px_per_mm_y)) {
        result.width_mm = head.width / head.px_per_mm_x;
        result.height_mm = head.height / head.px_per_mm_y;
    }
    if (head.orientation > 4) std::swap(result.width_mm, result.height_mm);
    result.picture = upright(std::move(result.picture), head.orientation);
    return result;
}

GreyImage read_grey_image(const std::filesystem::path& path) {
    const std::unique_ptr<PictureRows> rows = open_picture(path);
    const PictureHead& head = rows->head();
    GreyImage image{head.width, head.height, {}};
    image.values.reserve(std::size_t{1} * head.width * head.height);
    for_rows(*rows, path.string(), [&](int, int count, const float* values) {
        for (int i = 0; i < head.width * count; ++i, values += head.channels()) {
            const bool multiplied = head.colours_have_alpha || !head.has_alpha;
            const float alpha = multiplied ? 1.0F : values[head.colours];
            image.values.push_back(alpha * grey_of(values, head.colours));
        }
    });
    return image;
}

pigment::Picture decode_png(std::string_view file) {
    return stored_picture(*memory_rows(file), kInMemory);
}

pigment::Picture decode_png_to_srgb(std::string_view file) {
    const std::unique_ptr<PictureRows> rows = memory_rows(file);
    check_profile(rows->head(), kInMemory);
    const IccProfile& profile = rows->head().meaning.profile;
    // Our own colours come back exactly.
    if (profile.empty() || profile == icc_profile(pigment::WorkingSpace::Srgb))
        return stored_picture(*rows, kInMemory);
    return srgb_picture(*rows, kInMemory);
}

}  // namespace pastoso::files
