#include "trace/world.hpp"

#include "trace/wood.hpp"

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
      medium_(scene.milk_share, scene.optics.milk_scattering_per_m),
      light_(scene.lamp, scene.sky) {
    if (scene.cup) cup_.emplace(*scene.cup, scene.dents);
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

/// What there is before a ray is scattered after `distance_m`. In cloudy tea light does not get far, and
/// the bodies' many triangles are asked for that way alone.
World::Event World::scattered_or_met(const Ray& ray, unsigned here, float distance_m) const {
    SurfaceHit nearer;
    nearer.distance = distance_m;
    meet_bodies(ray, here, nearer);
    const bool is_scattering = nearer.kind == SurfaceKind::None;
    // The scatterings along a way have the integral of the scattering as their mean (Campbell 1909).
    return {nearer.distance, is_scattering ? 1.0F / medium_.scattering_per_m() : 0.0F, is_scattering,
            nearer};
}

World::Event World::next_event(const Ray& ray, unsigned here, Sampler& sampler) const {
    const bool in_milk = is_in_milk(here);
    // In thick milk most ways end before any surface can be near.
    const float open_m = in_milk ? clearance_m(ray) : 0.0F;
    if (open_m > 0.0F) {
        const float free_m = medium_.free_path(ray.origin, ray.direction, open_m, sampler);
        if (free_m < open_m) return scattered_or_met(ray, here, free_m);
    }
    SurfaceHit hit = nearest_clear_hit(ray, here);
    if (table_) meet_table(ray, hit);
    if (in_milk && open_m < hit.distance) {
        const float free_m = open_m + medium_.free_path(ray.origin + ray.direction * open_m,
                                                        ray.direction, hit.distance - open_m, sampler);
        if (free_m < hit.distance) return scattered_or_met(ray, here, free_m);
    }
    meet_bodies(ray, here, hit);
    return {hit.distance, 0.0F, false, hit};
}

glm::vec3 World::reflectance(SurfaceKind kind, const glm::vec3& point) const {
    if (kind == SurfaceKind::Milk) return optics_.milk_reflectance;
    if (kind == SurfaceKind::Solid) return optics_.solid_reflectance;
    const glm::vec2 place = glm::vec2(point) - middle_m_;
    const float near = fast_exp(-table_->fading_per_m2 * glm::dot(place, place));
    const float grain = table_->is_wood ? wood_grain(place) : 1.0F;
    return table_->reflectance * (grain * (table_->fading_to + (1.0F - table_->fading_to) * near));
}

glm::vec3 World::absorbed(unsigned here, float length_m, float milk_m) const {
    if ((here & kGlass) != 0) return fast_exp(optics_.glass_absorption_per_m * -length_m);
    if ((here & kLiquid) == 0) return glm::vec3(1.0F);
    return fast_exp(optics_.tea_absorption_per_m * -(length_m - milk_m));
}

std::optional<Ball> World::vessel_ball() const {
    if (cup_) return cup_->ball();
    if (tank_) return tank_->ball();
    return std::nullopt;
}

Crossing World::crossing(const Ray& ray, unsigned here, const SurfaceHit& hit) const {
    const glm::vec3& before = ray.direction;
    Crossing crossing;
    crossing.beyond = hit.beyond(here, before);
    crossing.from = refractive_index(here);
    crossing.to = refractive_index(crossing.beyond);
    crossing.off = glm::dot(hit.normal, before) > 0.0F ? -hit.normal : hit.normal;
    crossing.facing = glm::dot(hit.shading, before) > 0.0F ? -hit.shading : hit.shading;
    crossing.reflects =
        crossing.from == crossing.to
            ? 0.0F
            : fresnel_reflectance(-glm::dot(before, crossing.facing), crossing.from, crossing.to);
    return crossing;
}

bool World::is_open(const Ray& ray) const {
    SurfaceHit hit = nearest_clear_hit(ray, kAir);
    if (table_) meet_table(ray, hit);
    return hit.kind == SurfaceKind::None && !dull_in_the_way(ray, kAir, kFar);
}

bool World::is_in_milk(unsigned here) const {
    return (here & kGlass) == 0 && (here & kLiquid) != 0 && !medium_.empty();
}

/// A way within the liquid on which a ray meets no clear surface.
float World::clearance_m(const Ray& ray) const {
    if (!cup_ || !clear_liquid_.empty()) return 0.0F;
    return std::max(0.0F, cup_->clearance_m(ray.origin));
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
        const bool in_milk = is_in_milk(here);
        const float open_m = in_milk ? clearance_m(ray) : 0.0F;
        if (open_m > 0.0F) share *= medium_.transmittance(ray.origin, ray.direction, open_m, sampler);
        if (largest(share) < kDark) return glm::vec3(0.0F);
        SurfaceHit hit = nearest_clear_hit(ray, here);
        if (table_) meet_table(ray, hit);
        if (hit.kind == SurfaceKind::Table || dull_in_the_way(ray, here, hit.distance))
            return glm::vec3(0.0F);
        if (hit.kind == SurfaceKind::None) return share;
        share *= absorbed(here, hit.distance);
        if (in_milk && open_m < hit.distance)
            share *= medium_.transmittance(ray.origin + ray.direction * open_m, ray.direction,
                                           hit.distance - open_m, sampler);
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
