// Meshes of any bytes: refused in a sentence that names the file, or read to vertices and triangles that
// fit together, and to distances where they are closed. The first byte chooses the format.
#include "core/check.hpp"
#include "core/error.hpp"
#include "liquid_files/mesh_import.hpp"
#include "tank/shape.hpp"

#include <cmath>
#include <cstdint>
#include <memory>
#include <string_view>

namespace pastoso {
namespace {

void try_distance(liquid::TriangleMesh mesh) {
    const auto shared = std::make_shared<const liquid::TriangleMesh>(std::move(mesh));
    try {
        const tank::ShapeDistance distance({tank::MeshBody{"file", shared}});
        for (const glm::vec3& point : {glm::vec3(0.1F, 0.2F, 0.3F), shared->positions_m.front()})
            PASTOSO_CHECK(std::isfinite(distance(point)));
    } catch (const core::InputError& error) {
        PASTOSO_CHECK(std::string_view(error.what()).starts_with("mesh: "));
    }
}

void try_mesh(bool is_obj, std::string_view bytes) {
    liquid::TriangleMesh mesh =
        is_obj ? liquid_files::mesh_from_obj(bytes, "file") : liquid_files::mesh_from_stl(bytes, "file");
    PASTOSO_CHECK(mesh.normals.empty() || mesh.normals.size() == mesh.positions_m.size());
    for (const glm::vec3& position : mesh.positions_m)
        for (const int axis : {0, 1, 2})
            PASTOSO_CHECK(std::isfinite(position[axis]));
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            PASTOSO_CHECK_OP(vertex, <, mesh.positions_m.size());
    try_distance(std::move(mesh));
}

}  // namespace
}  // namespace pastoso

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace pastoso;
    if (size == 0) return 0;
    try {
        try_mesh(data[0] % 2 == 0, {reinterpret_cast<const char*>(data + 1), size - 1});
    } catch (const core::InputError& error) {
        PASTOSO_CHECK(std::string_view(error.what()).starts_with("file"));
    }
    return 0;
}
