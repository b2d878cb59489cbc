// A scene made ready for rays: surfaces, media and light.
#pragma once

#include "trace/light.hpp"
#include "trace/milk_medium.hpp"
#include "trace/optics.hpp"
#include "trace/triangle_rays.hpp"
#include "trace/vessel.hpp"

namespace pastoso::trace {

class World {
  public:
    /// The scene must have passed check_scene().
    explicit World(const Scene& scene);

    const Light& light() const { return light_; }
    const Optics& optics() const { return optics_; }

    const std::optional<CupSurfaces>& cup() const { return cup_; }
    std::optional<Ball> vessel_ball() const;
    bool is_in_milk(unsigned here) const;
    glm::vec3 milk_box_m() const { return medium_.size_m(); }
    /// Whether there is milk in a cup, and nothing but the cup bounds it.
    bool has_fluence() const { return cup_ && clear_liquid_.empty() && !medium_.empty(); }

    /// Where a ray that starts `here` is scattered by milk, or else what it meets.
    struct Event {
        float distance;
        float milk_m;  ///< in the mean, of it through milk, each place by its share
        bool is_scattering;
        SurfaceHit hit;
    };
    Event next_event(const Ray& ray, unsigned here, Sampler& sampler) const;

    /// What a ray that started `here` does where it has come to a clear surface.
    Crossing crossing(const Ray& ray, unsigned here, const SurfaceHit& hit) const;

    /// Whether a ray in air meets nothing at all.
    bool is_open(const Ray& ray) const;

    /// Of undissolved milk, solids or the table.
    glm::vec3 reflectance(SurfaceKind kind, const glm::vec3& point) const;

    float refractive_index(unsigned here) const {
        if ((here & kGlass) != 0) return optics_.glass_ior;
        return (here & kLiquid) != 0 ? optics_.liquid_ior : 1.0F;
    }

    /// By Beer's law, the liquid where it is no milk; milk absorbs where it scatters.
    glm::vec3 absorbed(unsigned here, float length_m, float milk_m = 0.0F) const;

    /// The share of the lamp's light that arrives at a point from `direction`, on a straight way through
    /// all that is clear; adds to `rays` what it took.
    glm::vec3 straight_transmittance(Ray ray, unsigned here, Sampler& sampler,
                                     std::uint64_t& rays) const;

  private:
    void meet_table(const Ray& ray, SurfaceHit& hit) const;
    bool meet_mesh(const TriangleRays& triangles, const Ray& ray, SurfaceHit& hit) const;
    bool dull_in_the_way(const Ray& ray, unsigned here, float length_m) const;
    float clearance_m(const Ray& ray) const;
    Event scattered_or_met(const Ray& ray, unsigned here, float distance_m) const;
    void meet_bodies(const Ray& ray, unsigned here, SurfaceHit& hit) const;
    SurfaceHit nearest_clear_hit(const Ray& ray, unsigned here) const;

    Optics optics_;
    std::optional<CupSurfaces> cup_;
    std::optional<TankSurfaces> tank_;
    std::optional<Table> table_;
    glm::vec2 middle_m_{0.0F};
    TriangleRays milk_, clear_liquid_, solids_;
    MilkMedium medium_;
    Light light_;
};

}  // namespace pastoso::trace
