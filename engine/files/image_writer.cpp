#include "files/image_writer.hpp"

#include <cstring>

namespace pastoso::files {
namespace {

/// Of files, and of pictures in memory that nobody keeps for long.
constexpr int kPngEffort = 6, kFastPngEffort = 2;

const char* checked_format(const std::filesystem::path& path, const ImageLayout& layout) {
    check_layout(path, layout);
    return format_name(path);
}

void write_into(std::string& file, std::uint64_t place, std::span<const std::byte> bytes) {
    if (file.size() < place + bytes.size()) file.resize(place + bytes.size());
    std::memcpy(file.data() + place, bytes.data(), bytes.size());
}

}  // namespace

ImageWriter::ImageWriter(core::OutputFile& file, const ImageLayout& layout)
    : file_(file),
      encoder_(core::Message::verbatim(file.path().string()), checked_format(file.path(), layout),
               layout, kPngEffort, [&file](std::uint64_t place, std::span<const std::byte> bytes) {
                   file.write_at(place, bytes);
               }) {
    file_.check();
}

void ImageWriter::write_rows(const void* rows, int count) {
    encoder_.write_rows(rows, count);
    file_.check();
}

void ImageWriter::finish() {
    encoder_.finish();
    file_.check();
}

void write_rows_aside(const std::filesystem::path& path, const ImageLayout& layout, const void* rows) {
    check_layout(path, layout);
    core::write_aside(path, [&](core::OutputFile& file) {
        ImageWriter writer(file, layout);
        writer.write_rows(rows, layout.height);
        writer.finish();
    });
}

std::string encode_png(const ImageLayout& layout, const void* rows) {
    std::string file;
    ImageEncoder encoder(core::message("A picture"), "png", layout, kFastPngEffort,
                         [&file](std::uint64_t place, std::span<const std::byte> bytes) {
                             write_into(file, place, bytes);
                         });
    encoder.write_rows(rows, layout.height);
    encoder.finish();
    return file;
}

}  // namespace pastoso::files
