// One sample: a path of light, followed backwards from the camera.
#pragma once

#include "trace/denoise.hpp"
#include "trace/photons.hpp"
#include "trace/tracer.hpp"
#include "trace/world.hpp"

#include <array>

namespace pastoso::trace {

struct PathResult {
    glm::vec3 radiance{0.0F};
    std::array<float, kFeatures> features{};  ///< as in NoisyPicture
};

/// What there is to trace. Where photons have left their light, it is taken from there.
struct Lit {
    const World& world;
    const TraceSettings& settings;
    const PhotonMaps& maps;
};

/// From the camera along `ray`, which begins in air.
PathResult follow_path(const Lit& lit, const Ray& ray, Sampler& sampler, std::uint64_t& rays);

/// What comes along `ray` backwards, but for the lamp's own light straight from it.
glm::vec3 radiance_besides_lamp(const Lit& lit, const Ray& ray, Sampler& sampler);

}  // namespace pastoso::trace
