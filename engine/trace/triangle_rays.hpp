// Where rays meet the triangles of a mesh. Embree 3 finds the triangles that a ray comes near; where it
// meets them is computed here, to the same bits on every instruction set. No other file knows Embree.
#pragma once

#include "core/isa.hpp"
#include "liquid/surface/triangle_mesh.hpp"

#include <cstdint>
#include <memory>

#include <glm/vec3.hpp>

namespace pastoso::trace {

struct MeshRay {
    glm::vec3 origin, direction;
    float nearest, farthest;  ///< of the distances that count, 0 and more, in lengths of the direction
};

/// second and third are the weights of the triangle's corners 1 and 2; the first has the rest.
struct MeshHit {
    float distance, second, third;
    std::uint32_t triangle;
};
inline constexpr std::uint32_t kNoTriangle = 0xFFFFFFFFU;

class TriangleRays {
  public:
    /// Without triangles: nothing is ever met.
    TriangleRays();
    /// Every triangle must be of positions that exist, none of them beyond 1e18. Embree's code is that
    /// for `isa`. Built on the calling thread. Throws InputError when memory runs out.
    explicit TriangleRays(liquid::TriangleMesh mesh, core::Isa isa = core::best_isa());
    ~TriangleRays();
    TriangleRays(TriangleRays&&) noexcept;
    TriangleRays& operator=(TriangleRays&&) noexcept;

    bool empty() const { return state_ == nullptr; }
    /// What the constructor was given.
    const liquid::TriangleMesh& mesh() const;

    /// The nearest triangle on the way, of equally near ones the first of the mesh; triangle =
    /// kNoTriangle and distance = ray.farthest when there is none. Neighbouring triangles leave no gap
    /// between them.
    MeshHit closest(const MeshRay& ray) const;
    /// Whether any triangle is on the way.
    bool anything_between(const MeshRay& ray) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace pastoso::trace
