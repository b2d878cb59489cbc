// The tank in the middle of the window: shows the latest moment, and lets balls of liquid fall where it
// is pressed.
#pragma once

#include "glass/glass_view.hpp"
#include "glass/tank_renderer.hpp"

namespace pastoso::glass {

class TankView : public GlassView {
    Q_OBJECT
  public:
    explicit TankView(QWidget* parent = nullptr);
    ~TankView() override;

    /// Shows this from the next frame on.
    void show_moment(std::shared_ptr<const session::TankSnapshot> snapshot);
    void show_wind(const session::TankWind& wind);
    void show_velocity(bool shown);
    bool velocity_shown() const { return velocity_shown_; }
    /// Of the ball that a press lets fall.
    void set_ball_radius(float radius_m);

    void look_from_front() override;

    /// What the latest frame showed; null before the first.
    const session::TankSnapshot* shown() const { return shown_.get(); }

    /// Where a place of the liquid at rest is seen on the widget.
    QPointF widget_position(const glm::vec2& on_liquid_m) const { return seen(on_surface(on_liquid_m)); }

  Q_SIGNALS:
    /// A ball shall fall there.
    void ball_wanted(const glm::vec2& at_m);

  protected:
    LiquidRenderer& renderer() override { return renderer_; }
    void show_latest() override;
    void draw_marks(QPainter& painter, const std::optional<QPointF>& pointer) override;
    bool is_over_liquid(const QPointF& place) const override { return on_liquid(place).has_value(); }
    void press_liquid(const QPointF& place) override;

  private:
    std::optional<glm::vec2> on_liquid(const QPointF& place) const;
    glm::vec3 on_surface(const glm::vec2& on_liquid_m) const;
    void draw_velocity(QPainter& painter) const;
    void draw_drains(QPainter& painter) const;
    void draw_wind(QPainter& painter) const;

    TankRenderer renderer_;
    std::shared_ptr<const session::TankSnapshot> wanted_, shown_;
    session::TankWind wind_;
    bool velocity_shown_ = false;
    float ball_radius_m_ = 0.0F;
};

}  // namespace pastoso::glass
