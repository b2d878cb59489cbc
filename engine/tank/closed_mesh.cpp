#include "tank/closed_mesh.hpp"

#include "core/error.hpp"
#include "tank/shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace pastoso::tank {
namespace {

std::string text_of(const glm::vec3& place) {
    std::ostringstream text;
    text << "(" << place.x << ", " << place.y << ", " << place.z << ")";
    return text.str();
}

void check_positions(const liquid::TriangleMesh& mesh) {
    for (std::size_t vertex = 0; vertex < mesh.positions_m.size(); ++vertex) {
        const glm::vec3& at = mesh.positions_m[vertex];
        for (const int axis : {0, 1, 2})
            if (!(std::abs(at[axis]) <= static_cast<float>(kFarthest_m)))
                throw core::InputError("mesh: vertex %1 lies at %2, which is no place.", vertex,
                                       text_of(at));
    }
}

void check_vertices(const liquid::TriangleMesh& mesh) {
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
        for (const std::uint32_t vertex : mesh.triangles[triangle])
            if (vertex >= mesh.positions_m.size())
                throw core::InputError("mesh: triangle %1 names vertex %2 of %3.", triangle, vertex,
                                       mesh.positions_m.size());
}

/// An edge with its lower vertex first, as a number that can be sorted.
std::uint64_t edge_number(std::uint32_t low, std::uint32_t high) {
    return std::uint64_t{low} << 32U | high;
}

[[noreturn]] void refuse_edge(const liquid::TriangleMesh& mesh, std::uint64_t edge) {
    const glm::vec3 &from = mesh.positions_m[edge >> 32U], &to = mesh.positions_m[edge & UINT32_MAX];
    throw core::InputError(
        "mesh: it is not closed: the edge from %1 to %2 is not shared by exactly two "
        "triangles that run along it in opposite directions.",
        text_of(from), text_of(to));
}

/// Edges that triangles run along from the lower to the higher vertex, and those that they run back
/// along, are the same, each once.
void check_edges(const liquid::TriangleMesh& mesh) {
    std::vector<std::uint64_t> there, back;
    for (const auto& triangle : mesh.triangles)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = triangle[corner], to = triangle[(corner + 1) % 3];
            if (from == to) refuse_edge(mesh, edge_number(from, to));
            if (from < to)
                there.push_back(edge_number(from, to));
            else
                back.push_back(edge_number(to, from));
        }
    std::sort(there.begin(), there.end());
    std::sort(back.begin(), back.end());
    const auto [mine, others] = std::mismatch(there.begin(), there.end(), back.begin(), back.end());
    if (mine != there.end() || others != back.end()) {
        const bool is_mine = others == back.end() || (mine != there.end() && *mine < *others);
        refuse_edge(mesh, is_mine ? *mine : *others);
    }
    const auto twice = std::adjacent_find(there.begin(), there.end());
    if (twice != there.end()) refuse_edge(mesh, *twice);
}

}  // namespace

void check_closed(const liquid::TriangleMesh& mesh) {
    if (mesh.triangles.empty()) throw core::InputError("mesh: there are no triangles.");
    check_positions(mesh);
    check_vertices(mesh);
    check_edges(mesh);
}

}  // namespace pastoso::tank
