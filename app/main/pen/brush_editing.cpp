#include "main/pen/brush_editing.hpp"

#include "main/pen/brush_jar.hpp"
#include "panels/pen/brush_editor.hpp"

#include <QAction>
#include <QMainWindow>

namespace pastoso::main {

using commands::Command;

BrushEditing::BrushEditing(Studio& studio, const BrushJar& jar) : studio_(studio), jar_(jar) {
    studio_.commands().on(Command::BrushEditor, [this](bool) { show_or_hide(); });
    connect(&studio_, &Studio::hand_changed, this, [this] {
        if (editor_ != nullptr && editor_->isVisible()) show();
    });
}

/// Where it lies behind another window it comes to the front.
void BrushEditing::show_or_hide() {
    if (editor_ == nullptr) make();
    if (editor_->isVisible() && editor_->isActiveWindow()) return editor_->hide();
    show();
    editor_->show();
    editor_->raise();
    editor_->activateWindow();
}

void BrushEditing::make() {
    const auto action = [this](Command command) { return studio_.commands().action(command); };
    editor_ = new panels::BrushEditor(
        {action(Command::SaveBrush), action(Command::RenameBrush), action(Command::DeleteBrush)},
        studio_.teller(), &studio_.window());
    editor_->addAction(action(Command::BrushEditor));
    connect(editor_, &panels::BrushEditor::edited, this, [this](const brush::Preset& preset) {
        studio_.easel().change_brush(preset, preset.tip.width_mm);
        studio_.show_hand();
    });
}

void BrushEditing::show() {
    editor_->show_tool(tools::sized_preset_in_hand(studio_.easel().hand()), jar_.kept_brush());
}

}  // namespace pastoso::main
