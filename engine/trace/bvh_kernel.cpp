// Rays through a hierarchy of boxes: boxes by slabs (with Ize's margin, 2013, so that rounding loses
// none), triangles by the watertight test of Woop, Benthin and Wald (2013). Loops over eight lanes
// become vector instructions.
#include "trace/bvh.hpp"

namespace pastoso::trace::PASTOSO_ISA {
namespace {

constexpr float kNone = 3e38F;
constexpr float kBoxMargin = 1.0000004F;

/// The ray as boxes and triangles need it.
struct Prepared {
    float origin[3], inverse[3];
    int ahead, side, other;  ///< axes: the direction's largest component and the other two
    float shear_side, shear_other, scale;
    float nearest;
};

struct Waiting {
    float distance;
    std::uint32_t child;
};

float magnitude(float v) {
    return v < 0.0F ? -v : v;
}

Prepared prepared(const MeshRay& ray) {
    Prepared p;
    p.ahead = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float d = ray.direction[axis];
        p.origin[axis] = ray.origin[axis];
        // A finite slope keeps 0 x infinity out of the slabs.
        p.inverse[axis] = magnitude(d) > 1e-18F ? 1.0F / d : (d < 0.0F ? -1e18F : 1e18F);
        if (magnitude(d) > magnitude(ray.direction[p.ahead])) p.ahead = axis;
    }
    p.side = p.ahead == 2 ? 0 : p.ahead + 1;
    p.other = p.side == 2 ? 0 : p.side + 1;
    p.scale = 1.0F / ray.direction[p.ahead];
    p.shear_side = ray.direction[p.side] * p.scale;
    p.shear_other = ray.direction[p.other] * p.scale;
    p.nearest = ray.nearest;
    return p;
}

/// Where the ray enters each child's box before `farthest`, or kNone.
[[gnu::always_inline]] inline void enter_boxes(const BvhNode& node, const Prepared& ray, float farthest,
                                               float* out) {
    const float* near_plane[3];
    const float* far_plane[3];
    for (int axis = 0; axis < 3; ++axis) {
        const bool up = ray.inverse[axis] >= 0.0F;
        near_plane[axis] = up ? node.low[axis] : node.high[axis];
        far_plane[axis] = up ? node.high[axis] : node.low[axis];
    }
    const float ox = ray.origin[0], oy = ray.origin[1], oz = ray.origin[2];
    const float ix = ray.inverse[0], iy = ray.inverse[1], iz = ray.inverse[2];
    const float nearest = ray.nearest;
    for (int lane = 0; lane < kBvhWidth; ++lane) {
        const float x0 = (near_plane[0][lane] - ox) * ix, x1 = (far_plane[0][lane] - ox) * ix;
        const float y0 = (near_plane[1][lane] - oy) * iy, y1 = (far_plane[1][lane] - oy) * iy;
        const float z0 = (near_plane[2][lane] - oz) * iz, z1 = (far_plane[2][lane] - oz) * iz;
        const float xy0 = x0 > y0 ? x0 : y0, xy1 = x1 < y1 ? x1 : y1;
        const float z0n = z0 > nearest ? z0 : nearest, z1f = z1 < farthest ? z1 : farthest;
        const float enter = xy0 > z0n ? xy0 : z0n, leave = xy1 < z1f ? xy1 : z1f;
        out[lane] = enter <= leave * kBoxMargin ? enter : kNone;
    }
}

/// Where the ray meets each triangle, or kNone; u and v are not yet divided by `sum`.
struct LeafHits {
    alignas(64) float distance[kBvhWidth], u[kBvhWidth], v[kBvhWidth], sum[kBvhWidth];
};

[[gnu::always_inline]] inline void meet_triangles(const BvhLeaf& leaf, const Prepared& ray,
                                                  LeafHits& out) {
    const float os = ray.origin[ray.side], oo = ray.origin[ray.other], oa = ray.origin[ray.ahead];
    const float ss = ray.shear_side, so = ray.shear_other, scale = ray.scale, nearest = ray.nearest;
    const auto& a = leaf.corner[0];
    const auto& b = leaf.corner[1];
    const auto& c = leaf.corner[2];
    const float *as = a[ray.side], *ao = a[ray.other], *aa = a[ray.ahead];
    const float *bs = b[ray.side], *bo = b[ray.other], *ba = b[ray.ahead];
    const float *cs = c[ray.side], *co = c[ray.other], *ca = c[ray.ahead];
    for (int lane = 0; lane < kBvhWidth; ++lane) {
        const float az = aa[lane] - oa, bz = ba[lane] - oa, cz = ca[lane] - oa;
        const float ax = (as[lane] - os) - ss * az, ay = (ao[lane] - oo) - so * az;
        const float bx = (bs[lane] - os) - ss * bz, by = (bo[lane] - oo) - so * bz;
        const float cx = (cs[lane] - os) - ss * cz, cy = (co[lane] - oo) - so * cz;
        const float u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
        const float uv0 = u < v ? u : v, uv1 = u > v ? u : v;
        const float least = uv0 < w ? uv0 : w, most = uv1 > w ? uv1 : w;
        const float sum = u + v + w;
        const float distance = (u * az + v * bz + w * cz) * scale / sum;
        // All of one sign (or zero): within. NaN from an empty triangle fails every comparison.
        const float beyond = least < 0.0F ? most : 0.0F;
        const float within = beyond > 0.0F ? kNone : distance;
        out.distance[lane] = within > nearest ? within : kNone;
        out.u[lane] = v;
        out.v[lane] = w;
        out.sum[lane] = sum;
    }
}

/// Puts the children that the ray enters on the stack, the nearest on top.
[[gnu::always_inline]] inline int push_children(const BvhNode& node, const float* enter, Waiting* stack,
                                                int top) {
    const int base = top;
    for (int lane = 0; lane < kBvhWidth; ++lane) {
        if (!(enter[lane] < kNone)) continue;
        int place = top++;
        for (; place > base && stack[place - 1].distance < enter[lane]; --place)
            stack[place] = stack[place - 1];
        stack[place] = {enter[lane], node.child[lane]};
    }
    return top;
}

template <bool any>
bool traverse(const BvhView& bvh, const MeshRay& mesh_ray, MeshHit& hit) {
    const Prepared ray = prepared(mesh_ray);
    Waiting stack[kBvhStack];
    alignas(64) float enter[kBvhWidth];
    LeafHits hits;
    stack[0] = {ray.nearest, 0};
    for (int top = 1; top > 0;) {
        const Waiting next = stack[--top];
        if (next.distance > hit.distance) continue;
        if ((next.child & kBvhLeaf) == 0) {
            const BvhNode& node = bvh.nodes[next.child];
            enter_boxes(node, ray, hit.distance, enter);
            top = push_children(node, enter, stack, top);
            continue;
        }
        const BvhLeaf& leaf = bvh.leaves[next.child & ~kBvhLeaf];
        meet_triangles(leaf, ray, hits);
        for (int lane = 0; lane < kBvhWidth; ++lane) {
            if (!(hits.distance[lane] < hit.distance)) continue;
            if constexpr (any) return true;
            const float share = 1.0F / hits.sum[lane];
            hit = {hits.distance[lane], hits.u[lane] * share, hits.v[lane] * share, leaf.triangle[lane]};
        }
    }
    return false;
}

}  // namespace

void closest(const BvhView& bvh, const MeshRay& ray, MeshHit& hit) {
    traverse<false>(bvh, ray, hit);
}

bool occluded(const BvhView& bvh, const MeshRay& ray) {
    MeshHit hit{ray.farthest, 0.0F, 0.0F, kNoTriangle};
    return traverse<true>(bvh, ray, hit);
}

}  // namespace pastoso::trace::PASTOSO_ISA
