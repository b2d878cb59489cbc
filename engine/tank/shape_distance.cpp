#include "tank/glass_distance.hpp"
#include "tank/mesh_distance.hpp"
#include "tank/shape.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::tank {
namespace {

/// From a box, by how far a point lies beyond its sides (negative: within them).
template <class Vector>
float from_box(const Vector& beyond) {
    float largest = beyond[0];
    for (int axis = 1; axis < Vector::length(); ++axis)
        largest = std::max(largest, beyond[axis]);
    return largest <= 0.0F ? largest : glm::length(glm::max(beyond, Vector(0.0F)));
}

/// A point as seen from an axis: how far from it, and how far along it from its middle.
struct AxisPlace {
    float across_m, along_m;
};
AxisPlace seen_from_axis(const glm::vec3& middle_m, const glm::vec3& unit, const glm::vec3& point_m) {
    const glm::vec3 away = point_m - middle_m;
    const float along = glm::dot(away, unit);
    return {glm::length(away - along * unit), along};
}

/// A cylinder with what does not depend on the point.
struct Rod {
    explicit Rod(const Cylinder& cylinder)
        : middle_m(0.5F * (cylinder.from_m + cylinder.to_m)),
          unit(glm::normalize(cylinder.to_m - cylinder.from_m)),
          half_length_m(0.5F * glm::distance(cylinder.from_m, cylinder.to_m)),
          radius_m(cylinder.radius_m) {}
    glm::vec3 middle_m, unit;
    float half_length_m, radius_m;
};

struct Ring {
    explicit Ring(const Torus& torus_given)
        : torus(torus_given), unit(glm::normalize(torus_given.axis)) {}
    Torus torus;
    glm::vec3 unit;
};

struct PlacedMesh {
    explicit PlacedMesh(const MeshBody& body)
        : distance(*body.mesh), position_m(body.position_m), scale(body.scale) {}
    MeshDistance distance;
    glm::vec3 position_m;
    float scale;
};

struct Parts {
    explicit Parts(const Combined& combined);
    Combination rule;
    std::vector<PreparedShape> solids;
};

float distance_from(const Sphere& sphere, const glm::vec3& point_m, float) {
    return glm::distance(point_m, sphere.centre_m) - sphere.radius_m;
}

float distance_from(const Block& block, const glm::vec3& point_m, float) {
    return from_box(glm::max(block.low_m - point_m, point_m - block.high_m));
}

float distance_from(const Rod& rod, const glm::vec3& point_m, float) {
    const auto [across, along] = seen_from_axis(rod.middle_m, rod.unit, point_m);
    return from_box(glm::vec2(across - rod.radius_m, std::abs(along) - rod.half_length_m));
}

float distance_from(const Ring& ring, const glm::vec3& point_m, float) {
    const auto [across, along] = seen_from_axis(ring.torus.centre_m, ring.unit, point_m);
    return glm::length(glm::vec2(across - ring.torus.ring_radius_m, along)) - ring.torus.tube_radius_m;
}

float distance_from(const GlassDistance& glass, const glm::vec3& point_m, float) {
    return glass(point_m);
}

float distance_from(const PlacedMesh& mesh, const glm::vec3& point_m, float reach_m) {
    const float reach = reach_m / mesh.scale;
    const float distance = mesh.distance((point_m - mesh.position_m) / mesh.scale, reach);
    return std::abs(distance) < reach ? mesh.scale * distance : std::copysign(reach_m, distance);
}

float distance_from(const Parts& parts, const glm::vec3& point_m, float reach_m);

}  // namespace

struct PreparedShape {
    explicit PreparedShape(const Shape& shape)
        : form(std::visit([](const auto& given) { return prepared(given); }, shape.form)) {}

    float operator()(const glm::vec3& point_m, float reach_m) const {
        return std::visit([&](const auto& f) { return distance_from(f, point_m, reach_m); }, form);
    }

    using Form = std::variant<Sphere, Block, Rod, Ring, GlassDistance, PlacedMesh, Parts>;
    static Form prepared(const Sphere& sphere) { return sphere; }
    static Form prepared(const Block& block) { return block; }
    static Form prepared(const Cylinder& cylinder) { return Rod(cylinder); }
    static Form prepared(const Torus& torus) { return Ring(torus); }
    static Form prepared(const CupGlass& glass) { return GlassDistance(glass.cup); }
    static Form prepared(const MeshBody& body) { return PlacedMesh(body); }
    static Form prepared(const Combined& combined) { return Parts(combined); }

    Form form;
};

namespace {

Parts::Parts(const Combined& combined) : rule(combined.rule) {
    for (const Shape& part : combined.parts)
        solids.emplace_back(part);
}

/// A part that is farther than the reach keeps its side of it, and so does the least or largest of all.
float distance_from(const Parts& parts, const glm::vec3& point_m, float reach_m) {
    float distance = parts.solids.front()(point_m, reach_m);
    for (std::size_t i = 1; i < parts.solids.size(); ++i) {
        const float other = parts.solids[i](point_m, reach_m);
        switch (parts.rule) {
            case Combination::Union:
                distance = std::min(distance, other);
                break;
            case Combination::Intersection:
                distance = std::max(distance, other);
                break;
            case Combination::Difference:
                distance = std::max(distance, -other);
                break;
        }
    }
    return distance;
}

}  // namespace

ShapeDistance::ShapeDistance(const Shape& shape) {
    check_shape(shape);
    prepared_ = std::make_shared<const PreparedShape>(shape);
}

float ShapeDistance::operator()(const glm::vec3& point_m, float reach_m) const {
    return (*prepared_)(point_m, reach_m);
}

}  // namespace pastoso::tank
