// Rays through a hierarchy of boxes: boxes by slabs (with Ize's margin, 2013, so that rounding loses
// none), triangles by the watertight test of Woop, Benthin and Wald (2013). Loops over eight lanes
// become vector instructions.
#include "trace/bvh.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace pastoso::trace::PASTOSO_ISA {
namespace {

constexpr float kBoxMargin = 1.0000004F;

using Lanes = float __attribute__((vector_size(4 * kBvhWidth)));

[[gnu::always_inline]] inline const Lanes& lanes_at(const float* values) {
    return *reinterpret_cast<const Lanes*>(values);
}

// GCC takes comparisons of vectors that are wider than the processor's apart into single floats, so that
// these are spelled out: x > y ? x : y, x < y ? x : y, and one bit for each lane where x <= y. Results
// go through references, as registers of that width are not passed alike on every processor.
#if defined(__AVX__)
[[gnu::always_inline]] inline const __m256& whole(const Lanes& lanes) {
    return reinterpret_cast<const __m256&>(lanes);
}
[[gnu::always_inline]] inline void larger(const Lanes& x, const Lanes& y, Lanes& out) {
    reinterpret_cast<__m256&>(out) = _mm256_max_ps(whole(x), whole(y));
}
[[gnu::always_inline]] inline void smaller(const Lanes& x, const Lanes& y, Lanes& out) {
    reinterpret_cast<__m256&>(out) = _mm256_min_ps(whole(x), whole(y));
}
[[gnu::always_inline]] inline unsigned where_not_above(const Lanes& x, const Lanes& y) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(whole(x), whole(y), _CMP_LE_OQ)));
}
#elif defined(__SSE__)
[[gnu::always_inline]] inline const __m128& half(const Lanes& lanes, int which) {
    return reinterpret_cast<const __m128*>(&lanes)[which];
}
[[gnu::always_inline]] inline void larger(const Lanes& x, const Lanes& y, Lanes& out) {
    auto* const halves = reinterpret_cast<__m128*>(&out);
    halves[0] = _mm_max_ps(half(x, 0), half(y, 0));
    halves[1] = _mm_max_ps(half(x, 1), half(y, 1));
}
[[gnu::always_inline]] inline void smaller(const Lanes& x, const Lanes& y, Lanes& out) {
    auto* const halves = reinterpret_cast<__m128*>(&out);
    halves[0] = _mm_min_ps(half(x, 0), half(y, 0));
    halves[1] = _mm_min_ps(half(x, 1), half(y, 1));
}
[[gnu::always_inline]] inline unsigned where_not_above(const Lanes& x, const Lanes& y) {
    const int low = _mm_movemask_ps(_mm_cmple_ps(half(x, 0), half(y, 0)));
    const int high = _mm_movemask_ps(_mm_cmple_ps(half(x, 1), half(y, 1)));
    return static_cast<unsigned>(low | (high << 4));
}
#else
inline void larger(const Lanes& x, const Lanes& y, Lanes& out) {
    out = x > y ? x : y;
}
inline void smaller(const Lanes& x, const Lanes& y, Lanes& out) {
    out = x < y ? x : y;
}
inline unsigned where_not_above(const Lanes& x, const Lanes& y) {
    unsigned bits = 0;
    for (int lane = 0; lane < kBvhWidth; ++lane)
        bits |= (x[lane] <= y[lane] ? 1U : 0U) << lane;
    return bits;
}
#endif

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

/// Which children's boxes the ray enters before `farthest`, and where.
[[gnu::always_inline]] inline unsigned enter_boxes(const BvhNode& node, const Prepared& ray,
                                                   float farthest, Lanes& enter) {
    Lanes near_place[3], far_place[3];
    for (int axis = 0; axis < 3; ++axis) {
        const bool up = ray.inverse[axis] >= 0.0F;
        const Lanes& near_plane = lanes_at(up ? node.low[axis] : node.high[axis]);
        const Lanes& far_plane = lanes_at(up ? node.high[axis] : node.low[axis]);
        near_place[axis] = (near_plane - ray.origin[axis]) * ray.inverse[axis];
        far_place[axis] = (far_plane - ray.origin[axis]) * ray.inverse[axis];
    }
    const Lanes nearest = ray.nearest - Lanes{}, last = farthest - Lanes{};
    Lanes enter_z, leave, leave_z;
    larger(near_place[0], near_place[1], enter);
    larger(near_place[2], nearest, enter_z);
    larger(enter, enter_z, enter);
    smaller(far_place[0], far_place[1], leave);
    smaller(far_place[2], last, leave_z);
    smaller(leave, leave_z, leave);
    return where_not_above(enter, leave * kBoxMargin);
}

