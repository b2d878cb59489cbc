// The glass in the middle of the window: shows the latest moment, turns around it, and lets milk be
// poured by mouse and pen.
#pragma once

#include "graphics/graphics_widget.hpp"
#include "session/tea_session.hpp"
#include "tea/tea_camera.hpp"
#include "tea/tea_renderer.hpp"

#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QTimer>

namespace pastoso::tea {

class TeaView : public graphics::GraphicsWidget {
    Q_OBJECT
  public:
    explicit TeaView(QWidget* parent = nullptr);
    ~TeaView() override;

    /// Shows this from the next frame on.
    void show_moment(std::shared_ptr<const session::TeaMoment> moment);

    /// Marks the axis of the force on the tea, while it is on.
    void show_force(const session::TeaForce& force);

    const TeaCamera& camera() const { return camera_; }
    void set_camera(const TeaCamera& camera);
    void look_from_front();

    /// Whether the frame on the screen is the final one of the latest moment.
    bool finished() const;

    /// What the latest frame showed; null before the first.
    const session::TeaMoment* shown() const { return shown_.get(); }

    /// Where a place of the tea's surface is seen on the widget.
    QPointF widget_position(const glm::vec2& on_tea_m) const;

  Q_SIGNALS:
    void poured(const glm::vec2& at_m);
    void pouring_ended();
    void camera_changed();

  protected:
    void make_graphics() override;
    void free_graphics() override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override { mousePressEvent(event); }
    void wheelEvent(QWheelEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void begin_anew();
    void draw_draft(QSize size);
    void refine(QSize size);
    void present(QSize size);
    void draw_marks();
    QSize device_size() const;
    void press(const QPointF& place, Qt::MouseButton button);
    void drag(const QPointF& place);
    void lift();
    std::optional<glm::vec2> on_tea(const QPointF& place) const;
    void set_cursor(const QPointF& place);

    TeaRenderer renderer_;
    TeaCamera camera_;
    std::shared_ptr<const session::TeaMoment> wanted_, shown_;
    session::TeaForce force_;
    std::unique_ptr<QOpenGLFramebufferObject> draft_, still_;
    double pixel_cost_s_ = 0.4e-6;  ///< learnt from the frames so far
    bool draft_is_due_ = true;
    int pass_ = 0, row_ = 0;  ///< of the still picture: what comes next
    QTimer resting_;          ///< nothing has moved for a while
    enum class Does { Nothing, Pour, Orbit };
    Does does_ = Does::Nothing;
    QPointF last_place_;
    std::optional<QPointF> pointer_;
};

}  // namespace pastoso::tea
