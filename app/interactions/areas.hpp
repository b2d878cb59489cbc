// A press and a drag draw the outline of an area.
#pragma once

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
    void cancel() override;

    /// Escape gives up the outline that is being drawn, or else goes back to painting.
    bool key(const QKeyEvent& event) override;
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
    view::CanvasView& canvas_;
    std::optional<AreaForm> form_;
    AreaDrag drag_;
};

}  // namespace pastoso::interactions
