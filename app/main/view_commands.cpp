#include "main/view_commands.hpp"

#include "panels/status_readings.hpp"

#include <QAction>
#include <QLayout>
#include <QMainWindow>

namespace pastoso::main {
namespace {

using commands::Command;

constexpr double kTurn_deg = 15.0;

}  // namespace

ViewCommands::ViewCommands(QMainWindow* window, commands::CommandRegistry& commands,
                           view::CanvasView* canvas, panels::StatusReadings* readings)
    : QObject(window),
      window_(window),
      commands_(commands),
      canvas_(canvas),
      readings_(readings),
      canvas_only_(window, canvas) {
    connect_turning();
    connect_canvas_only();
    connect(canvas_, &view::CanvasView::view_changed, this, &ViewCommands::show_view);
    show_view();
}

void ViewCommands::connect_turning() {
    commands_.on(Command::TurnLeft, [this](bool) { canvas_->turn_about_centre(-kTurn_deg); });
    commands_.on(Command::TurnRight, [this](bool) { canvas_->turn_about_centre(kTurn_deg); });
    commands_.on(Command::TurnUpright, [this](bool) { canvas_->turn_upright(); });
    commands_.on(Command::MirrorView, [this](bool) { canvas_->mirror(); });
}

/// Everywhere but on the canvas the key goes from control to control.
void ViewCommands::connect_canvas_only() {
    QAction* action = commands_.action(Command::CanvasOnly);
    action->setShortcutContext(Qt::WidgetShortcut);
    canvas_->addAction(action);
    commands_.on(Command::CanvasOnly, [this](bool only) { show_only_canvas(only); });
    connect(canvas_, &view::CanvasView::escaped, this, &ViewCommands::leave_canvas_only);
}

void ViewCommands::leave_canvas_only() {
    if (!canvas_only_.active()) return;
    commands_.action(Command::CanvasOnly)->setChecked(false);
    show_only_canvas(false);
}

/// The picture stays where it is on the screen, unless it is fitted to the window.
void ViewCommands::show_only_canvas(bool only) {
    const QPoint before = canvas_->mapToGlobal(QPoint(0, 0));
    if (only)
        canvas_only_.enter();
    else
        canvas_only_.leave();
    window_->layout()->activate();
    canvas_->parentWidget()->layout()->activate();
    canvas_->keep_in_place(before - canvas_->mapToGlobal(QPoint(0, 0)));
}

void ViewCommands::show_view() {
    const view::ViewTransform& view = canvas_->view_transform();
    readings_->show_view(view.zoom, view.angle_deg, view.mirrored);
    commands_.action(Command::MirrorView)->setChecked(view.mirrored);
}

}  // namespace pastoso::main
