#include "main/pen/brush_shelving.hpp"

#include "core/user_data.hpp"
#include "main/pen/brush_jar.hpp"
#include "panels/pen/brush_panel.hpp"

#include <QAction>

namespace pastoso::main {

using commands::Command;

BrushShelving::BrushShelving(Studio& studio, const BrushJar& jar, panels::BrushPanel* brushes)
    : studio_(studio), brushes_(brushes), file_(studio, core::user_data_path("brush-shelf.json")) {
    studio_.commands().on(Command::FavouriteBrush, [this](bool favourite) { set_favourite(favourite); });
    connect(&studio_, &Studio::hand_changed, this, &BrushShelving::note);
    connect(&jar, &BrushJar::renamed, this, [this](const std::string& before, const std::string& now) {
        tools::rename_on_shelf(before, now, shelf_);
    });
}

void BrushShelving::recall() {
    file_.recall([this](const auto& file) { shelf_ = tools::read_brush_shelf(file); });
    brushes_->show_shelf(shelf_);
}

void BrushShelving::remember() {
    file_.remember([this](const auto& file) { tools::write_brush_shelf(shelf_, file); });
}

void BrushShelving::note(const tools::Hand& hand) {
    tools::note_recent(hand.brush, shelf_);
    studio_.commands()
        .action(Command::FavouriteBrush)
        ->setChecked(tools::is_favourite(hand.brush, shelf_));
    brushes_->show_shelf(shelf_);
}

void BrushShelving::set_favourite(bool favourite) {
    tools::set_favourite(studio_.easel().hand().brush, favourite, shelf_);
    brushes_->show_shelf(shelf_);
    remember();
}

}  // namespace pastoso::main
