// The window's canvas, or its mixing well: shows the latest snapshot, from near or far, and hands pen,
// mouse and fingers to its interactions.
#pragma once

#include "document/painting.hpp"
#include "input/arbiter.hpp"
#include "input/event_reader.hpp"
#include "input/touch_gestures.hpp"
#include "input/wheel_steps.hpp"
#include "screen/canvas_screen.hpp"
#include "view/interaction_stack.hpp"
#include "view/masking_skin.hpp"
#include "view/pen_watch.hpp"
#include "view/selection_outline.hpp"

#include <memory>
#include <optional>

#include <QTimer>

class QTouchEvent;

namespace pastoso::view {

class LookLegend;

class CanvasView : public QWidget, private screen::ScreenHost {
    Q_OBJECT
  public:
    explicit CanvasView(document::Surface surface = document::Surface::Canvas,
                        QWidget* parent = nullptr);
    ~CanvasView() override;

    /// Shows this from the next frame on. A snapshot of another canvas is shown whole, but one of the
    /// same canvas cut or made larger, where what lay on it came to lie so much further from the corner,
    /// shows what was there where it was.
    void show_snapshot(std::shared_ptr<const document::Snapshot> snapshot,
                       std::optional<glm::dvec2> shift_mm = {});
    void set_lighting(const shade::Lighting& lighting);
    void set_look(screen::Look look);
    screen::Look look() const { return look_; }
    const LookLegend& legend() const { return *legend_; }
    void set_viewing(const pigment::Viewing& viewing);
    void set_pen(const tools::PenSettings& pen) { reader_.set_pen(pen); }
    const tools::PenSettings& pen() const { return reader_.pen(); }

    /// At first what is fastest here.
    void set_drawn_by(screen::DrawnBy drawn_by);

    /// Presses are offered to this one after those that are there.
    void add(Interaction& interaction) { interactions_.add(interaction); }
    const InteractionStack& interactions() const { return interactions_; }

    /// An interaction is about something else now: pointer and frame follow.
    void refresh();

    /// Shows where the selection ends.
    void show_outline(bool shown);

    /// Shows the picture that is traced below the paint.
    void show_tracing(bool shown);

    /// Shows this one in place of the painting's own, until that becomes another.
    void preview_tracing(screen::Tracing tracing);

    /// Shows this one in place of the painting of the same canvas; null: the painting again.
    void preview_painting(std::shared_ptr<const document::Snapshot> painting);

    /// Outlines what would be selected in place of what is.
    void preview_selection(std::optional<document::Selection> preview);

    const shade::Lighting& lighting() const { return lighting_; }
    const pigment::Viewing& viewing() const { return viewing_; }
    const screen::ViewTransform& view_transform() const override { return view_; }
    void set_view(const screen::ViewTransform& view);
    /// By the painter's hand: the canvas is not fitted any more, unless it comes to lie as if it were.
    void look_from(const screen::ViewTransform& view);
    void pan(const glm::dvec2& drag_px);  ///< so that some of the canvas stays in the window
    void fit();
    void show_actual_pixels();  ///< zoom 1 about the window's centre
    void zoom_about_centre(double factor);
    void turn_about_centre(double by_deg);  ///< clockwise, the canvas about the window's centre
    void turn_upright();                    ///< the same, until it stands as it is saved
    void mirror();                          ///< left and right of the window change places

    /// Brings a place on the canvas to the window's centre, as far as some of the canvas stays in it.
    void show_at_centre(const glm::dvec2& canvas_mm);

    /// The view's corner has moved by so much on the desktop, and the picture has not, unless it is
    /// fitted.
    void keep_in_place(const QPoint& way);

    /// Whether the frame on the screen is the final one of the latest snapshot.
    bool finished() const { return screen_->finished(); }

    /// What the latest frame showed; null before the first.
    const document::Snapshot* shown() const { return screen_->shown(); }

    /// The frame of now.
    QImage picture() { return screen_->picture(); }

    /// The one that draws; null where the processor does.
    QOpenGLWidget* opengl() { return screen_->opengl(); }

    /// Where the pointer is above the view, in millimetres; none when it is elsewhere.
    std::optional<glm::dvec2> pointer_mm() const;

    glm::dvec2 canvas_size_mm() const;  ///< 0 before there is one
    double cell_mm() const;             ///< 0 as well
    double px_mm() const;               ///< a pixel of the layout, on the canvas
    glm::dvec2 device_px(const QPointF& position) const;
    glm::dvec2 window_px() const;  ///< its size in device pixels