/// Where the ray meets each triangle; second and third are not yet divided by `sum`.
struct LeafHits {
    Lanes distance, second, third, sum;
};

/// A triangle's corners as seen along the ray: how far to the side, to the other side, and ahead.
struct Seen {
    Lanes side, other, ahead;
};

[[gnu::always_inline]] inline void see_corner(const float (&corner)[3][kBvhWidth], const Prepared& ray,
                                              Seen& seen) {
    seen.ahead = lanes_at(corner[ray.ahead]) - ray.origin[ray.ahead];
    seen.side = (lanes_at(corner[ray.side]) - ray.origin[ray.side]) - ray.shear_side * seen.ahead;
    seen.other = (lanes_at(corner[ray.other]) - ray.origin[ray.other]) - ray.shear_other * seen.ahead;
}

/// Which triangles the ray meets beyond ray.nearest and before `farthest`.
[[gnu::always_inline]] inline unsigned meet_triangles(const BvhLeaf& leaf, const Prepared& ray,
                                                      float farthest, LeafHits& out) {
    Seen a, b, c;
    see_corner(leaf.corner[0], ray, a);
    see_corner(leaf.corner[1], ray, b);
    see_corner(leaf.corner[2], ray, c);
    const Lanes u = c.side * b.other - c.other * b.side;
    const Lanes v = a.side * c.other - a.other * c.side;
    const Lanes w = b.side * a.other - b.other * a.side;
    const Lanes zero{};
    // All of one sign or zero: within.
    Lanes least, most;
    smaller(v, w, least);
    smaller(u, least, least);
    larger(v, w, most);
    larger(u, most, most);
    const unsigned within = where_not_above(zero, least) | where_not_above(most, zero);
    if (within == 0) return 0;
    out.sum = u + v + w;
    out.second = v;
    out.third = w;
    out.distance = (u * a.ahead + v * b.ahead + w * c.ahead) * ray.scale / out.sum;
    // The distance to an empty triangle is NaN, which is in no range.
    return within & where_not_above(ray.nearest - zero, out.distance) &
           where_not_above(out.distance, farthest - zero);
}

/// Puts the children that the ray enters on the stack, the nearest on top.
[[gnu::always_inline]] inline int push_children(const BvhNode& node, unsigned entered,
                                                const Lanes& enter, Waiting* stack, int top) {
    const int base = top;
    for (; entered != 0; entered &= entered - 1) {
        const int lane = __builtin_ctz(entered);
        const float distance = enter[lane];
        int place = top++;
        for (; place > base && stack[place - 1].distance < distance; --place)
            stack[place] = stack[place - 1];
        stack[place] = {distance, node.child[lane]};
    }
    return top;
}

template <bool any>
bool traverse(const BvhView& bvh, const MeshRay& mesh_ray, MeshHit& hit) {
    const Prepared ray = prepared(mesh_ray);
    Waiting stack[kBvhStack];
    Lanes enter;
    LeafHits hits;
    stack[0] = {ray.nearest, 0};
    for (int top = 1; top > 0;) {
        const Waiting next = stack[--top];
        if (next.distance > hit.distance) continue;
        if ((next.child & kBvhLeaf) == 0) {
            const BvhNode& node = bvh.nodes[next.child];
            const unsigned entered = enter_boxes(node, ray, hit.distance, enter);
            top = push_children(node, entered, enter, stack, top);
            continue;
        }
        const BvhLeaf& leaf = bvh.leaves[next.child & ~kBvhLeaf];
        unsigned met = meet_triangles(leaf, ray, hit.distance, hits);
        if (any && met != 0) return true;
        for (; met != 0; met &= met - 1) {
            const int lane = __builtin_ctz(met);
            if (!(hits.distance[lane] < hit.distance)) continue;
            const float share = 1.0F / hits.sum[lane];
            hit = {hits.distance[lane], hits.second[lane] * share, hits.third[lane] * share,
                   leaf.triangle[lane]};
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
