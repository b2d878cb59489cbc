#include "io/images_abi.hpp"

#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

namespace {

constexpr int kMaxSide_px = 32768;
constexpr double kMaxPixels = 1e8;
constexpr int kMaxChannels = 16;

int report(const std::string& predicate, char* error, std::size_t capacity) {
    std::snprintf(error, capacity, "%s", predicate.c_str());
    return 1;
}

/// OpenImageIO's message in one line, without its full stop.
std::string one_line(std::string message) {
    message = message.substr(0, message.find('\n'));
    while (!message.empty() && (message.back() == '.' || message.back() == ' '))
        message.pop_back();
    return message.empty() ? "no reason given" : message;
}

OIIO::TypeDesc type_of(int sample_type) {
    if (sample_type == kPastosoUint8) return OIIO::TypeDesc::UINT8;
    return sample_type == kPastosoUint16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::FLOAT;
}

OIIO::TypeDesc stored_type_of(int sample_type) {
    return sample_type == kPastosoFloat ? OIIO::TypeDesc(OIIO::TypeDesc::HALF) : type_of(sample_type);
}

OIIO::ImageSpec spec_of(const PastosoPixels& pixels) {
    const bool linear = pixels.sample_type == kPastosoFloat || pixels.sample_type == kPastosoData;
    OIIO::ImageSpec spec(pixels.width, pixels.height, pixels.channels,
                         stored_type_of(pixels.sample_type));
    spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
    spec.attribute("Software", pixels.software);
    spec.attribute("CompressionQuality", 95);
    spec.attribute("png:compressionLevel", 6);
    if (pixels.px_per_mm > 0.0) {
        spec.attribute("XResolution", static_cast<float>(pixels.px_per_mm * 25.4));
        spec.attribute("YResolution", static_cast<float>(pixels.px_per_mm * 25.4));
        spec.attribute("ResolutionUnit", "in");
    }
    return spec;
}

std::string write(const PastosoPixels& pixels, const char* path) {
    const auto output = OIIO::ImageOutput::create(pixels.format);
    if (!output) return "cannot be written (" + one_line(OIIO::geterror()) + ")";
    const bool written = output->open(path, spec_of(pixels)) &&
                         output->write_image(type_of(pixels.sample_type), pixels.data) &&
                         output->close();
    return written ? "" : "cannot be written (" + one_line(output->geterror()) + ")";
}

std::string size_problem(const OIIO::ImageSpec& spec) {
    const std::string size =
        std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels";
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1)
        return "is not a plain picture (" + size + ")";
    if (spec.width > kMaxSide_px || spec.height > kMaxSide_px ||
        static_cast<double>(spec.width) * spec.height > kMaxPixels) {
        return "has " + size + ", but at most 32768 a side and 100 million in all are read";
    }
    if (spec.nchannels < 1 || spec.nchannels > kMaxChannels) {
        return "has " + std::to_string(spec.nchannels) + " channels, but 1 to 16 are read";
    }
    return "";
}

/// The luminance of three or more channels (Rec. 709 weights on the stored values), else the first.
float grey_of(const float* channels, int count) {
    return count < 3 ? channels[0]
                     : 0.2126F * channels[0] + 0.7152F * channels[1] + 0.0722F * channels[2];
}

std::string read_grey(const char* path, PastosoGrey& grey) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) return "is not an image that can be read (" + one_line(OIIO::geterror()) + ")";
    const OIIO::ImageSpec spec = input->spec();
    if (std::string problem = size_problem(spec); !problem.empty()) return problem;
    const std::size_t count =
        static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    std::vector<float> channels(count * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, channels.data())) {
        return "cannot be read to its end (" + one_line(input->geterror()) + ")";
    }
    auto values = std::make_unique<float[]>(count);
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = grey_of(&channels[i * static_cast<std::size_t>(spec.nchannels)], spec.nchannels);
        if (!std::isfinite(values[i])) return "holds a value that is not a finite number";
    }
    grey = {values.release(), spec.width, spec.height};
    return "";
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

int pastoso_images_write(const PastosoPixels* pixels, const char* path, char* error,
                         std::size_t capacity) {
    return guarded(error, capacity, [&] { return write(*pixels, path); });
}

int pastoso_images_read_grey(const char* path, PastosoGrey* grey, char* error, std::size_t capacity) {
    return guarded(error, capacity, [&] { return read_grey(path, *grey); });
}

void pastoso_images_free(PastosoGrey* grey) {
    delete[] grey->values;
    grey->values = nullptr;
}

}  // extern "C"
