// What a surface of triangles is as a whole.
#pragma once

#include "liquid/surface/triangle_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace pastoso::liquid::test {

struct MeshReport {
    std::size_t bad_edges =
        0;  ///< directed edges that are not there exactly once, or whose opposite is not
    std::size_t bad_vertices = 0;  ///< whose triangles are no single fan
    long euler = 0;                ///< V - E + F
};

using Edge = std::pair<std::uint32_t, std::uint32_t>;

inline std::vector<Edge> directed_edges(const TriangleMesh& mesh) {
    std::vector<Edge> edges;
    for (const auto& triangle : mesh.triangles)
        for (std::size_t c = 0; c < 3; ++c)
            edges.push_back({triangle[c], triangle[(c + 1) % 3]});
    std::sort(edges.begin(), edges.end());
    return edges;
}

inline std::size_t count_bad_edges(const std::vector<Edge>& edges) {
    std::size_t bad = 0;
    for (const Edge& edge : edges) {
        const auto same = std::equal_range(edges.begin(), edges.end(), edge);
        const Edge back{edge.second, edge.first};
        if (same.second - same.first != 1 || !std::binary_search(edges.begin(), edges.end(), back))
            ++bad;
    }
    return bad;
}

/// Vertices around which the triangles do not follow each other in one round.
inline std::size_t count_bad_vertices(const TriangleMesh& mesh) {
    std::vector<std::map<std::uint32_t, std::uint32_t>> next(mesh.positions_m.size());
    for (const auto& triangle : mesh.triangles)
        for (std::size_t c = 0; c < 3; ++c)
            next[triangle[c]][triangle[(c + 1) % 3]] = triangle[(c + 2) % 3];
    std::size_t bad = 0;
    for (const auto& around : next) {
        if (around.empty()) {
            ++bad;  // a vertex that nothing uses
            continue;
        }
        const std::uint32_t first = around.begin()->first;
        std::uint32_t at = first;
        std::size_t steps = 0;
        do {
            const auto step = around.find(at);
            if (step == around.end()) break;
            at = step->second;
            ++steps;
        } while (at != first && steps <= around.size());
        if (steps != around.size() || at != first) ++bad;
    }
    return bad;
}

inline MeshReport examine(const TriangleMesh& mesh) {
    const std::vector<Edge> edges = directed_edges(mesh);
    MeshReport report;
    report.bad_edges = count_bad_edges(edges);
    report.bad_vertices = count_bad_vertices(mesh);
    report.euler = static_cast<long>(mesh.positions_m.size()) - static_cast<long>(edges.size() / 2) +
                   static_cast<long>(mesh.triangles.size());
    return report;
}

}  // namespace pastoso::liquid::test
