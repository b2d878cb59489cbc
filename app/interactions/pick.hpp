// Presses that pick paint, or a colour, off the canvas instead of painting.
#pragma once

#include "tools/picked_paint.hpp"
#include "view/canvas_view.hpp"

#include <optional>

#include <QObject>

namespace pastoso::interactions {

class Picking : public QObject, public view::Interaction {
    Q_OBJECT
  public:
    view::Took press(const input::PointerEvent& event) override;

  Q_SIGNALS:
    /// The paint, or the colour, at this place is asked for.
    void picked(const QPointF& place_mm, tools::Pick pick);

  private:
    /// Nothing: the press does not pick.
    virtual std::optional<tools::Pick> wanted(const input::PointerEvent& event) const = 0;
};

/// The next click picks, whatever else it would do.
class PickNext : public Picking {
    Q_OBJECT
  public:
    explicit PickNext(view::CanvasView& canvas) : canvas_(canvas) {}

    void arm(std::optional<tools::Pick> pick);  ///< nothing: it does what it did

    std::optional<QCursor> cursor() const override;
    bool is_mode() const override { return next_.has_value(); }

  private:
    std::optional<tools::Pick> wanted(const input::PointerEvent& event) const override;

    view::CanvasView& canvas_;
    std::optional<tools::Pick> next_;
};

/// With Alt a press picks the colour seen, with Control the paint, where that key does nothing else.
class PickByKeys : public Picking {
    Q_OBJECT
  public:
    explicit PickByKeys(document::Surface surface) : surface_(surface) {}

  private:
    std::optional<tools::Pick> wanted(const input::PointerEvent& event) const override;

    document::Surface surface_;
};

}  // namespace pastoso::interactions
