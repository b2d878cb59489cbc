#include "glass/glass_camera.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace pastoso::glass {
namespace {

constexpr double kField_deg = 24.0;
constexpr double kFirstAzimuth_deg = -77.0, kFirstElevation_deg = 20.0;
constexpr double kLeastElevation_deg = 1.5, kMostElevation_deg = 86.0;
/// In heights of the glass.
constexpr double kFirstDistance = 3.85, kLeastDistance = 1.2, kMostDistance = 9.0;

double radians(double degrees) {
    return degrees * core::kPi / 180.0;
}

}  // namespace

GlassCamera::GlassCamera(const liquid::Cup& cup)
    : GlassCamera(glm::vec3(cup.axis_m, 0.47F * (cup.rim_m + cup.foot_m)),
                  static_cast<double>(cup.rim_m - cup.foot_m)) {}

GlassCamera::GlassCamera(const glm::vec3& middle_m, double height_m)
    : target_m_(middle_m),
      height_m_(height_m),
      azimuth_deg_(kFirstAzimuth_deg),
      elevation_deg_(kFirstElevation_deg),
      distance_m_(kFirstDistance * height_m) {}

void GlassCamera::orbit(double right_deg, double up_deg) {
    azimuth_deg_ = std::remainder(azimuth_deg_ + right_deg, 360.0);
    elevation_deg_ = std::clamp(elevation_deg_ + up_deg, kLeastElevation_deg, kMostElevation_deg);
}

void GlassCamera::zoom(double factor) {
    distance_m_ =
        std::clamp(distance_m_ / factor, kLeastDistance * height_m_, kMostDistance * height_m_);
}

trace::Camera GlassCamera::traced() const {
    return {
        .eye_m = eye_m(), .target_m = target_m_, .field_of_view_deg = static_cast<float>(kField_deg)};
}

glm::vec3 GlassCamera::forward() const {
    const double level = std::cos(radians(elevation_deg_));
    return -glm::vec3(level * std::cos(radians(azimuth_deg_)), level * std::sin(radians(azimuth_deg_)),
                      std::sin(radians(elevation_deg_)));
}

glm::vec3 GlassCamera::eye_m() const {
    return target_m_ - forward() * static_cast<float>(distance_m_);
}

glm::vec3 GlassCamera::right() const {
    return glm::normalize(glm::cross(forward(), glm::vec3(0.0F, 0.0F, 1.0F)));
}

glm::vec3 GlassCamera::up() const {
    return glm::cross(right(), forward());
}

float GlassCamera::half_height() const {
    return static_cast<float>(std::tan(radians(0.5 * kField_deg)));
}

ViewRay GlassCamera::through(const QPointF& place, const QSizeF& size) const {
    const double scale = 2.0 * static_cast<double>(half_height()) / size.height();
    const auto across = static_cast<float>((place.x() - 0.5 * size.width()) * scale);
    const auto down = static_cast<float>((place.y() - 0.5 * size.height()) * scale);
    return {eye_m(), glm::normalize(forward() + right() * across - up() * down)};
}

QPointF GlassCamera::seen_at(const glm::vec3& point_m, const QSizeF& size) const {
    const glm::vec3 way = point_m - eye_m();
    const double scale = size.height() / (2.0 * static_cast<double>(half_height()));
    const double depth = static_cast<double>(std::max(glm::dot(way, forward()), 1e-4F));
    return {0.5 * size.width() + scale * static_cast<double>(glm::dot(way, right())) / depth,
            0.5 * size.height() - scale * static_cast<double>(glm::dot(way, up())) / depth};
}

glm::mat4 GlassCamera::clip_from_m(float aspect) const {
    const auto far = static_cast<float>(4.0 * distance_m_);
    return glm::perspective(static_cast<float>(radians(kField_deg)), aspect, 0.004F * far, far) *
           glm::lookAt(eye_m(), target_m_, glm::vec3(0.0F, 0.0F, 1.0F));
}

std::optional<glm::vec2> place_on_tea(const ViewRay& ray, const liquid::Cup& cup) {
    constexpr float kBeside = 1.1F, kOffTheWall = 0.96F;
    const float along = (cup.level_m - ray.origin_m.z) / ray.direction.z;
    if (!(along > 0.0F)) return std::nullopt;
    const glm::vec2 from_axis = glm::vec2(ray.origin_m + ray.direction * along) - cup.axis_m;
    const float radius = cup.inner_radius_m(cup.level_m), distance = glm::length(from_axis);
    if (distance > kBeside * radius) return std::nullopt;
    const float most = kOffTheWall * radius;
    return cup.axis_m + (distance > most ? from_axis * (most / distance) : from_axis);
}

}  // namespace pastoso::glass
