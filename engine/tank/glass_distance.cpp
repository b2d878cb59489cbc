#include "tank/glass_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/geometric.hpp>

namespace pastoso::tank {
namespace {

float distance2(const glm::vec2& from, const glm::vec2& to, const glm::vec2& point) {
    const glm::vec2 along = to - from, away = point - from;
    const float share = std::clamp(glm::dot(away, along) / glm::dot(along, along), 0.0F, 1.0F);
    const glm::vec2 rest = away - share * along;
    return glm::dot(rest, rest);
}

}  // namespace

GlassDistance::GlassDistance(const liquid::Cup& cup)
    : cup_(cup),
      outline_m_{{{0.0F, cup.foot_m},
                  {cup.inner_radius_m(cup.foot_m) + cup.wall_m, cup.foot_m},
                  {cup.inner_radius_m(cup.rim_m) + cup.wall_m, cup.rim_m},
                  {cup.inner_radius_m(cup.rim_m), cup.rim_m},
                  {cup.floor_radius_m, cup.floor_m},
                  {0.0F, cup.floor_m}}} {}

float GlassDistance::operator()(const glm::vec3& point_m) const {
    const float radius = glm::length(glm::vec2(point_m) - cup_.axis_m), z = point_m.z;
    float nearest2 = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i + 1 < outline_m_.size(); ++i)
        nearest2 = std::min(nearest2, distance2(outline_m_[i], outline_m_[i + 1], {radius, z}));
    const float inner = cup_.inner_radius_m(z);
    const bool inside = z >= cup_.floor_m && radius < inner;
    const bool in_glass = z >= cup_.foot_m && z <= cup_.rim_m && radius < inner + cup_.wall_m;
    return in_glass && !inside ? -std::sqrt(nearest2) : std::sqrt(nearest2);
}

}  // namespace pastoso::tank
