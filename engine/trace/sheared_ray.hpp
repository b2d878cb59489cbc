// Where a ray meets a triangle, after Woop, Benthin and Wald, Watertight Ray/Triangle Intersection
// (2013), in double precision: space is sheared so that the ray runs along an axis, and the triangle is
// met where that axis is on the same side of its three edges. Neighbours compute their common edge
// alike, so that no ray slips between them.
#pragma once

#include "trace/triangle_rays.hpp"

#include <glm/common.hpp>

namespace pastoso::trace {

class ShearedRay {
  public:
    explicit ShearedRay(const MeshRay& ray) : origin_(ray.origin) {
        const glm::dvec3 direction(ray.direction), size = glm::abs(direction);
        along_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        x_ = (along_ + 1) % 3;
        y_ = (along_ + 2) % 3;
        scale_ = 1.0 / direction[along_];
        shear_x_ = direction[x_] * scale_;
        shear_y_ = direction[y_] * scale_;
    }

    /// Sets where the ray, however long, or what lies behind its origin meets a triangle; false where
    /// neither does, and for a triangle without area. hit.triangle stays as it is.
    bool meets(const glm::vec3& first, const glm::vec3& second, const glm::vec3& third,
               MeshHit& hit) const {
        const glm::dvec3 a = sheared(first), b = sheared(second), c = sheared(third);
        const double u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
        if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return false;
        const double sum = u + v + w;
        if (!(sum < 0.0 || sum > 0.0)) return false;
        hit.distance = static_cast<float>((u * a.z + v * b.z + w * c.z) / sum);
        hit.second = static_cast<float>(v / sum);
        hit.third = static_cast<float>(w / sum);
        return true;
    }

  private:
    /// Across the ray, and how far along it, in lengths of its direction.
    glm::dvec3 sheared(const glm::vec3& position) const {
        const glm::dvec3 way = glm::dvec3(position) - origin_;
        return {way[x_] - shear_x_ * way[along_], way[y_] - shear_y_ * way[along_],
                way[along_] * scale_};
    }

    glm::dvec3 origin_;
    int along_, x_, y_;
    double scale_, shear_x_, shear_y_;
};

}  // namespace pastoso::trace
