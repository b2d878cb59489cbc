// How the canvas is looked at: how near, turned, mirrored, with nothing around it, and as what; and
// where the pointer is on it.
#pragma once

#include "main/canvas/canvas_only.hpp"
#include "main/studio.hpp"

#include <QObject>

namespace pastoso::panels {
class StatusReadings;
}

namespace pastoso::main {

class ViewCommands : public QObject {
    Q_OBJECT
  public:
    /// The window is laid out.
    ViewCommands(Studio& studio, panels::StatusReadings* readings);

    /// The panels stand again as they are to be remembered.
    void leave_canvas_only();

    bool eventFilter(QObject* window, QEvent* event) override;

    /// What it is like has changed.
    void name_canvas();

  private:
    void connect_zooming();
    void connect_turning();
    void connect_canvas_only();
    void connect_full_screen();
    void connect_looks();
    void escape();
    void show_look(screen::Look look);
    void show_only_canvas(bool only);
    void show_full_screen();
    void show_view();

    Studio& studio_;
    view::CanvasView& canvas_;
    panels::StatusReadings* readings_;
    CanvasOnly canvas_only_;
};

}  // namespace pastoso::main
