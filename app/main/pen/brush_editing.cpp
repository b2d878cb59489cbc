#include "main/pen/brush_editing.hpp"

#include "brush/preset_fields.hpp"
#include "main/pen/brush_jar.hpp"
#include "panels/pen/brush_editor.hpp"
#include "panels/pen/curves_panel.hpp"

#include <QAction>
#include <QMainWindow>

namespace pastoso::main {

using commands::Command;

BrushEditing::BrushEditing(Studio& studio, const BrushJar& jar, panels::CurvesPanel* curves)
    : studio_(studio), jar_(jar), curves_(curves) {
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
    editor_->open_page(page_);
    connect(editor_, &panels::BrushEditor::shown, curves_,
            [curves = curves_](bool shown) { curves->setHidden(shown); });
    connect(editor_, &panels::BrushEditor::edited, this, [this](const brush::Preset& preset) {
        studio_.easel().change_brush(preset, preset.tip.width_mm);
        studio_.show_hand();
    });
    connect(editor_, &panels::BrushEditor::width_chosen, this, [this](double width_mm) {
        studio_.easel().change_brush(tools::preset_in_hand(studio_.easel().hand()), width_mm);
        studio_.show_hand();
    });
}

int BrushEditing::page() const {
    return editor_ == nullptr ? page_ : editor_->open_page();
}

void BrushEditing::set_page(int page) {
    page_ = page;
    if (editor_ != nullptr) editor_->open_page(page);
}

void BrushEditing::show() {
    editor_->show_tool(brush::within_ranges(tools::sized_preset_in_hand(studio_.easel().hand())),
                       jar_.kept_brush());
}

}  // namespace pastoso::main
