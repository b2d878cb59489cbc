// How the canvas is looked at: turned, mirrored, and with nothing around it.
#pragma once

#include "commands/command_registry.hpp"
#include "main/canvas_only.hpp"
#include "view/canvas_view.hpp"

#include <QObject>

class QMainWindow;

namespace pastoso::panels {
class EaselPanel;
class StatusReadings;
}  // namespace pastoso::panels

namespace pastoso::main {

class ViewCommands : public QObject {
    Q_OBJECT
  public:
    /// What shows the canvas, and tells of it.
    struct Parts {
        view::CanvasView* canvas;
        view::CanvasView* well;
        panels::StatusReadings* readings;
        panels::EaselPanel* stand;
    };

    /// `window` is laid out, and owns this.
    ViewCommands(QMainWindow* window, commands::CommandRegistry& commands, const Parts& parts);

    /// Moves the lamp over canvas and well, and shows where it is.
    void light_from(double elevation_deg, double azimuth_deg);

    /// The panels stand again as they are to be remembered.
    void leave_canvas_only();

  private:
    void connect_turning();
    void connect_canvas_only();
    void connect_looks();
    void connect_light();
    void escape();
    void show_look(view::Look look);
    void show_only_canvas(bool only);
    void show_view();

    QMainWindow* window_;
    commands::CommandRegistry& commands_;
    view::CanvasView* canvas_;
    view::CanvasView* well_;
    panels::StatusReadings* readings_;
    panels::EaselPanel* stand_;
    CanvasOnly canvas_only_;
};

}  // namespace pastoso::main
