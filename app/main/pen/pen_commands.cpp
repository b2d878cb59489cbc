#include "main/pen/pen_commands.hpp"

#include "commands/command_names.hpp"
#include "core/user_data.hpp"
#include "panels/pen/pen_dialog.hpp"
#include "tools/pen_device_of.hpp"

#include <cstdlib>

#include <QAction>
#include <QInputDevice>
#include <QMainWindow>

namespace pastoso::main {
namespace {

/// Those that the windowing system knows of now.
std::vector<tools::PenDevice> present_pens() {
    using Type = QInputDevice::DeviceType;
    std::vector<tools::PenDevice> pens;
    for (const QInputDevice* device : QInputDevice::devices()) {
        const Type type = device->type();
        if (type != Type::Stylus && type != Type::Airbrush && type != Type::Puck) continue;
        pens.push_back(tools::pen_device_of(*static_cast<const QPointingDevice*>(device)));
    }
    return pens;
}

}  // namespace

PenCommands::PenCommands(Studio& studio)
    : studio_(studio), file_(studio, core::user_config_path("pen.json")) {
    studio_.commands().on(commands::Command::PenSettings, [this](bool) { show_dialog(); });
    for (view::CanvasView* view : studio_.views()) {
        connect(view, &view::CanvasView::pen_used, this, &PenCommands::turn_pen);
        connect(view, &view::CanvasView::wheel_turned, this, &PenCommands::turn_wheel);
        connect(view, &view::CanvasView::tapped, this, &PenCommands::tap);
    }
    for (const interactions::OnCanvas* on : studio_.on_views())
        connect(&on->buttons, &interactions::Buttons::command_wanted, this, &PenCommands::give);
}

void PenCommands::recall() {
    const auto is_command = [](const std::string& name) {
        return commands::command_named(name).has_value();
    };
    file_.recall([&](const auto& file) { settings_ = tools::read_pen_settings(file, is_command); });
    for (view::CanvasView* view : studio_.views())
        view->set_pen(settings_);
}

/// It stays open beside the canvas, where the pen can be tried as well.
void PenCommands::show_dialog() {
    if (dialog_ == nullptr) {
        dialog_ = new panels::PenDialog(settings_, &studio_.window());
        connect(dialog_, &panels::PenDialog::changed, this, &PenCommands::use);
    }
    dialog_->show_devices(present_pens());
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
}

void PenCommands::use(const tools::PenSettings& settings) {
    settings_ = settings;
    for (view::CanvasView* view : studio_.views())
        view->set_pen(settings_);
    remember();
}

void PenCommands::remember() {
    file_.remember([this](const auto& file) { tools::write_pen_settings(settings_, file); });
}

void PenCommands::turn_pen(bool eraser_end) {
    tools::Easel& easel = studio_.easel();
    if (easel.brush_is_lent()) return;
    const bool changed =
        eraser_end ? eraser_.turn_over(settings_.eraser_tool, easel) : eraser_.turn_back(easel);
    if (changed) studio_.show_hand();
}

void PenCommands::give(const QString& name) {
    if (const auto command = commands::command_named(name.toStdString()))
        studio_.commands().action(*command)->trigger();
}

void PenCommands::turn_wheel(int notches) {
    const tools::PenAction& action =
        settings_.action(notches > 0 ? tools::PenButton::WheelForward : tools::PenButton::WheelBack);
    if (action.does != tools::PenButtonDoes::Command) return;
    for (int i = 0; i < std::abs(notches); ++i)
        give(QString::fromStdString(action.command));
}

/// Two fingers take a step back, three do it again.
void PenCommands::tap(int fingers) {
    using commands::Command;
    if (fingers == 2) studio_.commands().action(Command::Undo)->trigger();
    if (fingers == 3) studio_.commands().action(Command::Redo)->trigger();
}

}  // namespace pastoso::main
