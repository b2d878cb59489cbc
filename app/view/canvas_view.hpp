// The window's canvas, or its mixing well: shows the latest snapshot, moves over it, and hands pen and
// mouse to the easel.
#pragma once

#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "graphics/graphics_widget.hpp"
#include "tools/easel.hpp"
#include "tools/mouse_pressure.hpp"
#include "tools/pen_settings.hpp"
#include "tools/picked_paint.hpp"
#include "tools/transform_frame.hpp"
#include "view/area_drag.hpp"
#include "view/brush_outline.hpp"
#include "view/guide_drag.hpp"
#include "view/light_handle.hpp"
#include "view/line_overlay.hpp"
#include "view/look.hpp"
#include "view/picture_buffer.hpp"
#include "view/selection_outline.hpp"
#include "view/shading_plan.hpp"
#include "view/tracing_ground.hpp"

#include <memory>
#include <optional>

#include <QCursor>
#include <QEventPoint>
#include <QImage>
#include <QTimer>

class QTouchEvent;

namespace pastoso::view {

class LookLegend;

class CanvasView : public graphics::GraphicsWidget {
    Q_OBJECT
  public:
    /// `easel` is told of every stroke, as one on `surface`.
    explicit CanvasView(tools::Easel* easel, document::Surface surface = document::Surface::Canvas,
                        QWidget* parent = nullptr);
    ~CanvasView() override;

    /// Shows this from the next frame on. A snapshot of another canvas is shown whole, but one of the
    /// same canvas cut or made larger, where what lay on it came to lie so much further from the corner,
    /// shows what was there where it was.
    void show_snapshot(std::shared_ptr<const document::Snapshot> snapshot,
                       std::optional<glm::dvec2> shift_mm = {});
    void set_easel(tools::Easel* easel);
    void set_lighting(const shade::Lighting& lighting);
    void set_look(Look look);
    Look look() const { return look_; }
    const LookLegend& legend() const { return *legend_; }
    void set_viewing(const pigment::Viewing& viewing);
    void set_tool(const brush::Preset& tool);  ///< whose outline goes with the pointer
    void hide_tool();                          ///< nothing is painted here
    void set_pen(const tools::PenSettings& pen);

    /// Shows the handles of the guides, by which they are dragged.
    void show_handles(bool shown);

    /// The next click picks that instead of painting; nothing: it paints.
    void pick_next(std::optional<tools::Pick> pick);

    /// A press and a drag draw the outline of an area instead of painting; nothing: they paint.
    void draw_areas(std::optional<AreaForm> form);

    /// Shows where the selection ends.
    void show_outline(bool shown);

    /// Shows a handle by which the lamp is dragged.
    void show_light_handle(bool shown);

    /// Shows the picture that is traced below the paint.
    void show_tracing(bool shown);

    /// Shows this one in place of the painting's own, until that becomes another.
    void preview_tracing(Tracing tracing);

    /// Outlines what would be selected in place of what is.
    void preview_selection(std::optional<document::Selection> preview);

    /// Puts up a frame that presses and drags change instead of painting; nothing: they paint.
    void show_frame(std::optional<tools::TransformFrame> frame);
    const std::optional<tools::TransformFrame>& frame() const { return frame_; }

    /// What is drawn in the frame, from corner to corner, however it is dragged: its paint, flat. Where
    /// it lies as yet it is veiled.
    void show_in_frame(const QImage& picture);

    const shade::Lighting& lighting() const { return lighting_; }
    const pigment::Viewing& viewing() const { return viewing_; }
    const ViewTransform& view_transform() const { return view_; }
    void set_view(const ViewTransform& view);
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

    /// A guide is being dragged by its handle.
    void guide_dragged(const tools::Guide& guide);

    /// The paint, or the colour, at this place is asked for.
    void picked(const QPointF& place_mm, tools::Pick pick);

    /// The brush has come down on the canvas.
    void stroke_begun(const QPointF& canvas_mm);

    /// The outline of an area: its first point, all of it, none but a click, or not meant.
    void area_begun(grid::Combination how);
    void area_drawn(const document::SelectArea& area);
    void area_clicked(grid::Combination how);
    void area_given_up();
    void areas_left();  ///< painting goes on

    /// A pen is used by this end, or a mouse, which is like the tip.
    void pen_used(bool eraser_end);

    /// The pop-up palette is to open there on the desktop.
    void palette_wanted(const QPoint& place);

    /// Escape was pressed where there was nothing to be given up.
    void escaped();

    /// The lamp is being dragged; it moves where set_lighting() has it.
    void light_dragged(double elevation_deg, double azimuth_deg);

    /// The frame was dragged; what it shows is to be kept; it is to be taken away.
    void frame_dragged(const tools::TransformFrame& frame);
    void frame_accepted();
    void frame_cancelled();

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
    void upload_changes();
    void upload_shadows();
    bool draws_outlines() const;
    void upload_outlines();
    QRegion outlined_region() const;
    void upload_look(const std::vector<int>& tiles);
    void upload_new_look();
    void place_legend();
    LightDial light_dial() const;
    bool press_light(const QPointF& position);
    void drag_light(const QPointF& position);
    void draw_light_handle();
    Tracing seen_tracing() const;
    double shade_job(const ShadingPlan::Job& job);
    void draw_selection();
    void draw_guides();
    void draw_handles(const OverlayFrame& canvas);
    void draw_frame();
    void draw_frame_picture();
    void draw_in(const tools::TransformFrame& frame, const QImage& picture, double opacity);
    void draw_tip();
    OverlayFrame overlay_frame(const glm::dvec2& origin_px) const;
    void damage_all();
    void begin_other_canvas();
    bool prepare_textures();
    QRegion damaged_region(const LayerChanges& changes) const;

