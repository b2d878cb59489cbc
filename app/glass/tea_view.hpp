// The glass of tea in the middle of the window: shows the latest moment, and lets milk be poured by
// mouse and pen.
#pragma once

#include "glass/glass_view.hpp"
#include "glass/tea_renderer.hpp"
#include "session/tea_session.hpp"

#include <memory>

namespace pastoso::glass {

class TeaView : public GlassView {
    Q_OBJECT
  public:
    explicit TeaView(QWidget* parent = nullptr);
    ~TeaView() override;

    /// Shows this from the next frame on.
    void show_moment(std::shared_ptr<const session::TeaSnapshot> snapshot);

    /// Marks the axis of the force on the tea, while it is on.
    void show_force(const session::TeaForce& force);

    void look_from_front() override;

    /// What the latest frame showed; null before the first.
    const session::TeaSnapshot* shown() const { return shown_.get(); }

    /// Where a place of the tea's surface is seen on the widget.
    QPointF widget_position(const glm::vec2& on_tea_m) const { return seen(on_surface(on_tea_m)); }

  Q_SIGNALS:
    void poured(const glm::vec2& at_m);
    void pouring_ended();

  protected:
    LiquidRenderer& renderer() override { return renderer_; }
    void show_latest() override;
    void draw_marks(QPainter& painter, const std::optional<QPointF>& pointer) override;
    bool is_over_liquid(const QPointF& place) const override { return on_tea(place).has_value(); }
    void press_liquid(const QPointF& place) override;
    /// Who pours past the glass goes on pouring where it was left.
    void drag_liquid(const QPointF& place) override { press_liquid(place); }
    void lift_from_liquid() override { Q_EMIT pouring_ended(); }

  private:
    std::optional<glm::vec2> on_tea(const QPointF& place) const;
    glm::vec3 on_surface(const glm::vec2& on_tea_m) const;

    TeaRenderer renderer_;
    std::shared_ptr<const session::TeaSnapshot> wanted_, shown_;
    session::TeaForce force_;
};

}  // namespace pastoso::glass
