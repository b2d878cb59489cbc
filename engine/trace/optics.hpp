// What a clear surface does to a ray.
#pragma once

#include "trace/numbers.hpp"

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

}  // namespace pastoso::trace
