// Images of any bytes: refused in a sentence, or heights and colours of as many pixels as they say. The
// first byte chooses the name's ending, which must not matter.
#include "core/check.hpp"
#include "core/error.hpp"
#include "files/image.hpp"
#include "film/support/support.hpp"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace pastoso::files {
namespace {

constexpr const char* kEndings[] = {".png", ".tif", ".jpg", ".exr", ".bmp", ".hdr", ".pgm", ".webp"};

/// Removed at the end of the program.
class Folder {
  public:
    Folder() : path(std::filesystem::temp_directory_path() / ("images-" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(path);
    }
    ~Folder() { std::filesystem::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path path;
};

std::filesystem::path written(const char* ending, const std::uint8_t* data, std::size_t size) {
    static const Folder folder;
    const std::filesystem::path path = folder.path / (std::string("image") + ending);
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return path;
}

void try_heights(const std::filesystem::path& path) {
    try {
        const GreyImage image = read_grey_image(path);
        core::ThreadPool pool(1);
        const film::SupportHeights heights =
            film::image_support({20, 10}, image.values, image.width, image.height, 1.0, pool);
        PASTOSO_CHECK_OP(heights.at(19, 9), >=, 0.0F);
        PASTOSO_CHECK_OP(heights.at(19, 9), <=, 1.0F);
    } catch (const core::InputError& error) {
        PASTOSO_CHECK(std::string(error.what()).starts_with(path.string()));
    }
}

void try_colours(const std::filesystem::path& path) {
    try {
        const pigment::LinearImage image = read_colour_image(path);
        PASTOSO_CHECK_OP(image.rgb.size(), ==, std::size_t{3} * image.width * image.height);
    } catch (const core::InputError& error) {
        PASTOSO_CHECK(std::string(error.what()).starts_with(path.string()));
    }
}

}  // namespace
}  // namespace pastoso::files

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace pastoso::files;
    if (size == 0) return 0;
    const std::filesystem::path path =
        written(kEndings[data[0] % std::size(kEndings)], data + 1, size - 1);
    try_heights(path);
    try_colours(path);
    return 0;
}
