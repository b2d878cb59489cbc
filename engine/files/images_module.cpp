#include "files/images_abi.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace {

constexpr int kMaxSide_px = 32768;
constexpr double kMaxPixels = 1e8;
constexpr int kMaxChannels = 16;

const OIIO::TypeDesc kChromaticities(OIIO::TypeDesc::FLOAT, 8);

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
    spec.attribute("png:compressionLevel", picture.png_effort);
    if (picture.px_per_mm > 0.0) {
        spec.attribute("XResolution", static_cast<float>(picture.px_per_mm * 25.4));
        spec.attribute("YResolution", static_cast<float>(picture.px_per_mm * 25.4));
        spec.attribute("ResolutionUnit", "in");
    }
    return spec;
}

std::string refusal(std::string message) {
    return "cannot be written (" + one_line(std::move(message)) + ")";
}

}  // namespace

struct PastosoWriter {
    std::unique_ptr<OIIO::ImageOutput> output;
    OIIO::TypeDesc type;
    int next_row = 0;
};

namespace {

std::string open(const PastosoPicture& picture, const char* path, PastosoWriter*& opened) {
    auto writer = std::make_unique<PastosoWriter>();
    writer->type = type_of(picture.sample_type);
    writer->output = OIIO::ImageOutput::create(picture.format);
    if (!writer->output) return refusal(OIIO::geterror());
    if (!writer->output->open(path, spec_of(picture))) return refusal(writer->output->geterror());
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

std::string encode(const PastosoPicture& picture, const void* rows, PastosoFile& file) {
    const auto output = OIIO::ImageOutput::create(picture.format);
    if (!output) return refusal(OIIO::geterror());
    OIIO::Filesystem::IOVecOutput sink;
    const bool written = output->set_ioproxy(&sink) && output->open("picture", spec_of(picture)) &&
                         output->write_image(type_of(picture.sample_type), rows) && output->close();
    if (!written) return refusal(output->geterror());
    file.count = sink.buffer().size();
    file.bytes = new char[file.count];
    std::memcpy(file.bytes, sink.buffer().data(), file.count);
    return "";
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

/// A file as it is stored, but for channels beyond colour: one, or the first three.
struct Contents {
    OIIO::ImageSpec spec;
    int colour_count = 0;   ///< of a pixel's channels
    int channel_count = 0;  ///< with alpha, where that is the one after the colours
    std::vector<float> channels;

    bool has_alpha() const { return channel_count > colour_count; }

    std::size_t pixels() const {
        return static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    }
};

std::string read(const char* path, const OIIO::ImageSpec& wishes, Contents& contents) {
    const auto input = OIIO::ImageInput::open(path, &wishes);
    if (!input) return "is not an image that can be read (" + one_line(OIIO::geterror()) + ")";
    contents.spec = input->spec();
    if (std::string problem = size_problem(contents.spec); !problem.empty()) return problem;
    contents.colour_count = contents.spec.nchannels < 3 ? 1 : 3;
    const bool has_alpha = contents.spec.alpha_channel == contents.colour_count;
    const int channels = contents.colour_count + (has_alpha ? 1 : 0);
    contents.channel_count = channels;
    contents.channels.resize(contents.pixels() * static_cast<std::size_t>(channels));
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, contents.channels.data())) {
        return "cannot be read to its end (" + one_line(input->geterror()) + ")";
    }
    return "";
}

std::string read_grey(const char* path, PastosoGrey& grey) {
    Contents contents;
    if (std::string problem = read(path, OIIO::ImageSpec(), contents); !problem.empty()) return problem;
    const std::vector<float>& channels = contents.channels;
    const std::size_t count = contents.pixels();
    auto values = std::make_unique<float[]>(count);
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = grey_of(&channels[i * static_cast<std::size_t>(contents.channel_count)],
                            contents.colour_count);
        if (!std::isfinite(values[i])) return "holds a value that is not a finite number";
    }
    grey = {values.release(), contents.spec.width, contents.spec.height};
    return "";
}

/// The first three channels, or the first three times.
std::string fill_rgb(const Contents& contents, PastosoColours& colours) {
    const auto channels = static_cast<std::size_t>(contents.channel_count);
    auto rgb = std::make_unique<float[]>(3 * contents.pixels());
    for (std::size_t i = 0; i < contents.pixels(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const float value = contents.channels[i * channels + (contents.colour_count < 3 ? 0 : k)];
            if (!std::isfinite(value)) return "holds a value that is not a finite number";
            rgb[3 * i + k] = value;
        }
    }
    colours.rgb = rgb.release();
    return "";
}

std::string fill_alpha(const Contents& contents, PastosoColours& colours) {
    if (!contents.has_alpha()) return "";
    const auto channels = static_cast<std::size_t>(contents.channel_count);
    auto alpha = std::make_unique<float[]>(contents.pixels());
    for (std::size_t i = 0; i < contents.pixels(); ++i) {
        alpha[i] = contents.channels[(i + 1) * channels - 1];
        if (!std::isfinite(alpha[i])) return "holds a value that is not a finite number";
    }
    colours.alpha = alpha.release();
    colours.colours_have_alpha = contents.spec.get_int_attribute("oiio:UnassociatedAlpha") == 0;
    return "";
}

/// Millimetres in the unit that a file gives its resolution in; 0 where that says nothing of a size.
double unit_mm(const std::string& unit) {
    if (unit == "in" || unit == "inch") return 25.4;
    if (unit == "cm") return 10.0;
    return unit == "m" ? 1000.0 : 0.0;
}

