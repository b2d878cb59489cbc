// Bodies that liquid and solids of a tank are made of, as plain data: simple forms, meshes, and what is
// combined of them. Metres, z up.
#pragma once

#include "liquid/surface/triangle_mesh.hpp"
#include "liquid/vessel/cup.hpp"

#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::tank {

struct Sphere {
    glm::vec3 centre_m{0.0F};
    float radius_m = 0.0F;  ///< > 0
    friend bool operator==(const Sphere&, const Sphere&) = default;
};

/// With sides along the axes.
struct Block {
    glm::vec3 low_m{0.0F}, high_m{0.0F};  ///< opposite corners, low < high along each axis
    friend bool operator==(const Block&, const Block&) = default;
};

/// With flat ends, around the line between two points.
struct Cylinder {
    glm::vec3 from_m{0.0F}, to_m{0.0F};  ///< the middles of its ends, apart
    float radius_m = 0.0F;               ///< > 0
    friend bool operator==(const Cylinder&, const Cylinder&) = default;
};

struct Torus {
    glm::vec3 centre_m{0.0F};
    glm::vec3 axis{0.0F, 0.0F, 1.0F};  ///< of any length but 0
    float ring_radius_m = 0.0F;        ///< of the line in the middle of the tube, > tube_radius_m
    float tube_radius_m = 0.0F;        ///< > 0
    friend bool operator==(const Torus&, const Torus&) = default;
};

/// The glass of a cup, without what is in it.
struct CupGlass {
    liquid::Cup cup;
    friend bool operator==(const CupGlass&, const CupGlass&) = default;
};

/// What a closed mesh encloses.
struct MeshBody {
    std::string file;  ///< where it came from, as the scene names it
    std::shared_ptr<const liquid::TriangleMesh> mesh;
    glm::vec3 position_m{0.0F};  ///< where the mesh' origin lies
    float scale = 1.0F;          ///< > 0

    /// Meshes are compared by what they hold.
    friend bool operator==(const MeshBody& a, const MeshBody& b) {
        const bool same_mesh = a.mesh == b.mesh || (a.mesh && b.mesh && *a.mesh == *b.mesh);
        return same_mesh && a.file == b.file && a.position_m == b.position_m && a.scale == b.scale;
    }
};

struct Shape;

enum class Combination {
    Union,
    Intersection,
    Difference,  ///< the first part without all others
};

struct Combined {
    Combination rule = Combination::Union;
    std::vector<Shape> parts;  ///< at least one
    friend bool operator==(const Combined&, const Combined&);
};

struct Shape {
    std::variant<Sphere, Block, Cylinder, Torus, CupGlass, MeshBody, Combined> form;
    friend bool operator==(const Shape&, const Shape&) = default;
};

inline bool operator==(const Combined& a, const Combined& b) {
    return a.rule == b.rule && a.parts == b.parts;
}

/// Places and sizes that a shape may have; 1e4 m holds the largest tank four times.
inline constexpr double kFarthest_m = 1e4, kSmallest_m = 1e-6;

/// Throws InputError, naming the value, for a number that is none or out of range, a mesh that is
/// missing or not closed (check_closed()), and a combination without parts.
void check_shape(const Shape& shape);

struct PreparedShape;

/// The signed distance from a shape's surface, negative within. Exact for simple forms; of combinations
/// min, max and max(a, -b), which is exact near surfaces that lie apart and a lower bound of its size
/// elsewhere. Meshes are searched through a tree that is built once. Any number of threads may ask at
/// the same time; copies share what was prepared.
class ShapeDistance {
  public:
    /// Throws like check_shape().
    explicit ShapeDistance(const Shape& shape);

    /// At a point whose coordinates are finite. A distance of `reach_m` (> 0) or more need not be
    /// exact: its sign is, and its size is then at least the reach. Far from a mesh that is many times
    /// as fast.
    float operator()(const glm::vec3& point_m,
                     float reach_m = std::numeric_limits<float>::infinity()) const;

  private:
    std::shared_ptr<const PreparedShape> prepared_;
};

}  // namespace pastoso::tank
