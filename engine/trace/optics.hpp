// What surfaces and media do to a ray.
#pragma once

#include "trace/surfaces.hpp"

namespace pastoso::trace {

/// The share of unpolarised light that is reflected where it meets a plane boundary at `cosine` (0 to 1)
/// to the normal, from a medium of refractive index `from` to one of `to`; 1: total reflection.
inline float fresnel_reflectance(float cosine, float from, float to) {
    const float ratio = from / to;
    const float sine2 = ratio * ratio * std::max(0.0F, 1.0F - cosine * cosine);
    if (sine2 >= 1.0F) return 1.0F;
    const float beyond = std::sqrt(1.0F - sine2);
    const float s = (from * cosine - to * beyond) / (from * cosine + to * beyond);
    const float p = (to * cosine - from * beyond) / (to * cosine + from * beyond);
    return 0.5F * (s * s + p * p);
}

/// Directions are unit vectors, the normal points against `direction`.
inline glm::vec3 reflected(const glm::vec3& direction, const glm::vec3& normal) {
    return glm::normalize(direction - normal * (2.0F * glm::dot(direction, normal)));
}

/// By Snell's law, ratio = from / to of the refractive indices; there must be no total reflection.
inline glm::vec3 refracted(const glm::vec3& direction, const glm::vec3& normal, float ratio) {
    const float cosine = -glm::dot(direction, normal);
    const float beyond2 = 1.0F - ratio * ratio * (1.0F - cosine * cosine);
    return glm::normalize(direction * ratio +
                          normal * (ratio * cosine - std::sqrt(std::max(0.0F, beyond2))));
}

/// All directions alike, from two numbers in [0, 1).
inline glm::vec3 isotropic_direction(const glm::vec2& uniform) {
    const float z = 1.0F - 2.0F * uniform.x;
    const glm::vec2 turn = cos_sin_of_turns(uniform.y) * std::sqrt(std::max(0.0F, 1.0F - z * z));
    return glm::normalize(glm::vec3(turn, z));
}

/// As often as the cosine to the normal says, from two numbers in [0, 1).
inline glm::vec3 cosine_direction(const glm::vec3& normal, const glm::vec2& uniform) {
    const Frame frame(normal);
    const glm::vec2 turn = cos_sin_of_turns(uniform.y) * std::sqrt(uniform.x);
    return glm::normalize(frame.u * turn.x + frame.v * turn.y + normal * std::sqrt(1.0F - uniform.x));
}

/// Moved off a surface by so much, so that it is not met again.
inline constexpr float kLift_m = 1e-6F;

/// What a ray does that has come to a clear surface.
struct Crossing {
    glm::vec3 off;     ///< the surface's normal, against the ray
    glm::vec3 facing;  ///< the same, smoothed
    unsigned beyond;   ///< what is behind it
    float from, to;    ///< refractive indices
    float reflects;    ///< this share of the light

    Ray reflected_ray(const Ray& ray) const {
        return {ray.origin + off * kLift_m, reflected(ray.direction, facing)};
    }
    /// Straight on where both sides are of one index; there must be no total reflection.
    Ray refracted_ray(const Ray& ray) const {
        const glm::vec3 origin = ray.origin - off * kLift_m;
        if (from == to) return {origin, ray.direction};
        return {origin, refracted(ray.direction, facing, from / to)};
    }
};

/// What a ray does that has come to a dull surface: it goes on in any direction off it, by the cosine.
struct DullBounce {
    DullBounce(const Ray& before, const SurfaceHit& hit)
        : off(glm::dot(hit.normal, before.direction) > 0.0F ? -hit.normal : hit.normal),
          normal(glm::dot(hit.shading, before.direction) > 0.0F ? -hit.shading : hit.shading),
          origin(before.origin + normal * (2.0F * kLift_m)) {}

    Ray ray(const glm::vec2& uniform) const {
        const glm::vec3 direction = cosine_direction(normal, uniform);
        // A smoothed normal may point a way below the triangle: light is not to be lost within the body.
        return {origin, glm::dot(direction, off) < 0.0F ? reflected(direction, off) : direction};
    }

    glm::vec3 off, normal;  ///< the surface's own and its smoothed normal, against the ray
    glm::vec3 origin;       ///< where it goes on from
};

}  // namespace pastoso::trace
