// How the canvas is looked at: turned, mirrored, and with nothing around it.
#pragma once

#include "commands/command_registry.hpp"
#include "main/canvas_only.hpp"
#include "view/canvas_view.hpp"

#include <QObject>

class QMainWindow;

namespace pastoso::panels {
class StatusReadings;
}  // namespace pastoso::panels

namespace pastoso::main {

class ViewCommands : public QObject {
    Q_OBJECT
  public:
    /// `window` is laid out, and owns this.
    ViewCommands(QMainWindow* window, commands::CommandRegistry& commands, view::CanvasView* canvas,
                 panels::StatusReadings* readings);

    /// The panels stand again as they are to be remembered.
    void leave_canvas_only();

  private:
    void connect_turning();
    void connect_canvas_only();
    void show_only_canvas(bool only);
    void show_view();

    QMainWindow* window_;
    commands::CommandRegistry& commands_;
    view::CanvasView* canvas_;
    panels::StatusReadings* readings_;
    CanvasOnly canvas_only_;
};

}  // namespace pastoso::main
