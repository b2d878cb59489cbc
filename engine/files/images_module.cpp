#include "core/units.hpp"
#include "files/images_abi.hpp"
#include "files/images_reading.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <string>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace {

using pastoso::images::one_line;

const OIIO::TypeDesc kChromaticities(OIIO::TypeDesc::FLOAT, 8);

int report(const std::string& predicate, char* error, std::size_t capacity) {
    std::snprintf(error, capacity, "%s", predicate.c_str());
    return 1;
}

OIIO::TypeDesc type_of(int sample_type) {
    if (sample_type == kPastosoUint8) return OIIO::TypeDesc::UINT8;
    return sample_type == kPastosoUint16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::FLOAT;
}

OIIO::TypeDesc stored_type_of(int sample_type) {
    return sample_type == kPastosoFloat ? OIIO::TypeDesc(OIIO::TypeDesc::HALF) : type_of(sample_type);
}

void set_channels(const PastosoPicture& picture, OIIO::ImageSpec& spec) {
    for (int k = 0; k < picture.channels; ++k) {
        if (picture.channel_names != nullptr)
            spec.channelnames[static_cast<std::size_t>(k)] = picture.channel_names[k];
        if (picture.stored_types != nullptr)
            spec.channelformats.push_back(stored_type_of(picture.stored_types[k]));
    }
}

/// What the values mean. Integers without a profile of their own are sRGB.
void set_meaning(const PastosoPicture& picture, OIIO::ImageSpec& spec) {
    const bool linear = picture.sample_type == kPastosoFloat || picture.sample_type == kPastosoData;
    if (linear || (picture.icc_profile == nullptr && picture.holds_data == 0))
        spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
    if (picture.icc_profile != nullptr) {
        spec.attribute("ICCProfile",
                       OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(picture.icc_bytes)),
                       picture.icc_profile);
    }
    if (picture.chromaticities != nullptr)
        spec.attribute("chromaticities", kChromaticities, picture.chromaticities);
}

OIIO::ImageSpec spec_of(const PastosoPicture& picture) {
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels,
                         stored_type_of(picture.sample_type));
    set_channels(picture, spec);
    set_meaning(picture, spec);
    spec.attribute("Software", picture.software);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (picture.description != nullptr) spec.attribute("ImageDescription", picture.description);
    const bool webp = std::strcmp(picture.format, "webp") == 0;
    if (webp) spec.attribute("Compression", "webp:" + std::to_string(picture.quality));
    spec.attribute("CompressionQuality", picture.quality);
    if (picture.px_per_mm > 0.0) {
        spec.attribute("XResolution", static_cast<float>(picture.px_per_mm * pastoso::core::kInch_mm));
        spec.attribute("YResolution", static_cast<float>(picture.px_per_mm * pastoso::core::kInch_mm));
        spec.attribute("ResolutionUnit", "in");
    }
    return spec;
}

std::string refusal(std::string message) {
    return "cannot be written (" + one_line(std::move(message)) + ")";
}

}  // namespace

namespace {

/// Hands the bytes on, and never says that anything failed.
class SinkProxy final : public OIIO::Filesystem::IOProxy {
  public:
    explicit SinkProxy(const PastosoSink& sink) : IOProxy("picture", Write), sink_(sink) {}

    const char* proxytype() const override { return "sink"; }
    std::size_t size() const override { return end_; }

    std::size_t write(const void* bytes, std::size_t count) override {
        pwrite(bytes, count, m_pos);
        m_pos += static_cast<std::int64_t>(count);
        return count;
    }

    std::size_t pwrite(const void* bytes, std::size_t count, std::int64_t place) override {
        sink_.write_at(sink_.target, static_cast<std::uint64_t>(place), bytes, count);
        end_ = std::max(end_, static_cast<std::size_t>(place) + count);
        return count;
    }

  private:
    PastosoSink sink_;
    std::size_t end_ = 0;
};

}  // namespace

struct PastosoWriter {
    explicit PastosoWriter(const PastosoSink& sink) : proxy(sink) {}

    SinkProxy proxy;  // outlives the output, which writes until its end
    std::unique_ptr<OIIO::ImageOutput> output;
    OIIO::TypeDesc type;
    int next_row = 0;
};

namespace {

std::string open(const PastosoPicture& picture, const PastosoSink& sink, PastosoWriter*& opened) {
    auto writer = std::make_unique<PastosoWriter>(sink);
    writer->type = type_of(picture.sample_type);
    writer->output = OIIO::ImageOutput::create(picture.format);
    if (!writer->output) return refusal(OIIO::geterror());
    if (!writer->output->set_ioproxy(&writer->proxy) || !writer->output->open("picture", spec_of(picture)))
        return refusal(writer->output->geterror());
    opened = writer.release();
    return "";
}

std::string write_rows(PastosoWriter& writer, const void* rows, int count) {
    const int first = writer.next_row;
    writer.next_row += count;
    const bool written = writer.output->write_scanlines(first, writer.next_row, 0, writer.type, rows);
    return written ? "" : refusal(writer.output->geterror());
}

std::string finish(PastosoWriter& writer) {
    return writer.output->close() ? "" : refusal(writer.output->geterror());
}

/// Nothing may be thrown across the C boundary.
template <class Work>
int guarded(char* error, std::size_t capacity, Work&& work) {
    try {
        const std::string problem = work();
        return problem.empty() ? 0 : report(problem, error, capacity);
    } catch (const std::exception& exception) {
        return report("cannot be read or written (" + one_line(exception.what()) + ")", error, capacity);
    }
}

}  // namespace

extern "C" {

int pastoso_images_abi() {
    return kPastosoImagesAbi;
}

int pastoso_images_open(const PastosoPicture* picture, const PastosoSink* sink, PastosoWriter** writer,
                        char* error, std::size_t capacity) {
    return guarded(error, capacity, [&] { return open(*picture, *sink, *writer); });
}

int pastoso_images_write_rows(PastosoWriter* writer, const void* rows, int count, char* error,
                              std::size_t capacity) {
    return guarded(error, capacity, [&] { return write_rows(*writer, rows, count); });
}

int pastoso_images_finish(PastosoWriter* writer, char* error, std::size_t capacity) {
    return guarded(error, capacity, [&] { return finish(*writer); });
}

void pastoso_images_close(PastosoWriter* writer) {
    delete writer;
}

int pastoso_images_read_open(const char* format, int descriptor, PastosoReader** reader,
                             PastosoHead* head, char* error, std::size_t capacity) {
    return guarded(error, capacity, [&] {
        std::unique_ptr<PastosoReader> opened;
        std::string problem = pastoso::images::open(format, descriptor, opened, *head);
        if (problem.empty()) *reader = opened.release();
        return problem;
    });
}

int pastoso_images_read_rows(PastosoReader* reader, int channels, int count, float* rows, char* error,
                             std::size_t capacity) {
    return guarded(error, capacity,
                   [&] { return pastoso::images::read_rows(*reader, channels, count, rows); });
}

int pastoso_images_read_finish(PastosoReader* reader, char* error, std::size_t capacity) {
    return guarded(error, capacity, [&] { return pastoso::images::finish(*reader); });
}

void pastoso_images_read_close(PastosoReader* reader) {
    delete reader;
}

}  // extern "C"
