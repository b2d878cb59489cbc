// Where the glass is looked at from: on a sphere around its middle.
#pragma once

#include "liquid/vessel/cup.hpp"
#include "trace/scene.hpp"

#include <optional>

#include <QPointF>
#include <QSizeF>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pastoso::glass {

struct ViewRay {
    glm::vec3 origin_m, direction;
};

class GlassCamera {
  public:
    /// The whole glass from the front, a little from above.
    explicit GlassCamera(const liquid::Cup& cup = {});
    /// The same of anything that is about so high.
    GlassCamera(const glm::vec3& middle_m, double height_m);

    /// By angles on the sphere; never from below the table, nor quite from above.
    void orbit(double right_deg, double up_deg);
    /// > 1: closer.
    void zoom(double factor);

    /// As the tracer takes it.
    trace::Camera traced() const;

    glm::vec3 eye_m() const;
    glm::vec3 target_m() const { return target_m_; }
    glm::vec3 forward() const;
    glm::vec3 right() const;
    glm::vec3 up() const;
    float half_height() const;  ///< of the picture, at distance 1
    double azimuth_deg() const { return azimuth_deg_; }

    /// Places on a widget of that size, from its upper left corner.
    ViewRay through(const QPointF& place, const QSizeF& size) const;
    QPointF seen_at(const glm::vec3& point_m, const QSizeF& size) const;

    /// To OpenGL's clip space.
    glm::mat4 clip_from_m(float aspect) const;

    friend bool operator==(const GlassCamera&, const GlassCamera&) = default;

  private:
    glm::vec3 target_m_;
    double height_m_;
    double azimuth_deg_, elevation_deg_, distance_m_;
};

/// Where a ray meets the tea's surface, as far as it lies within the glass or a tenth of its radius
/// beside it, then taken to the wall.
std::optional<glm::vec2> place_on_tea(const ViewRay& ray, const liquid::Cup& cup);

}  // namespace pastoso::glass
