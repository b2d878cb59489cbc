// From pixels to rays: a thin lens that is sharp at the distance of its target.
#pragma once

#include "trace/sampler.hpp"
#include "trace/scene.hpp"
#include "trace/surfaces.hpp"

namespace pastoso::trace {

class CameraRays {
  public:
    CameraRays(const Camera& camera, int width, int height)
        : camera_(camera), width_(width), height_(height) {
        const glm::vec3 way = camera.target_m - camera.eye_m;
        sharp_m_ = glm::length(way);
        forward_ = way / sharp_m_;
        // Straight up or down there is no level; then the picture's right is x.
        const glm::vec3 side = glm::cross(forward_, glm::vec3(0.0F, 0.0F, 1.0F));
        right_ = glm::dot(side, side) > 1e-10F ? glm::normalize(side) : glm::vec3(1.0F, 0.0F, 0.0F);
        up_ = glm::cross(right_, forward_);
        const glm::vec2 half = cos_sin_of_turns(camera.field_of_view_deg / 720.0F);
        half_height_ = half.y / half.x;
    }

    /// Through pixel (x, y), counted from the upper left.
    Ray through(int x, int y, Sampler& sampler) const {
        const glm::vec2 in_pixel = sampler.pair(), in_lens = sampler.pair();
        const float scale = 2.0F * half_height_ / static_cast<float>(height_);
        const float across =
            (static_cast<float>(x) + tent(in_pixel.x) - 0.5F * static_cast<float>(width_)) * scale;
        const float down =
            (static_cast<float>(y) + tent(in_pixel.y) - 0.5F * static_cast<float>(height_)) * scale;
        const glm::vec3 aim = forward_ + right_ * across - up_ * down;
        const glm::vec2 turn =
            cos_sin_of_turns(in_lens.y) * (std::sqrt(in_lens.x) * camera_.lens_radius_m);
        const glm::vec3 shift = right_ * turn.x + up_ * turn.y;
        return {camera_.eye_m + shift, glm::normalize(aim * sharp_m_ - shift)};
    }

  private:
    /// From an even number in [0, 1) to a place about 0.5, distributed as a tent that is two thirds of
    /// a pixel wide on each side: edges are smoother than with the pixel's square.
    static float tent(float uniform) {
        constexpr float kReach = 0.6667F;
        const bool left = uniform < 0.5F;
        const float share = std::sqrt(left ? 2.0F * uniform : 2.0F - 2.0F * uniform);
        return 0.5F + (left ? share - 1.0F : 1.0F - share) * kReach;
    }

    Camera camera_;
    int width_, height_;
    glm::vec3 forward_, right_, up_;
    float sharp_m_, half_height_;
};

}  // namespace pastoso::trace
