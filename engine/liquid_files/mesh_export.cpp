#include "liquid_files/mesh_export.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "files/triangle_file.hpp"
#include "liquid_files/pbrt_text.hpp"

#include <cmath>
#include <vector>

namespace pastoso::liquid_files {
namespace {

using liquid::TriangleMesh;

files::Vector as_array(const glm::vec3& vector) {
    return {vector.x, vector.y, vector.z};
}

class MeshSource : public files::TriangleSource {
  public:
    MeshSource(const TriangleMesh& mesh, const std::string& what) : mesh_(mesh), what_(what) {}

    std::string title() const override { return what_ + ", metres"; }
    std::size_t vertex_count() const override { return mesh_.positions_m.size(); }
    std::size_t triangle_count() const override { return mesh_.triangles.size(); }
    files::Vector vertex(std::size_t index) const override { return as_array(mesh_.positions_m[index]); }
    bool has_normals() const override { return !mesh_.normals.empty(); }
    files::Vector normal(std::size_t index) const override { return as_array(mesh_.normals[index]); }
    void for_each_triangle(const std::function<void(const files::Triangle&)>& use) const override {
        for (const files::Triangle& triangle : mesh_.triangles)
            use(triangle);
    }

  private:
    const TriangleMesh& mesh_;
    const std::string& what_;
};

void check_finite(const std::filesystem::path& path, const std::vector<glm::vec3>& vectors,
                  const core::Message& name) {
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        if (std::isfinite(vectors[i].x) && std::isfinite(vectors[i].y) && std::isfinite(vectors[i].z))
            continue;
        throw core::InputError("%1: the %2 of vertex %3 is not finite; nothing was written.",
                               path.string(), name, i);
    }
}

void check_whole(const TriangleMesh& mesh) {
    PASTOSO_CHECK(mesh.normals.empty() || mesh.normals.size() == mesh.positions_m.size());
    for (const files::Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            PASTOSO_CHECK_OP(vertex, <, mesh.positions_m.size());
}

bool is_pbrt(const std::filesystem::path& path) {
    return core::lower_case(path.extension().string()) == ".pbrt";
}

}  // namespace

bool is_mesh_path(const std::filesystem::path& path) {
    return files::is_triangle_path(path) || is_pbrt(path);
}

files::ExportStatus export_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                                const MeshExportOptions& options, const files::KeepGoing& keep_going) {
    if (!is_mesh_path(path)) {
        throw core::InputError(
            "%1: a surface is saved as .obj, .ply, .stl or .pbrt; this name ends otherwise.",
            path.string());
    }
    check_whole(mesh);
    check_finite(path, mesh.positions_m, core::message("position"));
    check_finite(path, mesh.normals, core::message("normal"));
    if (is_pbrt(path)) return write_pbrt_shape(path, mesh, options.what, options.syntax, keep_going);
    return files::write_triangles(path, MeshSource(mesh, options.what), files::ObjUp::Y, keep_going);
}

}  // namespace pastoso::liquid_files
