#include "main/paint/well_commands.hpp"

#include "document/well.hpp"
#include "main/canvas/said_pointer.hpp"

#include <utility>

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>

namespace pastoso::main {

using commands::Command;

WellCommands::WellCommands(Studio& studio, QDockWidget* dock) : studio_(studio), dock_(dock) {
    say_pointer(studio_.well());
    studio_.well().setAccessibleName(dock_->windowTitle());
    connect(dock_, &QDockWidget::visibilityChanged, this,
            [this] { studio_.commands().action(Command::MixingWell)->setChecked(!dock_->isHidden()); });
    studio_.commands().on(Command::MixingWell, [this](bool opened) { open(opened); });
    studio_.commands().on(Command::ResetPanels, [this](bool) { sized_ = false; });
    studio_.commands().on(Command::SqueezePaint, [this](bool) { squeeze(); });
    studio_.commands().on(Command::CleanWell, [this](bool) { studio_.easel().clean_well(); });
    connect(&studio_, &Studio::published, this, [this](const auto& painting) { show(*painting); });
}

/// The first time it is given room to mix in; after that it is as large as the painter leaves it.
void WellCommands::open(bool open) {
    dock_->setVisible(open);
    if (!open || std::exchange(sized_, true)) return;
    constexpr int kRoomy = 320;
    studio_.window().resizeDocks({dock_}, {kRoomy}, Qt::Vertical);
}

void WellCommands::squeeze() {
    const auto place_mm = studio_.well().pointer_mm();
    if (place_mm)
        studio_.easel().squeeze(place_mm->x, place_mm->y);
    else
        studio_.easel().squeeze_next();
    open(true);
}

/// The view is left alone while nothing in the well changes.
void WellCommands::show(const document::Snapshot& painting) {
    static const film::FilmState bare = document::bare_well();
    auto well = std::make_shared<const document::Snapshot>(painting.well.value_or(bare), painting.ground,
                                                           painting.tick);
    if (shown_ != nullptr && screen::changed_tiles(shown_.get(), *well).empty()) return;
    shown_ = std::move(well);
    studio_.well().show_snapshot(shown_);
}

}  // namespace pastoso::main
