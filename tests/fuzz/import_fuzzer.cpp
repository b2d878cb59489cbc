// OpenRaster files of any bytes: refused in a sentence, or brought onto a canvas that can be painted on.
// The first byte chooses whether the rest is a whole file, the list of layers in one, or a picture in
// one.
#include "core/check.hpp"
#include "core/error.hpp"
#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "project/import_open_raster.hpp"
#include "project/stack_reader.hpp"
#include "project/zip_file.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <unistd.h>

namespace pastoso::project {
namespace {

enum Mode { kFile, kStack, kPicture, kModes };

/// Canvases of at most that many pixels are made: larger ones are slow, and all alike.
constexpr int kMostSide_px = 2000;

core::ThreadPool& pool() {
    static core::ThreadPool threads(1);
    return threads;
}

void import_and_paint(std::span<const std::byte> file) {
    const LoadedProject project =
        parse_open_raster(file, "file", {.px_per_mm = 0.25, .width_mm = 40.0}, pool());
    document::Painting painting(project.painting, pool());
    painting.advance_tick();
}

Bytes archive_with(const std::string& stack, const std::string& picture) {
    const auto path =
        std::filesystem::temp_directory_path() / ("import-" + std::to_string(::getpid()) + ".ora");
    ZipWriter archive;
    archive.add("stack.xml", stack);
    archive.add("a.png", picture);
    core::write_aside(path, [&](core::OutputFile& file) { archive.write(file); });
    std::ifstream stream(path, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(stream), {});
    std::filesystem::remove(path);
    const auto view = packing::bytes_of(bytes);
    return {view.begin(), view.end()};
}

void try_stack(const std::string& xml) {
    if (xml.size() > kMostStackBytes) return;
    const RasterStack stack = read_stack(xml, "file");
    for (const StackPicture& picture : stack.pictures)
        PASTOSO_CHECK_OP(picture.group, <=, stack.groups.size());
    if (stack.width <= kMostSide_px && stack.height <= kMostSide_px)
        import_and_paint(archive_with(xml, ""));
}

void try_bytes(int mode, const std::string& bytes) {
    switch (mode) {
        case kFile:
            return import_and_paint(packing::bytes_of(bytes));
        case kStack:
            return try_stack(bytes);
        default:
            return import_and_paint(archive_with(
                "<image w='20' h='10'><stack><layer src='a.png' x='-2'/></stack></image>", bytes));
    }
}

}  // namespace
}  // namespace pastoso::project

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace pastoso::project;
    if (size == 0) return 0;
    try {
        try_bytes(data[0] % kModes, {reinterpret_cast<const char*>(data + 1), size - 1});
    } catch (const pastoso::core::InputError& error) {
        const std::string_view sentence = error.what();
        // Of the size of the canvas, the sentence speaks without the file.
        PASTOSO_CHECK(!sentence.empty() && sentence.back() == '.');
    }
    return 0;
}
