#include "main/view_commands.hpp"

#include "panels/status_readings.hpp"

namespace pastoso::main {

using commands::Command;

ViewCommands::ViewCommands(Studio& studio, panels::StatusReadings* readings) {
    constexpr double kZoomStep = 1.25;
    view::CanvasView* canvas = &studio.canvas();
    commands::CommandRegistry& commands = studio.commands();
    commands.on(Command::FitCanvas, [canvas](bool) { canvas->fit(); });
    commands.on(Command::ActualPixels, [canvas](bool) { canvas->show_actual_pixels(); });
    commands.on(Command::ZoomIn, [canvas](bool) { canvas->zoom_about_centre(kZoomStep); });
    commands.on(Command::ZoomOut, [canvas](bool) { canvas->zoom_about_centre(1.0 / kZoomStep); });
    connect(canvas, &view::CanvasView::view_changed, this,
            [canvas, readings] { readings->show_zoom(canvas->view_transform().zoom); });
    connect(canvas, &view::CanvasView::pointer_moved, this,
            [readings](const QPointF& canvas_mm) { readings->show_pointer(canvas_mm); });
    connect(canvas, &view::CanvasView::pointer_left, this,
            [readings] { readings->show_pointer(std::nullopt); });
    readings->show_zoom(canvas->view_transform().zoom);
}

}  // namespace pastoso::main
