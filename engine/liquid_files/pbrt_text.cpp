#include "liquid_files/pbrt_text.hpp"

#include <charconv>
#include <cstdio>
#include <vector>

namespace pastoso::liquid_files {
namespace {

void add_vectors(const std::vector<glm::vec3>& vectors, const char* parameter,
                 files::PieceWriter& writer) {
    writer.add_text(std::string(" \"") + parameter + "\" [\n");
    for (const glm::vec3& vector : vectors) {
        writer.add_text(pbrt_numbers({vector.x, vector.y, vector.z}) + "\n");
        writer.item_done();
    }
    writer.add_text(" ]\n");
}

void add_triangles(const liquid::TriangleMesh& mesh, files::PieceWriter& writer) {
    writer.add_text(" \"integer indices\" [\n");
    for (const auto& [a, b, c] : mesh.triangles) {
        char line[48];
        std::snprintf(line, sizeof line, "%u %u %u\n", a, b, c);
        writer.add_text(line);
        writer.item_done();
    }
    writer.add_text(" ]\n");
}

}  // namespace

std::string pbrt_numbers(std::initializer_list<float> numbers) {
    std::string text;
    for (const float number : numbers) {
        char word[32];
        const auto end = std::to_chars(word, word + sizeof word, number).ptr;
        if (!text.empty()) text += ' ';
        text.append(word, end);
    }
    return text;
}

files::ExportStatus write_pbrt_shape(const std::filesystem::path& path, const liquid::TriangleMesh& mesh,
                                     const std::string& what, PbrtSyntax syntax,
                                     const files::KeepGoing& keep_going) {
    const std::size_t items = mesh.positions_m.size() + mesh.normals.size() + mesh.triangles.size();
    return files::write_in_pieces(path, items, keep_going, [&](files::PieceWriter& writer) {
        writer.add_text("# Pastoso " + what + ", metres, z up\n");
        if (mesh.empty()) return;
        writer.add_text("Shape \"trianglemesh\"\n");
        add_vectors(mesh.positions_m, syntax == PbrtSyntax::V4 ? "point3 P" : "point P", writer);
        if (!mesh.normals.empty()) add_vectors(mesh.normals, "normal N", writer);
        add_triangles(mesh, writer);
    });
}

}  // namespace pastoso::liquid_files
