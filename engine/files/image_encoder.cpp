#include "files/image_encoder.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "files/images_library.hpp"
#include "files/png_chunks.hpp"
#include "files/png_encoder.hpp"
#include "files/webp_chunks.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace pastoso::files {
namespace {

constexpr std::string_view kOpenExr = "openexr", kPng = "png";

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
IccProfile embedded_profile(std::string_view format, const ImageLayout& layout) {
    if (!layout.holds_colours || format == kOpenExr) return {};
    if (!layout.profile.empty()) return layout.profile;
    return is_integer(layout.sample) ? icc_profile(layout.space) : linear_icc_profile(layout.space);
}

/// A layout as the module takes it. What it points to lives in here.
struct Request {
    Request(const char* format, const ImageLayout& layout, int png_effort)
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
        picture.format = format;
        picture.software = "Pastoso";
        picture.description = layout.description.empty() ? nullptr : layout.description.c_str();
        picture.png_effort = png_effort;
        picture.quality = layout.quality;
        picture.icc_profile = profile.empty() ? nullptr : profile.data();
        picture.icc_bytes = profile.size();
        if (layout.holds_colours && std::string_view(format) == kOpenExr) picture.chromaticities = chromaticities.data();
    }
    Request(const Request&) = delete;
    Request& operator=(const Request&) = delete;

    IccProfile profile;
    Chromaticities chromaticities;
    std::vector<const char*> names;
    std::vector<int> types;
    PastosoPicture picture{};
};

/// Bytes on the way to `sink`, with what the libraries do not write by themselves.
ByteSink with_meaning(std::string_view format, const ImageLayout& layout, ByteSink sink) {
    std::size_t head_bytes = 0;
    std::function<std::string(std::string_view)> make;
    if (format == kPng && layout.profile.empty()) {
        head_bytes = kPngHeadBytes;
        make = [space = layout.space](std::string_view head) {
            return with_png_chunk(head, "cICP", code_points(space));
        };
    } else if (format == "webp") {
        head_bytes = kWebpHeadBytes;
        make = [profile = embedded_profile(format, layout), width = layout.width,
                height = layout.height](std::string_view head) {
            return webp_head_with_profile(head, width, height, profile);
        };
    }
    if (!layout.holds_colours || head_bytes == 0) return sink;
    const auto file = std::make_shared<NewHead>(head_bytes, std::move(make), std::move(sink));
    return [file](std::uint64_t place, std::span<const std::byte> bytes) { file->write_at(place, bytes); };
}

void write_to_sink(void* sink, std::uint64_t place, const void* bytes, std::size_t count) {
    (*static_cast<const ByteSink*>(sink))(place, std::span(static_cast<const std::byte*>(bytes), count));
}

}  // namespace

ImageEncoder::ImageEncoder(core::Message name, const char* format, const ImageLayout& layout,
                           int png_effort, ByteSink sink)
    : name_(std::move(name)), sink_(with_meaning(format, layout, std::move(sink))) {
    PASTOSO_CHECK(layout.channels.empty() ||
                  layout.channels.size() == static_cast<std::size_t>(layout.channel_count));
    const Request request(format, layout, png_effort);
    if (format == kPng) {
        png_ = std::make_unique<PngEncoder>(name_, request.picture, sink_);
        return;
    }
    const PastosoSink target{&sink_, &write_to_sink};
    std::array<char, 512> error{};
    check(images_library().open(&request.picture, &target, &writer_, error.data(), error.size()), error.data());
}

ImageEncoder::~ImageEncoder() {
    if (writer_ != nullptr) images_library().close(writer_);
}

void ImageEncoder::check(int status, const char* error) const {
    if (status != 0) throw core::InputError("%1: %2.", name_, error);
}

void ImageEncoder::write_rows(const void* rows, int count) {
    if (png_ != nullptr) return png_->write_rows(rows, count);
    std::array<char, 512> error{};
    check(images_library().write_rows(writer_, rows, count, error.data(), error.size()), error.data());
}

void ImageEncoder::finish() {
    if (png_ != nullptr) return png_->finish();
    std::array<char, 512> error{};
    check(images_library().finish(writer_, error.data(), error.size()), error.data());
}

}  // namespace pastoso::files
