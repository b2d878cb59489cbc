#include "files/images_reading.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace pastoso::images {
namespace {

constexpr int kMaxSide_px = 32768;
constexpr double kMaxPixels = 1e8;
constexpr int kMaxChannels = 16;

/// What libraries may hold of a picture at once: some keep all of it.
constexpr double kMostBytes = 1 << 30;

/// All tiles beside one another are read at once.
constexpr double kMaxTileRowPixels = 1 << 25;

const OIIO::TypeDesc kChromaticities(OIIO::TypeDesc::FLOAT, 8);

std::string size_problem(const OIIO::ImageSpec& spec) {
    const std::string size =
        std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels";
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.deep)
        return "is not a plain picture (" + size + ")";
    if (spec.width > kMaxSide_px || spec.height > kMaxSide_px ||
        static_cast<double>(spec.width) * spec.height > kMaxPixels) {
        return "has " + size + ", but at most 32768 a side and 100 million in all are read";
    }
    if (spec.nchannels < 1 || spec.nchannels > kMaxChannels) {
        return "has " + std::to_string(spec.nchannels) + " channels, but 1 to 16 are read";
    }
    const double tile = static_cast<double>(spec.tile_width) * spec.tile_height;
    const double pixels = std::max(tile, static_cast<double>(spec.width) * spec.height);
    if (pixels * static_cast<double>(spec.pixel_bytes(true)) > kMostBytes) {
        return "has " + size + " of " + std::to_string(spec.pixel_bytes(true)) +
               " bytes, but at most 1 GiB of them is read";
    }
    if (static_cast<double>(std::min(spec.tile_height, spec.height)) * spec.width > kMaxTileRowPixels)
        return "is stored in tiles of " + std::to_string(spec.tile_height) + " rows, too many at once";
    return "";
}

/// Millimetres in the unit that a file gives its resolution in; 0 where that says nothing of a size.
double unit_mm(const std::string& unit) {
    if (unit == "in" || unit == "inch") return pastoso::core::kInch_mm;
    if (unit == "cm") return 10.0;
    return unit == "m" ? 1000.0 : 0.0;
}

void tell_place(const OIIO::ImageSpec& spec, PastosoHead& head) {
    head.orientation = spec.get_int_attribute("Orientation", 1);
    const double unit = unit_mm(spec.get_string_attribute("ResolutionUnit"));
    if (unit == 0.0) return;
    head.px_per_mm_x = static_cast<double>(spec.get_float_attribute("XResolution")) / unit;
    head.px_per_mm_y = static_cast<double>(spec.get_float_attribute("YResolution")) / unit;
}

void tell_meaning(const OIIO::ImageSpec& spec, PastosoHead& head) {
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    head.is_linear = space == "Linear" || space == "linear" || spec.format.is_floating_point();
    head.colours_have_alpha = spec.get_int_attribute("oiio:UnassociatedAlpha") == 0;
    if (const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile")) {
        head.icc_profile = profile->data();
        head.icc_bytes = static_cast<std::size_t>(profile->datasize());
    }
    if (const OIIO::ParamValue* places = spec.find_attribute("chromaticities", kChromaticities)) {
        head.has_chromaticities = 1;
        std::memcpy(head.chromaticities, places->data(), sizeof head.chromaticities);
    }
}

PastosoHead head_of(const OIIO::ImageSpec& spec) {
    PastosoHead head{};
    head.width = spec.width;
    head.height = spec.height;
    head.channels = spec.nchannels;
    head.alpha_channel = spec.alpha_channel;
    head.rows_at_once = std::max(1, spec.tile_height);
    tell_meaning(spec, head);
    tell_place(spec, head);
    return head;
}

std::string cut_off(const OIIO::ImageInput& input) {
    const std::string reason = input.geterror();
    return reason.empty() ? "cannot be read to its end"
                          : "cannot be read to its end (" + one_line(reason) + ")";
}

/// Cameras write JPEG files that libjpeg complains of although nothing is missing.
bool is_harmless(const std::string& complaint) {
    return complaint.find("extraneous bytes") != std::string::npos ||
           complaint.find("Invalid SOS parameters") != std::string::npos;
}

}  // namespace

std::string one_line(std::string message) {
    message = message.substr(0, message.find('\n'));
    while (!message.empty() && (message.back() == '.' || message.back() == ' '))
        message.pop_back();
    return message.empty() ? "no reason given" : message;
}

std::string open(const char* format, int descriptor, std::unique_ptr<PastosoReader>& reader,
                 PastosoHead& head) {
    reader = std::make_unique<PastosoReader>();
    reader->input = OIIO::ImageInput::create(format);
    if (!reader->input) return "cannot be read (" + one_line(OIIO::geterror()) + ")";
    const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
    reader->file.reset(copy < 0 ? nullptr : ::fdopen(copy, "rb"));
    if (!reader->file) {
        if (copy >= 0) ::close(copy);
        return "cannot be read (too many files are open)";
    }
    std::rewind(reader->file.get());
    reader->source =
        std::make_unique<OIIO::Filesystem::IOFile>(reader->file.get(), OIIO::Filesystem::IOProxy::Read);
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);  // what is transparent keeps its colour
    if (!reader->input->set_ioproxy(reader->source.get()) ||
        !reader->input->open("picture", reader->spec, wishes))
        return "is not an image that can be read (" + one_line(reader->input->geterror()) + ")";
    head = head_of(reader->spec);
    return size_problem(reader->spec);
}

std::string read_rows(PastosoReader& reader, int channels, int count, float* rows) {
    const OIIO::ImageSpec& spec = reader.spec;
    const int first = spec.y + reader.next_row;
    reader.next_row += count;
    const bool read =
        spec.tile_width > 0
            ? reader.input->read_tiles(0, 0, spec.x, spec.x + spec.width, first, first + count, 0, 1, 0,
                                       channels, OIIO::TypeDesc::FLOAT, rows)
            : reader.input->read_scanlines(0, 0, first, first + count, 0, 0, channels,
                                           OIIO::TypeDesc::FLOAT, rows);
    return read ? "" : cut_off(*reader.input);
}

std::string finish(PastosoReader& reader) {
    if (!reader.input->has_error()) return "";
    const std::string complaint = reader.input->geterror(false);
    return is_harmless(complaint) ? "" : cut_off(*reader.input);
}

}  // namespace pastoso::images
