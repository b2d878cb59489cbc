#include "tank/mesh_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::tank {
namespace {

constexpr std::size_t kLeafTriangles = 4;
constexpr std::size_t kDeepest = 40;  ///< each level halves the triangles, of which there are < 2^32

float length2(const glm::vec3& vector) {
    return glm::dot(vector, vector);
}

float segment_distance2(const glm::vec3& from, const glm::vec3& along, const glm::vec3& point) {
    const glm::vec3 away = point - from;
    const float length = length2(along);
    const float share = length > 0.0F ? std::clamp(glm::dot(away, along) / length, 0.0F, 1.0F) : 0.0F;
    return length2(away - share * along);
}

/// From the plane where the point lies within the three planes that stand on the edges, from the nearest
/// edge elsewhere. A triangle without area is its edges.
float triangle_distance2(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                         const glm::vec3& point) {
    const glm::vec3 ab = b - a, bc = c - b, ca = a - c;
    const glm::vec3 normal = glm::cross(ca, ab);
    const glm::vec3 from_a = point - a;
    const float area2 = length2(normal);
    if (area2 > 0.0F && glm::dot(glm::cross(normal, ab), from_a) >= 0.0F &&
        glm::dot(glm::cross(normal, bc), point - b) >= 0.0F &&
        glm::dot(glm::cross(normal, ca), point - c) >= 0.0F) {
        const float height = glm::dot(normal, from_a);
        return height * height / area2;
    }
    return std::min({segment_distance2(a, ab, point), segment_distance2(b, bc, point),
                     segment_distance2(c, ca, point)});
}

float box_distance2(const glm::vec3& low, const glm::vec3& high, const glm::vec3& point) {
    return length2(glm::max(glm::max(low - point, point - high), glm::vec3(0.0F)));
}

/// How the edge, seen from above, passes to the right of the point (the side of +x): +1 upwards in y, -1
/// downwards, 0 not at all. Edges contain their lower end, and a point on an edge lies to its right.
int passes_right(const glm::vec3& from, const glm::vec3& to, const glm::vec3& point) {
    if ((from.y <= point.y) == (to.y <= point.y)) return 0;
    const bool upwards = from.y <= point.y;
    const glm::dvec3 low(upwards ? from : to), high(upwards ? to : from), at(point);
    const double side = (high.x - low.x) * (at.y - low.y) - (high.y - low.y) * (at.x - low.x);
    return side > 0.0 ? (upwards ? 1 : -1) : 0;
}

/// The height of the triangle's plane over the point, kept between its corners: one that stands upright
/// has none.
double height_at(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& point) {
    const glm::dvec3 origin(a), at(point);
    const glm::dvec3 normal = glm::cross(glm::dvec3(b) - origin, glm::dvec3(c) - origin);
    const double low = std::min({a.z, b.z, c.z}), high = std::max({a.z, b.z, c.z});
    if (normal.z == 0.0) return high;
    const glm::dvec3 away = at - origin;
    const double height = origin.z - (normal.x * away.x + normal.y * away.y) / normal.z;
    return std::clamp(height, low, high);
}

/// What the triangle adds to the winding number: +1 where it lies above the point and looks up, -1 where
/// it looks down.
int turns_above(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& point) {
    const int turns = passes_right(a, b, point) + passes_right(b, c, point) + passes_right(c, a, point);
    return turns != 0 && height_at(a, b, c, point) > static_cast<double>(point.z) ? turns : 0;
}

bool reaches_above(const glm::vec3& low, const glm::vec3& high, const glm::vec3& point) {
    return low.x <= point.x && point.x <= high.x && low.y <= point.y && point.y <= high.y &&
           point.z <= high.z;
}

}  // namespace

MeshDistance::MeshDistance(const liquid::TriangleMesh& mesh) {
    triangles_.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles)
        triangles_.push_back({mesh.positions_m[a], mesh.positions_m[b], mesh.positions_m[c]});
    build(triangles_, 0);
}

/// Halves the triangles along the axis in which their middles differ most, until a few are left.
void MeshDistance::build(std::span<Corners> triangles, std::size_t first) {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    glm::vec3 low(kFar), high(-kFar), middle_low(kFar), middle_high(-kFar);
    for (const Corners& t : triangles) {
        const glm::vec3 middle = t.a + t.b + t.c;
        low = glm::min(low, glm::min(t.a, glm::min(t.b, t.c)));
        high = glm::max(high, glm::max(t.a, glm::max(t.b, t.c)));
        middle_low = glm::min(middle_low, middle);
        middle_high = glm::max(middle_high, middle);
    }
    const std::size_t node = nodes_.size();
    const bool is_leaf = triangles.size() <= kLeafTriangles;
    nodes_.push_back({low, high, static_cast<std::uint32_t>(first),
                      static_cast<std::uint32_t>(is_leaf ? triangles.size() : 0)});
    if (is_leaf) return;

    const glm::vec3 spread = middle_high - middle_low;
    const int axis = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
    const std::size_t half = triangles.size() / 2;
    std::nth_element(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(half),
                     triangles.end(), [axis](const Corners& one, const Corners& other) {
                         return one.a[axis] + one.b[axis] + one.c[axis] <
                                other.a[axis] + other.b[axis] + other.c[axis];
                     });
    build(triangles.first(half), first);
    nodes_[node].next = static_cast<std::uint32_t>(nodes_.size());
    build(triangles.subspan(half), first + half);
}

float MeshDistance::nearest2(const glm::vec3& point, float most2) const {
    struct Waiting {
        std::uint32_t node;
        float distance2;
    };
    std::array<Waiting, kDeepest> waiting;
    std::size_t count = 0;
    float best2 = most2;
    waiting[count++] = {0, box_distance2(nodes_[0].low, nodes_[0].high, point)};
    while (count > 0) {
        auto [at, distance2] = waiting[--count];
        while (distance2 < best2) {
            const Node& node = nodes_[at];
            if (node.count > 0) {
                for (std::uint32_t i = node.next; i < node.next + node.count; ++i) {
                    const auto& [a, b, c] = triangles_[i];
                    best2 = std::min(best2, triangle_distance2(a, b, c, point));
                }
                break;
            }
            const Node &first = nodes_[at + 1], &second = nodes_[node.next];
            Waiting near{at + 1, box_distance2(first.low, first.high, point)};
            Waiting far{node.next, box_distance2(second.low, second.high, point)};
            if (far.distance2 < near.distance2) std::swap(near, far);
            if (far.distance2 < best2) waiting[count++] = far;
            at = near.node;
            distance2 = near.distance2;
        }
    }
    return best2;
}

int MeshDistance::winding(const glm::vec3& point) const {
    std::array<std::uint32_t, kDeepest> waiting;
    std::size_t count = 0;
    int sum = 0;
    waiting[count++] = 0;
    while (count > 0) {
        const std::uint32_t at = waiting[--count];
        const Node& node = nodes_[at];
        if (!reaches_above(node.low, node.high, point)) continue;
        if (node.count == 0) {
            waiting[count++] = node.next;
            waiting[count++] = at + 1;
            continue;
        }
        for (std::uint32_t i = node.next; i < node.next + node.count; ++i) {
            const auto& [a, b, c] = triangles_[i];
            sum += turns_above(a, b, c, point);
        }
    }
    return sum;
}

float MeshDistance::operator()(const glm::vec3& point, float reach) const {
    const float reach2 = reach * reach, found2 = nearest2(point, reach2);
    const float distance = found2 < reach2 ? std::sqrt(found2) : reach;
    return winding(point) != 0 ? -distance : distance;
}

}  // namespace pastoso::tank
