#include "main/canvas/undo_commands.hpp"

#include "main/layers/layer_transform.hpp"
#include "panels/history/history_panel.hpp"

#include <QAction>

namespace pastoso::main {

using commands::Command;

UndoCommands::UndoCommands(Studio& studio, panels::HistoryPanel* history, LayerTransform& transform)
    : studio_(studio), history_(history), transform_(transform) {
    studio_.commands().on(Command::Undo, [this](bool) {
        if (!transform_.cancel()) studio_.easel().undo();
    });
    studio_.commands().on(Command::Redo, [this](bool) {
        transform_.end();
        studio_.easel().redo();
    });
    connect(&studio_, &Studio::session_begun, this, &UndoCommands::apply_memory);
    connect(&studio_, &Studio::published, this, [this](const auto&, const session::Status& status) {
        show_enabled(status);
        show_steps();
    });
    connect(history_, &panels::HistoryPanel::steps_back, this, &UndoCommands::go_back);
    connect(&transform_, &LayerTransform::changed, this,
            [this] { show_enabled(studio_.session().status()); });
}

void UndoCommands::show_enabled(const session::Status& status) {
    studio_.commands()
        .action(Command::Undo)
        ->setEnabled(status.can_undo || status.stroke_in_progress || transform_.active());
    studio_.commands().action(Command::Redo)->setEnabled(status.can_redo);
}

void UndoCommands::show_steps() {
    auto steps = studio_.session().steps();
    if (steps == shown_steps_) return;
    shown_steps_ = std::move(steps);
    history_->show_steps(*shown_steps_, memory_MiB_);
}

void UndoCommands::go_back(int steps) {
    transform_.cancel();
    for (; steps > 0; --steps)
        studio_.easel().undo();
    for (; steps < 0; ++steps)
        studio_.easel().redo();
}

void UndoCommands::set_memory(int MiB) {
    memory_MiB_ = MiB;
    apply_memory();
}

void UndoCommands::apply_memory() {
    studio_.session().set_history_budget(static_cast<std::size_t>(memory_MiB_) << 20);
}

}  // namespace pastoso::main