    glm::dvec2 device_px(const QPointF& position) const;
    glm::dvec2 window_px() const;
    glm::dvec2 canvas_cells() const;
    tools::Pointer pointer_at(const QPointF& position, std::uint64_t time_ms);
    tools::Pointer pen_pointer(const QTabletEvent& event) const;
    bool closes_popup(const QTabletEvent& event);
    void press_pen(const QTabletEvent& event);
    void press_pen_button(tools::PenButtonDoes what, const QTabletEvent& event);
    void touch_down(const tools::Pointer& pointer, Qt::KeyboardModifiers modifiers);
    void follow_pointer(const QPointF& position);
    std::optional<tools::Pick> pick_wanted(Qt::KeyboardModifiers modifiers) const;
    void press_area(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void drag_area(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void release_area();
    void leave_areas();
    grid::Rect seen_cells() const;
    tools::FrameHold hold_under(const QPointF& position) const;
    void press_frame(const QPointF& position);
    void drag_frame(const QPointF& position, Qt::KeyboardModifiers modifiers);
    bool press_frame_key(int key);
    QCursor frame_cursor() const;
    bool press_guides(const QPointF& position, Qt::KeyboardModifiers modifiers);
    bool drag_guides(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void release_pointer();
    double handle_axis_mm() const;
    double mm_per_px() const;
    ViewTransform fitted_view() const;
    void grow_with_width();  ///< the well, in its panel
    void set_turned(const ViewTransform& view);
    void begin_view_drag(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void drag_view(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void drag_turn(const QPointF& position, bool by_steps);
    void end_view_drag();
    bool touch(QTouchEvent& event);
    void pinch(const QEventPoint& first, const QEventPoint& second);
    void move_finger(const QTouchEvent& event, const QEventPoint& finger);
    void put_finger_down(const QTouchEvent& event);
    void lift_finger(const QTouchEvent& event, bool meant);
    void set_cursor();

    tools::Easel* easel_;
    document::Surface surface_;
    core::ThreadPool pool_;
    CanvasLayers layers_;
    CanvasOutlines outlines_;
    CanvasTextures textures_;
    PictureBuffer picture_;
    LineOverlay overlay_;
    ShadingPlan plan_;
    QTimer cooling_;
    QTimer waiting_;  ///< since the pointer moved

    std::shared_ptr<const document::Snapshot> wanted_;
    std::shared_ptr<const document::Snapshot> shown_;
    std::shared_ptr<const document::Snapshot> seen_;  ///< shown_ with what is traced below it
    ViewTransform view_;
    bool fitted_ = true;  ///< follows the window's size until the painter zooms or pans
    shade::Lighting lighting_;
    bool relight_ = false;  ///< the shadows are still those of another light
    QTimer light_rests_;    ///< when it fires, shadows follow the light
    double shadows_took_s_ = 0.0;
    bool light_handle_shown_ = false;
    std::optional<glm::dvec2> light_drag_;  ///< from the pointer to the lamp
    Look look_ = Look::Lit;
    bool relook_ = false;      ///< what it shows is still that of another look
    double highest_mm_ = 0.0;  ///< of the paint, while heights are shown
    double scale_top_mm_ = 1.0;
    LookLegend* legend_;
    pigment::Viewing viewing_;
    bool recolour_ = false;  ///< the colours are still those of another light
    BrushOutline outline_;
    bool tool_hidden_ = false;
    tools::PenSettings pen_;
    tools::MousePressure mouse_pressure_;
    bool closing_popup_ = false;  ///< the press that closed it does nothing else
    TracingGround tracing_ground_;
    bool tracing_shown_ = true;
    Tracing tracing_preview_;
    bool retrace_ = false;  ///< the picture below the paint is still another

    std::optional<QPointF> pointer_;
    /// The hand moves the canvas and not the brush.
    struct ViewDrag {
        enum class Kind { Pan, Turn, Zoom } kind;
        QPointF from;
        ViewTransform start;
    };
    std::optional<ViewDrag> view_drag_;
    struct Touch {
        enum class Does { Nothing, Wait, Paint, Pinch } does = Does::Nothing;
        QPointF from;  ///< of a finger that waits
        std::array<int, 2> ids{};
        Fingers fingers_px{};
    };
    Touch touch_;
    bool space_held_ = false;
    GuideDrag guide_drag_;
    std::optional<AreaForm> area_form_;  ///< painting rests
    AreaDrag area_drag_;
    SelectionOutline selection_outline_;
    bool outline_shown_ = true;
    std::optional<document::Selection> preview_;
    /// Since the press.
    struct FrameDrag {
        tools::TransformFrame start;
        tools::FrameHold hold;
        glm::dvec2 from_mm{};
    };
    std::optional<tools::TransformFrame> frame_;
    std::optional<FrameDrag> frame_drag_;
    QImage frame_picture_, frame_veil_;
    bool handles_shown_ = true;
    std::optional<tools::Pick> picks_next_;
    bool picking_ = false;  ///< this press picks and does not paint
};

}  // namespace pastoso::view
