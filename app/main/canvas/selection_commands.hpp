// Selections: outlines drawn on the canvas, and what is told of them.
#pragma once

#include "interactions/area_drag.hpp"
#include "main/studio.hpp"

#include <optional>

#include <QObject>

namespace pastoso::panels {
class BrushPanel;
class StatusReadings;
}  // namespace pastoso::panels

namespace pastoso::main {

class SelectionCommands : public QObject {
    Q_OBJECT
  public:
    /// Taking a tool of `brushes` ends the drawing.
    SelectionCommands(Studio& studio, panels::BrushPanel* brushes, panels::StatusReadings* readings);

  Q_SIGNALS:
    void drawing_begins();  ///< a press draws outlines from now on, and nothing else

  private:
    void draw_areas(std::optional<interactions::AreaForm> form);
    void tell_combination(grid::Combination how);
    void warn_outside(const QPointF& canvas_mm);
    void show(const document::Snapshot& painting);
    void show_reading();

    Studio& studio_;
    panels::StatusReadings* readings_;
    std::optional<interactions::AreaForm> form_;  ///< what a press on the canvas draws; none: it paints
    document::Selection shown_;
};

}  // namespace pastoso::main
