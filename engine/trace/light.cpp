#include "trace/light.hpp"

#include "core/units.hpp"

namespace pastoso::trace {
namespace {

/// The window is even within this share of its radius.
constexpr float kEvenShare = 0.75F;

float cosine_of_degrees(float degrees) {
    return cos_sin_of_turns(degrees / 360.0F).x;
}

}  // namespace

Light::Light(const std::optional<Lamp>& lamp, const Sky& sky)
    : sky_(sky),
      window_axis_(glm::normalize(sky.window_towards)),
      window_cosine_(cosine_of_degrees(sky.window_radius_deg)),
      window_full_cosine_(cosine_of_degrees(kEvenShare * sky.window_radius_deg)) {
    if (!lamp) return;
    lamp_axis_ = glm::normalize(lamp->towards);
    lamp_radiance_ = lamp->radiance;
    lamp_cosine_ = cosine_of_degrees(lamp->radius_deg);
    lamp_solid_angle_ = 2.0F * kPi * (1.0F - lamp_cosine_);
}

glm::vec3 Light::towards_lamp(const glm::vec2& uniform) const {
    const float cosine = 1.0F - uniform.x * (1.0F - lamp_cosine_);
    const float sine = std::sqrt(std::max(0.0F, 1.0F - cosine * cosine));
    const glm::vec2 turn = cos_sin_of_turns(uniform.y) * sine;
    const Frame frame(lamp_axis_);
    return glm::normalize(frame.u * turn.x + frame.v * turn.y + lamp_axis_ * cosine);
}

glm::vec3 Light::from(const glm::vec3& direction, bool with_lamp) const {
    // The lamp hides the sky behind it.
    if (glm::dot(direction, lamp_axis_) > lamp_cosine_)
        return with_lamp ? lamp_radiance_ : glm::vec3(0.0F);
    const float height = 0.5F * (direction.z + 1.0F);
    const float in_window = std::clamp(
        (glm::dot(direction, window_axis_) - window_cosine_) / (window_full_cosine_ - window_cosine_),
        0.0F, 1.0F);
    return sky_.below * (1.0F - height) + sky_.above * height +
           sky_.window_radiance * (in_window * in_window * (3.0F - 2.0F * in_window));
}

}  // namespace pastoso::trace
