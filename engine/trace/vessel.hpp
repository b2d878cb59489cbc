// The surfaces of cup and tank by their equations.
#pragma once

#include "liquid/tea/cup.hpp"
#include "trace/scene.hpp"
#include "trace/surfaces.hpp"

#include <array>

namespace pastoso::trace {

/// Glass in air around tea up to the level: two cones, the rim, the underside, the floor and the level.
class CupSurfaces {
  public:
    explicit CupSurfaces(const liquid::Cup& cup) : cup_(cup) {}

    /// Takes what is nearer than `hit`; `here` is where the ray starts.
    void meet(const Ray& ray, unsigned here, SurfaceHit& hit) const;

  private:
    void meet_wall(const Ray& ray, bool inner, SurfaceHit& hit) const;
    void meet_disc(const Ray& ray, float height_m, float from_m, float to_m, unsigned below,
                   unsigned above, SurfaceHit& hit) const;
    bool passes_by(const Ray& ray) const;

    liquid::Cup cup_;
};

/// Glass plates around an open box, whatever liquid is in it.
class TankSurfaces {
  public:
    explicit TankSurfaces(const Tank& tank);
    void meet(const Ray& ray, SurfaceHit& hit) const;

  private:
    /// A rectangle across one axis; what lies within the hole does not belong to it.
    struct Face {
        int axis;
        float place_m, outward;  ///< +1 or -1 along the axis, out of the glass
        glm::vec3 low_m, high_m;
        bool has_hole;
    };
    Tank tank_;
    std::array<Face, 11> faces_;
};

}  // namespace pastoso::trace
