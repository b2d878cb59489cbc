// The window's canvas, or its mixing well: shows the latest snapshot, from near or far, and hands pen,
// mouse and fingers to its interactions.
#pragma once

#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "graphics/graphics_widget.hpp"
#include "input/arbiter.hpp"
#include "input/event_reader.hpp"
#include "input/touch_gestures.hpp"
#include "input/wheel_steps.hpp"
#include "view/interaction_stack.hpp"
#include "view/line_overlay.hpp"
#include "view/look.hpp"
#include "view/picture_buffer.hpp"
#include "view/selection_outline.hpp"
#include "view/shading_plan.hpp"
#include "view/texture_upload.hpp"

#include <deque>
#include <memory>
#include <optional>

#include <QTimer>

class QTouchEvent;

namespace pastoso::view {

class LookLegend;

class CanvasView : public graphics::GraphicsWidget {
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
    void set_look(Look look);
    Look look() const { return look_; }
    const LookLegend& legend() const { return *legend_; }
    void set_viewing(const pigment::Viewing& viewing);
    void set_pen(const tools::PenSettings& pen) { reader_.set_pen(pen); }
    const tools::PenSettings& pen() const { return reader_.pen(); }

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
    void preview_tracing(Tracing tracing);

    /// Outlines what would be selected in place of what is.
    void preview_selection(std::optional<document::Selection> preview);

    const shade::Lighting& lighting() const { return lighting_; }
    const pigment::Viewing& viewing() const { return viewing_; }
    const ViewTransform& view_transform() const { return view_; }
    void set_view(const ViewTransform& view);
    /// By the painter's hand: the canvas is not fitted any more, unless it comes to lie as if it were.
    void look_from(const ViewTransform& view);
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
    bool finished() const;

    /// What the latest frame showed; null before the first.
    const document::Snapshot* shown() const { return shown_.get(); }

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
    void make_graphics() override;
    void free_graphics() override;
    void paintGL() override;
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
    void move_picture(const ViewTransform& from, const QRect& window);
    Sight wanted_sight() const;
    void ask_presenter();
    void take_presentation(std::chrono::microseconds patience);
    void upload_changes();
    bool begin_upload();
    void finish_upload();
    void drop_textures();
    bool draws_outlines() const;
    void upload_outlines();
    QRegion outlined_region() const;
    void prepare_look();
    void show_heights(const std::vector<LookPatch>& patches, bool begins);
    void place_legend();
    Tracing seen_tracing() const;
    double shade_job(const ShadingPlan::Job& job);
    void draw_selection();
    OverlayFrame overlay_frame(const glm::dvec2& origin_px) const;
    void damage_all();
    void begin_other_canvas();
    bool prepare_textures();
    QRegion damaged_region(const QRegion& cells) const;

    Overlay overlay();
    glm::dvec2 canvas_cells() const;
    grid::Rect seen_cells() const;
    ViewTransform fitted_view() const;
    void grow_with_width();  ///< the well, in its panel

    input::PointerEvent over_canvas(input::PointerEvent event) const;
    void hear(const input::PointerEvent& event);
    void deliver(const input::PointerEvent& event);
    void move_pointer(const QPointF& place);
    bool closes_popup(const QTabletEvent& event);
    bool touch(QTouchEvent& event);
    void follow(const std::vector<input::TouchStep>& steps);
    void pinch(const Fingers& from_px, const Fingers& to_px);
    void finger_does(input::Kind kind, const QPointF& place);
    void drop_fingers();
    void hold_finger();

    document::Surface surface_;
    core::ThreadPool pool_;
    CanvasPresenter presenter_;
    std::deque<Presentation> presentations_;  ///< made, and not on their way to the textures yet
    TextureUpload upload_;
    CanvasOutlines outlines_;
    CanvasTextures textures_;
    PictureBuffer picture_;
    LineOverlay overlay_;
    ShadingPlan plan_;
    QTimer cooling_;

    std::shared_ptr<const document::Snapshot> wanted_;
    Sight drawn_;                   ///< what the textures hold, while there is shown_
    std::optional<Sight> asked_;    ///< that they will hold when all that was asked for is there
    bool outdated_ = false;         ///< what is being made is about textures that are no more
    std::optional<Sight> refused_;  ///< of which no presentation could be made
    std::shared_ptr<const document::Snapshot> shown_;
    std::shared_ptr<const document::Snapshot> seen_;  ///< shown_ with what is traced below it
    ViewTransform view_;
    std::optional<ViewTransform> moved_from_;  ///< that the picture was shaded from
    bool fitted_ = true;  ///< follows the window's size until the painter zooms or pans
    shade::Lighting lighting_;
    Look look_ = Look::Lit;
    double highest_mm_ = 0.0;  ///< of the paint, while heights are shown
    double scale_top_mm_ = 1.0;
    LookLegend* legend_;
    pigment::Viewing viewing_;
    bool closing_popup_ = false;  ///< the press that closed it does nothing else
    bool tracing_shown_ = true;
    Tracing tracing_preview_;

    InteractionStack interactions_;
    input::EventReader reader_;
    input::Arbiter arbiter_;
    input::WheelSteps wheel_;
    input::TouchGestures gestures_;
    bool fingers_heard_ = false;  ///< since the first of them came down
    std::uint64_t touched_ms_ = 0;
    Qt::KeyboardModifiers touch_modifiers_;
    QTimer holding_;  ///< while one finger waits
    std::optional<QPointF> pointer_;

    SelectionOutline selection_outline_;
    bool outline_shown_ = true;
    std::optional<document::Selection> preview_;
};

}  // namespace pastoso::view
