#include "main/canvas/view_commands.hpp"

#include "appearance/shown_number.hpp"
#include "main/canvas/said_pointer.hpp"
#include "panels/parts/status_readings.hpp"
#include "view/look_legend.hpp"

#include <optional>
#include <utility>

#include <QAction>
#include <QActionGroup>
#include <QKeyEvent>
#include <QLayout>
#include <QMainWindow>

namespace pastoso::main {
namespace {

using commands::Command;

constexpr double kTurn_deg = 15.0, kZoomStep = 1.25;

constexpr std::pair<Command, screen::Look> kLooks[] = {{Command::LookLit, screen::Look::Lit},
                                                       {Command::LookWet, screen::Look::Wet},
                                                       {Command::LookHeight, screen::Look::Height},
                                                       {Command::LookNormals, screen::Look::Normals},
                                                       {Command::LookFlat, screen::Look::Flat}};

}  // namespace

ViewCommands::ViewCommands(Studio& studio, panels::StatusReadings* readings)
    : studio_(studio),
      canvas_(studio.canvas()),
      readings_(readings),
      canvas_only_(&studio.window(), &studio.canvas()) {
    connect_zooming();
    connect_turning();
    connect_canvas_only();
    connect_full_screen();
    connect_looks();
    connect(&canvas_, &view::CanvasView::view_changed, this, &ViewCommands::show_view);
    connect(&canvas_, &view::CanvasView::pointer_moved, this,
            [this](const QPointF& canvas_mm) { readings_->show_pointer(canvas_mm); });
    connect(&canvas_, &view::CanvasView::pointer_left, this,
            [this] { readings_->show_pointer(std::nullopt); });
    say_pointer(canvas_);
    connect(&studio_, &Studio::session_begun, this, &ViewCommands::name_canvas);
    studio_.window().installEventFilter(this);
    show_view();
}

/// For those who do not see it.
void ViewCommands::name_canvas() {
    const document::CanvasSettings canvas = studio_.session().canvas();
    canvas_.setAccessibleName(tr("Canvas %1 \u00d7 %2 mm, %3 pixels per millimetre")
                                  .arg(appearance::shown_number(canvas.width_mm))
                                  .arg(appearance::shown_number(canvas.height_mm))
                                  .arg(appearance::shown_number(canvas.px_per_mm)));
}

void ViewCommands::connect_zooming() {
    commands::CommandRegistry& commands = studio_.commands();
    commands.on(Command::FitCanvas, [this](bool) { canvas_.fit(); });
    commands.on(Command::ActualPixels, [this](bool) { canvas_.show_actual_pixels(); });
    commands.on(Command::ZoomIn, [this](bool) { canvas_.zoom_about_centre(kZoomStep); });
    commands.on(Command::ZoomOut, [this](bool) { canvas_.zoom_about_centre(1.0 / kZoomStep); });
}

void ViewCommands::connect_turning() {
    commands::CommandRegistry& commands = studio_.commands();
    commands.on(Command::TurnLeft, [this](bool) { canvas_.turn_about_centre(-kTurn_deg); });
    commands.on(Command::TurnRight, [this](bool) { canvas_.turn_about_centre(kTurn_deg); });
    commands.on(Command::TurnUpright, [this](bool) { canvas_.turn_upright(); });
    commands.on(Command::MirrorView, [this](bool) { canvas_.mirror(); });
}

/// Everywhere but on the canvas the key goes from control to control.
void ViewCommands::connect_canvas_only() {
    QAction* action = studio_.commands().action(Command::CanvasOnly);
    action->setShortcutContext(Qt::WidgetShortcut);
    canvas_.addAction(action);
    studio_.commands().on(Command::CanvasOnly, [this](bool only) { show_only_canvas(only); });
    connect(&canvas_, &view::CanvasView::escaped, this, &ViewCommands::escape);
}

/// The desktop may take the window out of it, too.
void ViewCommands::connect_full_screen() {
    QMainWindow& window = studio_.window();
    studio_.commands().on(Command::FullScreen, [&window](bool full) {
        window.setWindowState(window.windowState().setFlag(Qt::WindowFullScreen, full));
    });
}

void ViewCommands::show_full_screen() {
    studio_.commands().action(Command::FullScreen)->setChecked(studio_.window().isFullScreen());
}

/// Escape that nothing in the panels wanted gives the keyboard back to the canvas.
bool ViewCommands::eventFilter(QObject* window, QEvent* event) {
    if (event->type() == QEvent::WindowStateChange) show_full_screen();
    const bool escapes = event->type() == QEvent::KeyPress &&
                         static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && !canvas_.hasFocus();
    if (escapes) canvas_.setFocus(Qt::OtherFocusReason);
    return escapes || QObject::eventFilter(window, event);
}

/// First the lamp goes, then the panels come back.
void ViewCommands::escape() {
    QAction* lamp = studio_.commands().action(Command::MoveLight);
    if (lamp->isChecked())
        lamp->trigger();
    else
        leave_canvas_only();
}

void ViewCommands::leave_canvas_only() {
    if (!canvas_only_.active()) return;
    studio_.commands().action(Command::CanvasOnly)->setChecked(false);
    show_only_canvas(false);
}

/// The picture stays where it is on the screen, unless it is fitted to the window.
void ViewCommands::show_only_canvas(bool only) {
    const QPoint before = canvas_.mapToGlobal(QPoint(0, 0));
    if (only)
        canvas_only_.enter();
    else
        canvas_only_.leave();
    studio_.window().layout()->activate();
    canvas_.parentWidget()->layout()->activate();
    canvas_.keep_in_place(before - canvas_.mapToGlobal(QPoint(0, 0)));
}

void ViewCommands::connect_looks() {
    auto* looks = new QActionGroup(this);
    for (const auto& [command, look] : kLooks) {
        looks->addAction(studio_.commands().action(command));
        studio_.commands().on(command, [this, look = look](bool) { show_look(look); });
    }
    studio_.commands().action(Command::LookLit)->setChecked(true);
}

void ViewCommands::show_look(screen::Look look) {
    canvas_.set_look(look);
    readings_->show_look(view::look_words(look));
}

void ViewCommands::show_view() {
    const screen::ViewTransform& view = canvas_.view_transform();
    readings_->show_view(view.zoom, view.angle_deg, view.mirrored);
    studio_.commands().action(Command::MirrorView)->setChecked(view.mirrored);
}

}  // namespace pastoso::main
