// Wavefront's text of positions and faces.
#include "files/text_lines.hpp"
#include "liquid_files/mesh_import.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace pastoso::liquid_files {
namespace {

class ObjReader {
  public:
    ObjReader(std::string_view text, const std::string& name) : lines_(text, name) {}

    liquid::TriangleMesh read() {
        while (lines_.next()) {
            const std::string_view kind = lines_.word();
            if (kind == "v") add_vector(mesh_.positions_m, kMostMeshVertices);
            if (kind == "vn") add_vector(mesh_.normals, kMostMeshVertices);
            if (kind == "f") add_face();
        }
        if (!has_a_normal_for_each()) mesh_.normals.clear();
        return std::move(mesh_);
    }

  private:
    struct Corner {
        std::uint32_t position = 0;
        bool has_its_normal = false;  ///< the one of the same number
    };

    void add_vector(std::vector<glm::vec3>& vectors, std::size_t most) {
        if (vectors.size() >= most) lines_.fail("there are more than %1 vertices.", most);
        const float x = lines_.number(), y = lines_.number(), z = lines_.number();
        vectors.emplace_back(x, -z, y);
    }

    void add_face() {
        std::array<std::uint32_t, 3> triangle{};
        std::size_t corners = 0;
        for (std::string_view word = lines_.word(); !word.empty(); word = lines_.word(), ++corners) {
            const Corner corner = corner_of(word);
            normals_match_ = normals_match_ && corner.has_its_normal;
            triangle[std::min<std::size_t>(corners, 2)] = corner.position;
            if (corners < 2) continue;
            add_triangle(triangle);
            triangle[1] = triangle[2];
        }
        if (corners < 3) lines_.fail("a face has %1 corners, not three or more.", corners);
    }

    /// What is no more than a line, as a corner that is named twice makes it, is left out.
    void add_triangle(const std::array<std::uint32_t, 3>& triangle) {
        const auto& [a, b, c] = triangle;
        if (a == b || b == c || c == a) return;
        if (mesh_.triangles.size() >= kMostMeshTriangles)
            lines_.fail("there are more than %1 triangles.", kMostMeshTriangles);
        mesh_.triangles.push_back(triangle);
    }

    Corner corner_of(std::string_view word) const {
        const std::size_t slash = word.find('/');
        const std::size_t second =
            slash == std::string_view::npos ? std::string_view::npos : word.find('/', slash + 1);
        Corner corner;
        corner.position = index_of(word.substr(0, slash), word, mesh_.positions_m.size(),
                                   core::Pattern<0>("position"));
        if (second == std::string_view::npos) return corner;
        corner.has_its_normal = index_of(word.substr(second + 1), word, mesh_.normals.size(),
                                         core::Pattern<0>("normal")) == corner.position;
        return corner;
    }

    /// Counted from 0.
    std::uint32_t index_of(std::string_view digits, std::string_view word, std::size_t count,
                           core::Pattern<0> what) const {
        std::int64_t number = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (error != std::errc() || end != digits.data() + digits.size())
            lines_.fail("%1 is no corner of a face.", files::quoted(word));
        const auto last = static_cast<std::int64_t>(count);
        if (number == 0 || number > last || number < -last)
            lines_.fail("%1 names %2 %3, but %4 were given until here.", files::quoted(word),
                        core::message(what), number, count);
        return static_cast<std::uint32_t>(number > 0 ? number - 1 : last + number);
    }

    /// Unit vectors, as all of ours are.
    bool has_a_normal_for_each() const {
        if (!normals_match_ || mesh_.normals.size() != mesh_.positions_m.size()) return false;
        for (const glm::vec3& normal : mesh_.normals)
            if (!(std::abs(glm::length(normal) - 1.0F) < 1e-3F)) return false;
        return true;
    }

    files::TextLines lines_;
    liquid::TriangleMesh mesh_;
    bool normals_match_ = true;
};

}  // namespace

liquid::TriangleMesh mesh_from_obj(std::string_view text, const std::string& name) {
    return ObjReader(text, name).read();
}

}  // namespace pastoso::liquid_files