    /// Millimetres on the canvas under a point of the widget, and back.
    glm::dvec2 canvas_mm(const QPointF& position) const;
    QPointF widget_position(const glm::dvec2& canvas_mm) const;

    /// A canvas takes what room there is; the well keeps its proportions.
    QSize sizeHint() const override;
    int heightForWidth(int width) const override;

  Q_SIGNALS:
    /// A frame has come to the screen.
    void frame_came();
    /// A mouse or a pen did something, at this time of the device's own clock.
    void pointer_heard(double device_ms);
    /// OpenGL has failed, in one sentence, and from now on the processor draws.
    void fell_back(const QString& sentence);

    void view_changed();  ///< the window's size, too
    void viewing_changed();
    void lighting_changed();
    void pointer_moved(const QPointF& canvas_mm);
    void pointer_left();

    /// A pen is used by this end, or a mouse, which is like the tip.
    void pen_used(bool eraser_end);

    /// The wheel of an airbrush was turned by so many notches, forward as positive ones.
    void wheel_turned(int notches);

    /// So many fingers have tapped at once; one has been held there.
    void tapped(int fingers);
    void held(const QPointF& canvas_mm);

    /// Escape was pressed where there was nothing to be given up.
    void escaped();

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    screen::Sight sight() const override;
    void draw_over(const document::Snapshot& shown, screen::OverlayPainter& painter) override;
    void scale_shown(double top_mm) override;
    void frame_shown() override { Q_EMIT frame_came(); }
    void screen_failed(const QString& sentence) override;

    void put_up(std::unique_ptr<screen::CanvasScreen> screen);
    void suit_screen();
    void place_legend();
    screen::Tracing seen_tracing() const;
    void draw_masking(const document::Snapshot& shown, const Overlay& overlay);
    void draw_selection(const document::Snapshot& shown, const Overlay& overlay);
    void begin_other_canvas();
    glm::dvec2 canvas_cells() const;
    screen::ViewTransform fitted_view() const;
    void grow_with_width();  ///< the well, in its panel

    input::PointerEvent over_canvas(input::PointerEvent event) const;
    void hear(const input::PointerEvent& event);
    void deliver(const input::PointerEvent& event);
    void move_pointer(const QPointF& place);
    void forget_pointer();
    bool closes_popup(const QTabletEvent& event);
    void lose_pen();
    bool touch(QTouchEvent& event);
    void follow(const std::vector<input::TouchStep>& steps);
    void pinch(const screen::Fingers& from_px, const screen::Fingers& to_px);
    void finger_does(input::Kind kind, const input::Finger& finger);
    void drop_fingers();
    void hold_finger();

    document::Surface surface_;
    screen::DrawnBy drawn_by_ = screen::DrawnBy::Fastest;
    bool opengl_failed_ = false;
    std::unique_ptr<screen::CanvasScreen> screen_;
    std::shared_ptr<const document::Snapshot> wanted_, painting_preview_;
    screen::ViewTransform view_;
    bool fitted_ = true;  ///< follows the window's size until the painter zooms or pans
    shade::Lighting lighting_;
    screen::Look look_ = screen::Look::Lit;
    double scale_top_mm_ = 1.0;
    LookLegend* legend_;
    pigment::Viewing viewing_;
    bool closing_popup_ = false;  ///< the press that closed it does nothing else
    bool tracing_shown_ = true;
    screen::Tracing tracing_preview_;

    InteractionStack interactions_;
    input::EventReader reader_;
    PenWatch pen_watch_{*this};
    std::optional<input::PointerEvent> pen_;  ///< its latest event, while it is what is over the view
    input::Arbiter arbiter_;
    input::WheelSteps wheel_;
    input::TouchGestures gestures_;
    bool fingers_heard_ = false;  ///< since the first of them came down
    std::uint64_t touched_ms_ = 0;
    Qt::KeyboardModifiers touch_modifiers_;
    QTimer holding_;  ///< while one finger waits
    std::optional<QPointF> pointer_;
    std::optional<QPoint> left_at_;  ///< where on the desktop it was last

    MaskingSkin masking_skin_;
    SelectionOutline selection_outline_;
    bool outline_shown_ = true;
    std::optional<document::Selection> preview_;
};

}  // namespace pastoso::view
