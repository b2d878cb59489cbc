// The surfaces of cup and tank by their equations.
#pragma once

#include "liquid/vessel/cup.hpp"
#include "trace/scene.hpp"
#include "trace/surfaces.hpp"

#include <array>
#include <vector>

namespace pastoso::trace {

/// What a vessel lies within.
struct Ball {
    glm::vec3 middle_m{0.0F};
    float radius_m = 0.0F;
};

/// Glass in air around tea up to the level: two cones, the rim, the underside, the floor and
/// the level with its dents.
class CupSurfaces {
  public:
    explicit CupSurfaces(const liquid::Cup& cup, std::vector<LevelDent> dents = {});

    /// Takes what is nearer than `hit`; `here` is where the ray starts.
    void meet(const Ray& ray, unsigned here, SurfaceHit& hit) const;

    const liquid::Cup& shape() const { return cup_; }

    /// A place on the convex hull of the cup, where its rim is closed.
    struct HullPlace {
        glm::vec3 place_m, outward;
    };
    float hull_area_m2() const;
    /// Even over the area, from numbers in [0, 1).
    HullPlace hull_place(float which, const glm::vec2& uniform) const;
    const Ball& ball() const { return ball_; }

    /// How far a place in the tea is from its surface.
    float clearance_m(const glm::vec3& point_m) const {
        return -liquid::tea_distance_m(lowest_, point_m);
    }

  private:
    void meet_wall(const Ray& ray, bool inner, SurfaceHit& hit) const;
    void meet_disc(const Ray& ray, float height_m, float from_m, float to_m, unsigned below,
                   unsigned above, SurfaceHit& hit) const;
    void meet_level(const Ray& ray, SurfaceHit& hit) const;
    float level_m(const glm::vec2& place_m, glm::vec2& slope) const;
    glm::vec3 rounded_foot(const glm::vec3& out, float z_m) const;
    glm::vec3 rounded_lip(const glm::vec2& place_m) const;
    bool passes_by(const Ray& ray) const;
    float foot_radius_m() const { return cup_.inner_radius_m(cup_.foot_m) + cup_.wall_m; }
    float rim_radius_m() const { return cup_.inner_radius_m(cup_.rim_m) + cup_.wall_m; }
    float side_area_m2() const;

    liquid::Cup cup_;
    std::vector<LevelDent> dents_;
    liquid::Cup lowest_;  ///< filled up to the deepest of them
    Ball ball_;
};

/// Glass plates around an open box, whatever liquid is in it.
class TankSurfaces {
  public:
    explicit TankSurfaces(const Tank& tank);
    void meet(const Ray& ray, SurfaceHit& hit) const;
    Ball ball() const;

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
