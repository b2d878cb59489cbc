#include "liquid_files/mesh_import.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/text_file.hpp"

namespace pastoso::liquid_files {
namespace {

struct Format {
    const char* extension;
    liquid::TriangleMesh (*read)(std::string_view bytes, const std::string& name);
};
constexpr Format kFormats[] = {{".obj", mesh_from_obj}, {".stl", mesh_from_stl}};

const Format* format_of(const std::filesystem::path& path) {
    const std::string extension = core::lower_case(path.extension().string());
    for (const Format& format : kFormats)
        if (extension == format.extension) return &format;
    return nullptr;
}

}  // namespace

liquid::TriangleMesh import_mesh(const std::filesystem::path& path) {
    const Format* format = format_of(path);
    if (format == nullptr) {
        throw core::InputError("%1: a mesh is read from .obj or .stl; this name ends otherwise.",
                               path.string());
    }
    return format->read(core::read_text_file(path), path.string());
}

}  // namespace pastoso::liquid_files
