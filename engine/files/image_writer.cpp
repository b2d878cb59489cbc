#include "files/image_writer.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/text_file.hpp"
#include "files/file_head.hpp"
#include "files/images_library.hpp"
#include "files/png_chunks.hpp"
#include "files/webp_chunks.hpp"

#include <algorithm>
#include <array>

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

bool is_integer(Sample sample) {
    return sample == Sample::Uint8 || sample == Sample::Uint16;
}

int sample_type(Sample sample) {
    if (is_integer(sample)) return sample == Sample::Uint8 ? kPastosoUint8 : kPastosoUint16;
    return sample == Sample::Half ? kPastosoFloat : kPastosoData;
}

/// The colours of a working space as PNG's cICP names them (ITU-T H.273): primaries of BT.709 or of
/// Display P3, the curve of sRGB, no matrix, full range.
std::string code_points(pigment::WorkingSpace space) {
    const char primaries = space == pigment::WorkingSpace::Srgb ? 1 : 12;
    return {primaries, 13, 0, 1};
}

/// The profile that says what the values are; none in EXR, which has chromaticities.
IccProfile embedded_profile(const Format& format, const ImageLayout& layout) {
    if (!layout.holds_colours || format.holds_half) return {};
    if (!layout.profile.empty()) return layout.profile;
    return is_integer(layout.sample) ? icc_profile(layout.space) : linear_icc_profile(layout.space);
}

/// A layout as the module takes it. What it points to lives in here.
struct Request {
    Request(const Format& format, const ImageLayout& layout)
        : profile(embedded_profile(format, layout)), chromaticities(chromaticities_of(layout.space)) {
        for (const ImageChannel& channel : layout.channels) {
            names.push_back(channel.name.c_str());
            types.push_back(sample_type(channel.sample));
        }
        picture.width = layout.width;
        picture.height = layout.height;
        picture.channels = layout.channel_count;
        picture.sample_type = sample_type(layout.sample);
        picture.channel_names = names.empty() ? nullptr : names.data();
        picture.stored_types = types.empty() ? nullptr : types.data();
        picture.holds_data = layout.holds_colours ? 0 : 1;
        picture.px_per_mm = layout.px_per_mm;
        picture.format = format.name;
        picture.software = "Pastoso";
        picture.description = layout.description.empty() ? nullptr : layout.description.c_str();
        picture.png_effort = 6;
        picture.quality = layout.quality;
        picture.icc_profile = profile.empty() ? nullptr : profile.data();
        picture.icc_bytes = profile.size();
        if (layout.holds_colours && format.holds_half) picture.chromaticities = chromaticities.data();
    }
    Request(const Request&) = delete;
    Request& operator=(const Request&) = delete;

    IccProfile profile;
    Chromaticities chromaticities;
    std::vector<const char*> names;
    std::vector<int> types;
    PastosoPicture picture{};
};

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

ImageWriter::ImageWriter(const std::filesystem::path& file, const std::filesystem::path& path,
                         const ImageLayout& layout)
    : file_(file), path_(path), layout_(layout) {
    PASTOSO_CHECK(layout.channels.empty() ||
                  layout.channels.size() == static_cast<std::size_t>(layout.channel_count));
    check_layout(path, layout);
    const Request request(format_of(path), layout_);
    std::array<char, 512> error{};
    check(images_library().open(&request.picture, file.c_str(), &writer_, error.data(), error.size()),
          error.data());
}

ImageWriter::~ImageWriter() {
    if (writer_ != nullptr) images_library().close(writer_);
}

void ImageWriter::check(int status, const char* error) const {
    if (status != 0) throw core::InputError(path_.string() + ": " + error + ".");
}

void ImageWriter::write_rows(const void* rows, int count) {
    std::array<char, 512> error{};
    check(images_library().write_rows(writer_, rows, count, error.data(), error.size()), error.data());
}

void ImageWriter::finish() {
    std::array<char, 512> error{};
    check(images_library().finish(writer_, error.data(), error.size()), error.data());
    if (layout_.holds_colours) add_meaning();
}

/// What OpenImageIO does not write by itself.
void ImageWriter::add_meaning() const {
    const std::string_view format = format_of(path_).name;
    if (format == "png" && layout_.profile.empty()) {
        const std::string head = file_head(file_, kPngHeadBytes);
        replace_head(file_, head.size(), with_png_chunk(head, "cICP", code_points(layout_.space)));
    }
    if (format == "webp") {
        const IccProfile profile = embedded_profile(format_of(path_), layout_);
        replace_head(file_, kWebpHeadBytes,
                     webp_head_with_profile(std::filesystem::file_size(file_), layout_.width,
                                            layout_.height, profile));
    }
}

void write_rows_aside(const std::filesystem::path& path, const ImageLayout& layout, const void* rows) {
    check_layout(path, layout);
    core::write_aside(path, [&](const std::filesystem::path& temporary) {
        ImageWriter writer(temporary, path, layout);
        writer.write_rows(rows, layout.height);
        writer.finish();
    });
}

std::string encode_png(const ImageLayout& layout, const void* rows) {
    Request request(kFormats[0], layout);
    request.picture.png_effort = 2;
    const ImagesLibrary& library = images_library();
    PastosoFile file{};
    std::array<char, 512> error{};
    if (library.encode(&request.picture, rows, &file, error.data(), error.size()) != 0)
        throw core::InputError(std::string("A picture ") + error.data() + ".");
    const std::string bytes(file.bytes, file.count);
    library.free_file(&file);
    return with_png_chunk(bytes, "cICP", code_points(layout.space));
}

bool is_linear_format(const std::filesystem::path& path) {
    return format_of(path).holds_half;
}

bool holds(const std::filesystem::path& path, Sample sample) {
    return holds(format_of(path), sample);
}

}  // namespace pastoso::files
