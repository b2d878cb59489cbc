// Light from afar: the lamp and the sky.
#pragma once

#include "trace/numbers.hpp"
#include "trace/scene.hpp"

#include <optional>

namespace pastoso::trace {

class Light {
  public:
    Light(const std::optional<Lamp>& lamp, const Sky& sky);

    bool has_lamp() const { return lamp_solid_angle_ > 0.0F; }
    const glm::vec3& lamp_radiance() const { return lamp_radiance_; }
    float lamp_solid_angle() const { return lamp_solid_angle_; }

    /// A direction towards the lamp, even over its disc, from two numbers in [0, 1).
    glm::vec3 towards_lamp(const glm::vec2& uniform) const;

    /// What comes from a direction, with the lamp or without.
    glm::vec3 from(const glm::vec3& direction, bool with_lamp) const;

  private:
    glm::vec3 lamp_axis_{0.0F, 0.0F, 1.0F}, lamp_radiance_{0.0F};
    float lamp_cosine_ = 2.0F, lamp_solid_angle_ = 0.0F;
    Sky sky_;
    glm::vec3 window_axis_;
    float window_cosine_, window_full_cosine_;
};

}  // namespace pastoso::trace
