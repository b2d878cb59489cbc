// One sample: a path of light, followed backwards from the camera.
#pragma once

#include "trace/denoise.hpp"
#include "trace/tracer.hpp"
#include "trace/world.hpp"

#include <array>

namespace pastoso::trace {

struct PathResult {
    glm::vec3 radiance{0.0F};
    std::array<float, kFeatures> features{};  ///< as in NoisyPicture
};

/// From the camera along `ray`, which begins in air.
PathResult follow_path(const World& world, const TraceSettings& settings, const Ray& ray,
                       Sampler& sampler, std::uint64_t& rays);

}  // namespace pastoso::trace
