#include "trace/world.hpp"

#include "trace/optics.hpp"

namespace pastoso::trace {
namespace {

/// A straight shadow ray crosses no more clear surfaces than this; beyond them it is dark.
constexpr int kMostCrossings = 16;
/// Below this share a shadow ray is taken for dark.
constexpr float kDark = 1e-4F;
/// What passes where a straight way would be totally reflected: about what bent ways bring there.
constexpr float kPassesTotalReflection = 0.4F;

MeshRay mesh_ray(const Ray& ray, float farthest) {
    return {ray.origin, ray.direction, kNearest_m, farthest};
}

glm::vec2 middle_of(const Scene& scene) {
    if (scene.cup) return scene.cup->axis_m;
    if (scene.tank) return 0.5F * glm::vec2(scene.tank->inner_low_m + scene.tank->inner_high_m);
    return {0.0F, 0.0F};
}

}  // namespace

World::World(const Scene& scene)
    : optics_(scene.optics),
      table_(scene.table),
      middle_m_(middle_of(scene)),
      milk_(scene.milk),
      clear_liquid_(scene.clear_liquid),
      solids_(scene.solids),
      milk_share_(scene.milk_share, scene.optics.milk_scattering_per_m),
      light_(scene.lamp, scene.sky) {
    if (scene.cup) cup_.emplace(*scene.cup);
    if (scene.tank) tank_.emplace(*scene.tank);
}

void World::meet_table(const Ray& ray, SurfaceHit& hit) const {
    const float t = (table_->height_m - ray.origin.z) / ray.direction.z;
    if (!(t > kNearest_m && t < hit.distance)) return;
    const glm::vec2 place = glm::vec2(ray.origin) + glm::vec2(ray.direction) * t - middle_m_;
    if (glm::dot(place, place) > table_->radius_m * table_->radius_m) return;
    hit.distance = t;
    hit.kind = SurfaceKind::Table;
    hit.normal = hit.shading = {0.0F, 0.0F, 1.0F};
}

bool World::meet_mesh(const TriangleRays& triangles, const Ray& ray, SurfaceHit& hit) const {
    const MeshHit met = triangles.closest(mesh_ray(ray, hit.distance));
    if (met.triangle == kNoTriangle) return false;
    const liquid::TriangleMesh& mesh = triangles.mesh();
    const auto& [a, b, c] = mesh.triangles[met.triangle];
    const glm::vec3 &pa = mesh.positions_m[a], &pb = mesh.positions_m[b], &pc = mesh.positions_m[c];
    hit.distance = met.distance;
    // A sliver may have no area that can be computed; any side of it will do.
    const glm::vec3 across = glm::cross(pb - pa, pc - pa);
    const float across2 = glm::dot(across, across);
    hit.normal = across2 > 1e-36F ? across / std::sqrt(across2) : -ray.direction;
    hit.shading = hit.normal;
    if (mesh.normals.empty()) return true;
    const glm::vec3 smooth = mesh.normals[a] * (1.0F - met.second - met.third) +
                             mesh.normals[b] * met.second + mesh.normals[c] * met.third;
    const float length2 = glm::dot(smooth, smooth);
    if (length2 > 1e-12F) hit.shading = smooth / std::sqrt(length2);
    return true;
}

SurfaceHit World::nearest_clear_hit(const Ray& ray, unsigned here) const {
    SurfaceHit hit;
    if (cup_) cup_->meet(ray, here, hit);
    if (tank_) tank_->meet(ray, hit);
    if (!clear_liquid_.empty() && meet_mesh(clear_liquid_, ray, hit)) {
        hit.kind = SurfaceKind::Clear;
        hit.decided = hit.inner = kLiquid;
        hit.outer = kAir;
    }
    return hit;
}

void World::meet_bodies(const Ray& ray, unsigned here, SurfaceHit& hit) const {
    if (!solids_.empty() && meet_mesh(solids_, ray, hit)) hit.kind = SurfaceKind::Solid;
    if ((here & kGlass) == 0 && !milk_.empty() && meet_mesh(milk_, ray, hit))
        hit.kind = SurfaceKind::Milk;
}

/// In cloudy tea light does not get far, and the bodies' many triangles are asked for that way alone.
World::Event World::next_event(const Ray& ray, unsigned here, Sampler& sampler) const {
    SurfaceHit hit = nearest_clear_hit(ray, here);
    if (table_) meet_table(ray, hit);
    const DissolvedMilk::FreePath free = free_path(ray, here, hit.distance, sampler);
    if (free.length_m < hit.distance) {
        SurfaceHit nearer;
        nearer.distance = free.length_m;
        meet_bodies(ray, here, nearer);
        return {nearer.distance, free.milk_m, nearer.kind == SurfaceKind::None, nearer};
    }
    meet_bodies(ray, here, hit);
    return {hit.distance, free.milk_m, false, hit};
}

glm::vec3 World::reflectance(SurfaceKind kind, const glm::vec3& point) const {
    if (kind == SurfaceKind::Milk) return optics_.milk_reflectance;
    if (kind == SurfaceKind::Solid) return optics_.solid_reflectance;
    const glm::vec2 place = glm::vec2(point) - middle_m_;
    const float near = fast_exp(-table_->fading_per_m2 * glm::dot(place, place));
    return table_->reflectance * (table_->fading_to + (1.0F - table_->fading_to) * near);
}

glm::vec3 World::absorbed(unsigned here, float length_m, float milk_m) const {
    if ((here & kGlass) != 0) return fast_exp(optics_.glass_absorption_per_m * -length_m);
    if ((here & kLiquid) == 0) return glm::vec3(1.0F);
    return fast_exp(optics_.tea_absorption_per_m * -std::max(length_m - milk_m, 0.0F));
}

DissolvedMilk::FreePath World::free_path(const Ray& ray, unsigned here, float limit_m,
                                         Sampler& sampler) const {
    if ((here & kGlass) != 0 || (here & kLiquid) == 0 || milk_share_.empty()) return {limit_m, 0.0F};
    return milk_share_.free_path(ray.origin, ray.direction, limit_m, sampler);
}

bool World::dull_in_the_way(const Ray& ray, unsigned here, float length_m) const {
    if (!solids_.empty() && solids_.anything_between(mesh_ray(ray, length_m))) return true;
    return (here & kGlass) == 0 && milk_.anything_between(mesh_ray(ray, length_m));
}

glm::vec3 World::straight_transmittance(Ray ray, unsigned here, Sampler& sampler,
                                        std::uint64_t& rays) const {
    glm::vec3 share(1.0F);
    for (int crossing = 0; crossing < kMostCrossings; ++crossing) {
        ++rays;
        SurfaceHit hit = nearest_clear_hit(ray, here);
        if (table_) meet_table(ray, hit);
        if (hit.kind == SurfaceKind::Table || dull_in_the_way(ray, here, hit.distance))
            return glm::vec3(0.0F);
        if (hit.kind == SurfaceKind::None) return share;
        share *= absorbed(here, hit.distance);
        if ((here & kGlass) == 0 && (here & kLiquid) != 0 && !milk_share_.empty())
            share *= milk_share_.transmittance(ray.origin, ray.direction, hit.distance, sampler);
        if (largest(share) < kDark) return glm::vec3(0.0F);
        const unsigned beyond = hit.beyond(here, ray.direction);
        const float from = refractive_index(here), to = refractive_index(beyond);
        if (from != to) {
            const float lost =
                fresnel_reflectance(std::abs(glm::dot(ray.direction, hit.shading)), from, to);
            share *= lost < 1.0F ? 1.0F - lost : kPassesTotalReflection;
        }
        here = beyond;
        ray.origin += ray.direction * hit.distance;
    }
    return glm::vec3(0.0F);
}

}  // namespace pastoso::trace
