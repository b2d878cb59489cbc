// A press and a drag draw the outline of an area, or clicks set its corners.
#pragma once

#include "interactions/area_corners.hpp"
#include "interactions/area_drag.hpp"
#include "view/canvas_view.hpp"

#include <optional>

#include <QObject>

namespace pastoso::interactions {

class Areas : public QObject, public view::Interaction {
    Q_OBJECT
  public:
    explicit Areas(view::CanvasView& canvas) : canvas_(canvas) {}

    /// Nothing: presses paint.
    void draw_next(std::optional<AreaForm> form);

    view::Took press(const input::PointerEvent& event) override;
    void drag(const input::PointerEvent& event) override;
    void release(const input::PointerEvent& event) override;
    void hover(const input::PointerEvent& event) override;
    void cancel() override;

    /// Escape gives up the outline that is being drawn, or else goes back to painting. Enter closes a
    /// polygon, Backspace takes its last corner back.
    bool key(const QKeyEvent& event) override;
    bool needs_key(const QKeyEvent& event) const override;
    void draw(const view::Overlay& overlay) override;
    bool is_mode() const override { return form_.has_value(); }

  Q_SIGNALS:
    /// The outline of an area: its first point, all of it, none but a click, or not meant.
    void begun(grid::Combination how);
    void drawn(const document::SelectArea& area);
    void clicked(grid::Combination how);
    void cancelled();
    void left();  ///< painting goes on

  private:
    void click(const input::PointerEvent& event);
    void close_polygon();
    void take_corner_back();
    void drop_outline();
    bool is_drawing() const { return drag_.active() || corners_.active(); }

    view::CanvasView& canvas_;
    std::optional<AreaForm> form_;
    AreaDrag drag_;
    AreaCorners corners_;  ///< of a polygon
};

}  // namespace pastoso::interactions
