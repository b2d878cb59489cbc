// Where a ray meets the surfaces of a scene, and what lies on either side of them.
#pragma once

#include "trace/numbers.hpp"

namespace pastoso::trace {

/// What is at a place: a set, of which the glass counts before the liquid (nested dielectrics after
/// Schmidt and Budge 2002), so that a liquid's surface may reach into the glass that holds it.
enum Inside : unsigned { kAir = 0, kGlass = 1, kLiquid = 2 };

enum class SurfaceKind { None, Clear, Milk, Solid, Table };

struct Ray {
    glm::vec3 origin, direction;  ///< the direction is a unit vector
};

/// The nearest surface found so far.
struct SurfaceHit {
    float distance = kFar;
    SurfaceKind kind = SurfaceKind::None;
    glm::vec3 normal{0.0F};   ///< of the surface itself, towards its outer side
    glm::vec3 shading{0.0F};  ///< the same, smoothed over the triangles of a mesh
    unsigned decided = 0;     ///< which of Inside the surface bounds, ...
    unsigned outer = 0;       ///< ... and which of them are there on its outer
    unsigned inner = 0;       ///< and on its inner side

    /// What is behind the surface for a ray that comes from `here`.
    unsigned beyond(unsigned here, const glm::vec3& direction) const {
        return (here & ~decided) | (glm::dot(direction, normal) < 0.0F ? inner : outer);
    }
};

/// Nearer ones are taken for the surface that the ray starts from.
inline constexpr float kNearest_m = 2e-6F;

}  // namespace pastoso::trace
