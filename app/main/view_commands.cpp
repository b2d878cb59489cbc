#include "main/view_commands.hpp"

#include "panels/easel_panel.hpp"
#include "panels/status_readings.hpp"
#include "view/look_legend.hpp"

#include <utility>

#include <QAction>
#include <QActionGroup>
#include <QLayout>
#include <QMainWindow>

namespace pastoso::main {
namespace {

using commands::Command;

constexpr double kTurn_deg = 15.0;

constexpr std::pair<Command, view::Look> kLooks[] = {{Command::LookLit, view::Look::Lit},
                                                     {Command::LookWet, view::Look::Wet},
                                                     {Command::LookHeight, view::Look::Height},
                                                     {Command::LookNormals, view::Look::Normals},
                                                     {Command::LookFlat, view::Look::Flat}};

}  // namespace

ViewCommands::ViewCommands(QMainWindow* window, commands::CommandRegistry& commands, const Parts& parts)
    : QObject(window),
      window_(window),
      commands_(commands),
      canvas_(parts.canvas),
      well_(parts.well),
      readings_(parts.readings),
      stand_(parts.stand),
      canvas_only_(window, parts.canvas) {
    connect_turning();
    connect_canvas_only();
    connect_looks();
    connect_light();
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
    connect(canvas_, &view::CanvasView::escaped, this, &ViewCommands::escape);
}

/// First the lamp goes, then the panels come back.
void ViewCommands::escape() {
    QAction* lamp = commands_.action(Command::MoveLight);
    if (lamp->isChecked())
        lamp->trigger();
    else
        leave_canvas_only();
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

void ViewCommands::connect_looks() {
    auto* looks = new QActionGroup(this);
    for (const auto& [command, look] : kLooks) {
        looks->addAction(commands_.action(command));
        commands_.on(command, [this, look = look](bool) { show_look(look); });
    }
    commands_.action(Command::LookLit)->setChecked(true);
}

void ViewCommands::show_look(view::Look look) {
    canvas_->set_look(look);
    readings_->show_look(view::look_words(look));
}

void ViewCommands::connect_light() {
    commands_.on(Command::MoveLight, [this](bool shown) { canvas_->show_light_handle(shown); });
    connect(canvas_, &view::CanvasView::light_dragged, this, &ViewCommands::light_from);
    connect(stand_, &panels::EaselPanel::light_moved, this, &ViewCommands::light_from);
}

void ViewCommands::light_from(double elevation_deg, double azimuth_deg) {
    shade::Lighting lighting = canvas_->lighting();
    lighting.elevation_deg = elevation_deg;
    lighting.azimuth_deg = azimuth_deg;
    for (view::CanvasView* view : {canvas_, well_})
        view->set_lighting(lighting);
    stand_->show_light(lighting);
}

void ViewCommands::show_view() {
    const view::ViewTransform& view = canvas_->view_transform();
    readings_->show_view(view.zoom, view.angle_deg, view.mirrored);
    commands_.action(Command::MirrorView)->setChecked(view.mirrored);
}

}  // namespace pastoso::main
