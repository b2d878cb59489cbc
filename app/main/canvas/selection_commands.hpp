// Selections: outlines drawn and colours clicked on the canvas, and what is told of them.
#pragma once

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
    /// Taking a tool of `brushes` ends the selecting.
    SelectionCommands(Studio& studio, panels::BrushPanel* brushes, panels::StatusReadings* readings);

    void go_back_to_painting() { select_by(std::nullopt); }

  Q_SIGNALS:
    void selecting_begins();  ///< a press selects from now on, and does nothing else

  private:
    void listen_to_areas();
    void listen_to_wand();
    void select_by(std::optional<commands::Command> way);
    void tell_combination(grid::Combination how);
    void tell_cancelled();
    void warn_outside(const QPointF& canvas_mm);
    void show(const document::Snapshot& painting);
    void show_reading();

    Studio& studio_;
    panels::StatusReadings* readings_;
    std::optional<commands::Command> way_;  ///< how a press on the canvas selects; none: it paints
    document::Selection shown_;
};

}  // namespace pastoso::main
