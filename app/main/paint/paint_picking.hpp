// The eyedropper: paint, or the colour that it has, from canvas and well.
#pragma once

#include "main/studio.hpp"
#include "tools/picked_paint.hpp"

#include <optional>

#include <QObject>
#include <QPointF>

namespace pastoso::main {

class PaintPicking : public QObject {
    Q_OBJECT
  public:
    explicit PaintPicking(Studio& studio);

  private:
    void pick_at_next_click(std::optional<tools::Pick> pick);
    void pick_from(document::Surface surface, const QPointF& place_mm, tools::Pick pick);
    void pick_paint(const tools::PickedPaint& paint);
    void pick_colour(const document::Snapshot& there, const QPointF& place_mm);

    Studio& studio_;
};

}  // namespace pastoso::main