void fill_place(const OIIO::ImageSpec& spec, PastosoColours& colours) {
    colours.orientation = spec.get_int_attribute("Orientation", 1);
    const double unit = unit_mm(spec.get_string_attribute("ResolutionUnit"));
    if (unit == 0.0) return;
    colours.px_per_mm_x = static_cast<double>(spec.get_float_attribute("XResolution")) / unit;
    colours.px_per_mm_y = static_cast<double>(spec.get_float_attribute("YResolution")) / unit;
}

/// `Picture` has icc_profile and icc_bytes.
template <class Picture>
void fill_profile(const OIIO::ImageSpec& spec, Picture& picture) {
    const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile");
    if (profile == nullptr) return;
    picture.icc_bytes = static_cast<std::size_t>(profile->datasize());
    picture.icc_profile = new char[picture.icc_bytes];
    std::memcpy(picture.icc_profile, profile->data(), picture.icc_bytes);
}

void fill_meaning(const OIIO::ImageSpec& spec, PastosoColours& colours) {
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    colours.is_linear = space == "Linear" || space == "linear" || spec.format.is_floating_point();
    fill_profile(spec, colours);
    if (const OIIO::ParamValue* places = spec.find_attribute("chromaticities", kChromaticities)) {
        colours.has_chromaticities = 1;
        std::memcpy(colours.chromaticities, places->data(), sizeof colours.chromaticities);
    }
}

std::string read_colours(const char* path, PastosoColours& colours) {
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);  // what is transparent keeps its colour
    Contents contents;
    if (std::string problem = read(path, wishes, contents); !problem.empty()) return problem;
    colours = {};
    colours.width = contents.spec.width;
    colours.height = contents.spec.height;
    if (std::string problem = fill_rgb(contents, colours); !problem.empty()) return problem;
    if (std::string problem = fill_alpha(contents, colours); !problem.empty()) return problem;
    fill_meaning(contents.spec, colours);
    fill_place(contents.spec, colours);
    return "";
}

/// Colours and alpha of one pixel, of one to four channels.
void spread(const unsigned char* channels, int count, bool has_alpha, unsigned char* rgba) {
    const int colours = has_alpha ? count - 1 : count;
    for (int k = 0; k < 3; ++k)
        rgba[k] = channels[colours < 3 ? 0 : k];
    rgba[3] = has_alpha ? channels[count - 1] : 255;
}

std::string decode_png(const void* bytes, std::size_t count, PastosoPixels& pixels) {
    OIIO::Filesystem::IOMemReader source(bytes, count);
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::create("png");
    if (!input) return "cannot be read (" + one_line(OIIO::geterror()) + ")";
    OIIO::ImageSpec spec;
    if (!input->set_ioproxy(&source) || !input->open("picture", spec, wishes))
        return "is no PNG picture (" + one_line(input->geterror()) + ")";
    if (std::string problem = size_problem(spec); !problem.empty()) return problem;
    if (spec.nchannels > 4) return "has " + std::to_string(spec.nchannels) + " channels";
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    const std::size_t all = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    std::vector<unsigned char> stored(all * channels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, stored.data()))
        return "cannot be read to its end (" + one_line(input->geterror()) + ")";
    auto rgba = std::make_unique<unsigned char[]>(4 * all);
    for (std::size_t i = 0; i < all; ++i)
        spread(&stored[i * channels], spec.nchannels, spec.nchannels % 2 == 0, &rgba[4 * i]);
    pixels = {rgba.release(), spec.width, spec.height, nullptr, 0};
    fill_profile(spec, pixels);
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

int pastoso_images_open(const PastosoPicture* picture, const char* path, PastosoWriter** writer,
                        char* error, std::size_t capacity) {
    return guarded(error, capacity, [&] { return open(*picture, path, *writer); });
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

int pastoso_images_encode(const PastosoPicture* picture, const void* rows, PastosoFile* file,
                          char* error, std::size_t capacity) {
    return guarded(error, capacity, [&] { return encode(*picture, rows, *file); });
}

void pastoso_images_free_file(PastosoFile* file) {
    delete[] file->bytes;
    file->bytes = nullptr;
}

int pastoso_images_read_grey(const char* path, PastosoGrey* grey, char* error, std::size_t capacity) {
    return guarded(error, capacity, [&] { return read_grey(path, *grey); });
}

int pastoso_images_read_colours(const char* path, PastosoColours* colours, char* error,
                                std::size_t capacity) {
    return guarded(error, capacity, [&] { return read_colours(path, *colours); });
}

void pastoso_images_free_colours(PastosoColours* colours) {
    delete[] colours->rgb;
    delete[] colours->icc_profile;
    delete[] colours->alpha;
    colours->alpha = nullptr;
    colours->rgb = nullptr;
    colours->icc_profile = nullptr;
}

int pastoso_images_decode_png(const void* bytes, std::size_t count, PastosoPixels* pixels, char* error,
                              std::size_t capacity) {
    return guarded(error, capacity, [&] { return decode_png(bytes, count, *pixels); });
}

void pastoso_images_free_pixels(PastosoPixels* pixels) {
    delete[] pixels->rgba;
    delete[] pixels->icc_profile;
    pixels->rgba = nullptr;
    pixels->icc_profile = nullptr;
}

void pastoso_images_free(PastosoGrey* grey) {
    delete[] grey->values;
    grey->values = nullptr;
}

}  // extern "C"
