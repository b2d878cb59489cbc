// A liquid in the middle of the window, and the hand over it: a draft at once when something moves, as
// coarse as this machine needs, and when nothing moves any more the picture in full quality, strip by
// strip. Dragging beside the liquid, or with another button, turns around it; the wheel comes closer.
#pragma once

#include "core/units.hpp"
#include "glass/liquid_renderer.hpp"
#include "graphics/graphics_widget.hpp"
#include "graphics/picture_finish.hpp"

#include <optional>

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>

class QPainter;

namespace pastoso::glass {

class GlassView : public graphics::GraphicsWidget {
    Q_OBJECT
  public:
    explicit GlassView(QWidget* parent = nullptr);

    const GlassCamera& camera() const { return camera_; }
    void set_camera(const GlassCamera& camera);
    virtual void look_from_front() = 0;

    /// Whether the frame on the screen is the final one of the latest moment.
    bool finished() const;
    /// That frame as a picture, without the pointer's mark; its colours are the liquid's, and not those
    /// that the screen is to be given for them.
    QImage picture();
    /// Whether the final frame follows a draft at once, and not only when nothing has moved for a while;
    /// its edges are then a little less smooth.
    void set_hurried(bool hurried);

  Q_SIGNALS:
    void camera_changed();
    /// While the frame is drawn with which finished() comes true.
    void picture_finished();

  protected:
    virtual LiquidRenderer& renderer() = 0;
    /// Has the renderer show the latest moment; called with the current context.
    virtual void show_latest() = 0;
    /// Over the picture. `pointer`: where the hand is that does nothing yet.
    virtual void draw_marks(QPainter& painter, const std::optional<QPointF>& pointer) = 0;

    // What the hand does to the liquid.
    virtual bool is_over_liquid(const QPointF& place) const = 0;
    virtual void press_liquid(const QPointF& place) = 0;
    virtual void drag_liquid(const QPointF&) {}
    virtual void lift_from_liquid() {}

    /// There is another moment to be seen.
    void take_moment();

    /// Where a point is seen on the widget, and a ring or a part of one that lies level in the liquid.
    QPointF seen(const glm::vec3& at_m) const { return camera_.seen_at(at_m, size()); }
    QPainterPath seen_ring(const glm::vec3& middle_m, double radius_m, double from_rad = 0.0,
                           double to_rad = 2.0 * core::kPi) const;

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
    void compose(QSize size);
    void present(QSize size);
    void put_marks_over(QSize size);
    QSize device_size() const;
    void press(const QPointF& place, Qt::MouseButton button);
    void drag(const QPointF& place);
    void lift();
    void set_cursor(const QPointF& place);

    GlassCamera camera_;
    bool has_moment_ = false, shows_latest_ = false;
    std::unique_ptr<QOpenGLFramebufferObject> draft_, still_;
    std::unique_ptr<QOpenGLFramebufferObject> seen_;  ///< what there is of both, its top row first
    graphics::PictureFinish finish_;
    bool for_screen_ = true;        ///< else the frame is a picture to be kept
    double pixel_cost_s_ = 0.4e-6;  ///< learnt from the frames so far
    bool draft_is_due_ = true;
    int pass_ = 0, row_ = 0;  ///< of the still picture: what comes next
    int passes_;              ///< that it has
    QTimer resting_;          ///< nothing has moved for a while
    enum class Does { Nothing, Pour, Orbit };
    Does does_ = Does::Nothing;
    QPointF last_place_;
    std::optional<QPointF> pointer_;
};

/// Strokes a line so that it is seen over anything.
void stroke_mark(QPainter& painter, const QPainterPath& path, double opacity);

}  // namespace pastoso::glass
