// A hierarchy of boxes around the triangles of a mesh: finds where a ray meets it. Nodes have eight
// children and leaves eight triangles, so that one register holds a coordinate of all of them.
#pragma once

#include "core/isa.hpp"
#include "liquid/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::trace {

inline constexpr int kBvhWidth = 8;

/// Child c has the box from low[.][c] to high[.][c], inside out where there is no child. child[c] counts
/// leaves from kBvhLeaf, nodes from 0.
struct alignas(64) BvhNode {
    float low[3][kBvhWidth], high[3][kBvhWidth];
    std::uint32_t child[kBvhWidth];
};
inline constexpr std::uint32_t kBvhLeaf = 0x80000000U;

/// A node leaves at most seven children waiting, and no mesh of 2^32 triangles is deeper than 24 uneven
/// and 11 even levels.
inline constexpr int kBvhStack = 7 * 48;

/// corner[k][axis][t] of triangle t, whose number in the mesh is triangle[t]; unused ones have no area.
struct alignas(64) BvhLeaf {
    float corner[3][3][kBvhWidth];
    std::uint32_t triangle[kBvhWidth];
};

struct MeshRay {
    float origin[3], direction[3];
    float nearest, farthest;  ///< of the distances that count, in lengths of the direction
};

/// second and third are the weights of the triangle's corners 1 and 2; the first has the rest.
struct MeshHit {
    float distance, second, third;
    std::uint32_t triangle;
};
inline constexpr std::uint32_t kNoTriangle = 0xFFFFFFFFU;

struct BvhView {
    const BvhNode* nodes;
    const BvhLeaf* leaves;
};

struct BvhKernels {
    /// The nearest hit; triangle = kNoTriangle when there is none.
    void (*closest)(const BvhView& bvh, const MeshRay& ray, MeshHit& hit);
    bool (*occluded)(const BvhView& bvh, const MeshRay& ray);
};
const BvhKernels& bvh_kernels(core::Isa isa);

class Bvh {
  public:
    Bvh() = default;
    /// Splits by the surface area heuristic over bins (Wald 2007); the same hierarchy every time.
    explicit Bvh(const liquid::TriangleMesh& mesh);

    bool empty() const { return leaves_.empty(); }

    /// Neighbouring triangles leave no gap between them (Woop et al. 2013).
    MeshHit closest(const MeshRay& ray, const BvhKernels& kernels) const {
        MeshHit hit{ray.farthest, 0.0F, 0.0F, kNoTriangle};
        if (!empty()) kernels.closest({nodes_.data(), leaves_.data()}, ray, hit);
        return hit;
    }
    bool occluded(const MeshRay& ray, const BvhKernels& kernels) const {
        return !empty() && kernels.occluded({nodes_.data(), leaves_.data()}, ray);
    }

  private:
    friend class BvhBuilder;
    std::vector<BvhNode> nodes_;
    std::vector<BvhLeaf> leaves_;
};

}  // namespace pastoso::trace
