#include "main/paint/tube_commands.hpp"

#include "core/user_data.hpp"
#include "dialogs/name_question.hpp"
#include "document/actions/actions.hpp"
#include "panels/paint/paint_panel.hpp"
#include "panels/paint/tube_menu.hpp"
#include "tools/paint_shelf.hpp"
#include "tools/swatch.hpp"

#include <utility>

#include <QAction>
#include <QFileDialog>
#include <QMainWindow>

namespace pastoso::main {
namespace {

tools::Tubes tubes_of(const QStringList& names) {
    tools::Tubes tubes;
    for (const QString& name : names)
        tubes.push_back(name.toStdString());
    return tubes;
}

static_assert(tools::SqueezedPaints::kMost <= tools::kMostKeptPaints, "they are kept as kept paints");

QStringList names_of(const tools::Tubes& tubes) {
    QStringList names;
    for (const std::string& tube : tubes)
        names += QString::fromStdString(tube);
    return names;
}

}  // namespace

TubeCommands::TubeCommands(Studio& studio, panels::PaintPanel* tubes)
    : studio_(studio),
      panel_(tubes),
      all_(tubes_of(tubes->tubes())),
      file_(studio, core::user_data_path("tubes.json"),
            [](const auto& file) { tools::read_rack(file); }),
      palette_file_(studio, core::user_data_path("last-palette.json")) {
    connect(&studio_, &Studio::session_ends, this,
            [this] { studio_.easel().squeezed_paints().begin(puddles()); });
    panels::TubeMenu& sets = panel_->sets();
    connect(panel_, &panels::PaintPanel::arranged, this,
            [this] { change([this](auto& rack) { tools::arrange(tubes_of(panel_->tubes()), rack); }); });
    connect(panel_, &panels::PaintPanel::put_into_set, this,
            [this](const QString& tube, const QString& set) {
                change([&](auto& rack) {
                    tools::put_into_set(tube.toStdString(), set.toStdString(), rack);
                });
            });
    connect(panel_, &panels::PaintPanel::taken_out, this, [this](const QString& tube) {
        change([&](auto& rack) { tools::take_out(tube.toStdString(), rack); });
    });
    connect(&sets, &panels::TubeMenu::chosen_set, this, [this](const QString& name) {
        change([&](auto& rack) { rack.chosen = name.toStdString(); });
    });
    connect(&sets, &panels::TubeMenu::removal_wanted, this, [this] { change(tools::remove_chosen); });
    connect(&sets, &panels::TubeMenu::squeeze_wanted, this, &TubeCommands::squeeze_set);
    connect(&sets, &panels::TubeMenu::last_palette_wanted, this, &TubeCommands::squeeze_last_palette);
    connect(&sets, &panels::TubeMenu::export_wanted, this, &TubeCommands::ask_export);
    connect(&sets, &panels::TubeMenu::import_wanted, this, &TubeCommands::ask_import);
    connect(&sets, &panels::TubeMenu::save_wanted, this, [this] {
        const auto name = asked_name(tr("Save the tubes as a set"), panel_->sets().chosen());
        if (name) save_set(*name);
    });
    connect(&sets, &panels::TubeMenu::rename_wanted, this, [this] {
        const auto name = asked_name(tr("Rename the set"), panel_->sets().chosen());
        if (name) rename_set(*name);
    });
}

void TubeCommands::recall() {
    file_.recall([this](const auto& file) { rack_ = tools::read_rack(file); });
    palette_file_.recall([this](const auto& file) {
        const tools::PaintShelf palette = tools::read_shelf(file);
        studio_.easel().squeezed_paints().set_last({palette.kept, palette.puddles});
    });
    show();
}

void TubeCommands::remember() {
    file_.remember([this](const auto& file) { tools::write_rack(rack_, file); });
}

/// As a set of paints is written, which it is.
void TubeCommands::remember_palette() {
    const tools::WellPalette latest = studio_.easel().squeezed_paints().latest(puddles());
    if (latest.empty()) return;
    tools::PaintShelf palette;
    palette.kept = latest.squeezed;
    palette.puddles = latest.puddles;
    palette_file_.remember([&](const auto& file) { tools::write_shelf(palette, file); });
}

std::optional<QString> TubeCommands::asked_name(const QString& title, const QString& name) {
    return dialogs::ask_name({.title = title, .label = tr("Name of the set:"), .proposal = name},
                             &studio_.window());
}

void TubeCommands::save_set(const QString& name) {
    const tools::Tubes tubes = tubes_of(panel_->tubes());
    change([&](auto& rack) {
        if (!tools::save_set(name.toStdString(), tubes, rack)) studio_.report(tr("A set needs a name."));
    });
}

void TubeCommands::rename_set(const QString& name) {
    change([&](auto& rack) {
        if (!tools::rename_chosen(name.toStdString(), rack))
            studio_.report(tr("Type another name: that one is empty, or another set's."));
    });
}

void TubeCommands::ask_export() {
    const QString path = QFileDialog::getSaveFileName(&studio_.window(), tr("Export my sets of tubes"),
                                                      tr("my-tubes.json"), tr("Sets of tubes (*.json)"));
    if (!path.isEmpty()) export_sets(path);
}

void TubeCommands::export_sets(const QString& path) {
    studio_.attempt(tr("Export my sets of tubes"), [&] {
        tools::write_tube_sets(rack_.sets, path.toStdString());
        studio_.report(tr("Saved %1.").arg(path));
    });
}

void TubeCommands::ask_import() {
    const QString path = QFileDialog::getOpenFileName(&studio_.window(), tr("Import sets of tubes"),
                                                      QString(), tr("Sets of tubes (*.json)"));
    if (!path.isEmpty()) import_sets(path);
}

void TubeCommands::import_sets(const QString& path) {
    studio_.attempt(tr("Import sets of tubes"), [&] {
        const std::vector<tools::TubeSet> sets = tools::read_tube_sets(path.toStdString());
        int added = 0;
        change([&](auto& rack) { added = tools::add_sets(sets, rack); });
        studio_.report(added == 0 ? tr("You have all sets of that file already.")
                                  : tr("%n set(s) added to your own.", nullptr, added));
    });
}

void TubeCommands::change(const std::function<void(tools::TubeRack&)>& work) {
    work(rack_);
    show();
    remember();
}

/// On the well as it is now.
std::vector<document::Puddle> TubeCommands::puddles() const {
    studio_.session().wait_until_applied();
    const auto painting = studio_.session().snapshot();
    if (!painting->well) return {};
    const film::Medium medium = document::medium_of(studio_.easel().hand().medium);
    return document::puddles_on(*painting->well, studio_.session().paints_used(), medium.pigment_share);
}

/// The tubes from the first free place of the well's edge on, mixtures where they lay; in one undo step.
void TubeCommands::squeeze_out(const tools::WellPalette& palette) {
    bool joins = false;
    for (const document::PaintRecipe& paint : palette.squeezed)
        studio_.easel().squeeze_next(paint, std::exchange(joins, true));
    for (const document::Puddle& puddle : palette.puddles)
        studio_.easel().squeeze_puddle(puddle, std::exchange(joins, true));
    QAction* well = studio_.commands().action(commands::Command::MixingWell);
    if (!well->isChecked()) well->trigger();
}

/// In the painter's order.
void TubeCommands::squeeze_set() {
    std::vector<document::PaintRecipe> paints;
    for (const std::string& tube : tools::shown_tubes(rack_, all_))
        paints.push_back(tools::tube_paint(tube));
    squeeze_out({paints, {}});
}

void TubeCommands::squeeze_last_palette() {
    const tools::WellPalette palette = studio_.easel().squeezed_paints().last();
    if (palette.empty())
        return studio_.report(tr("No paint was squeezed out beside an earlier painting yet."));
    squeeze_out(palette);
}

void TubeCommands::show() {
    QStringList names;
    for (const tools::TubeSet& set : rack_.sets)
        names += QString::fromStdString(set.name);
    const tools::TubeSet* chosen = tools::chosen_set(rack_);
    panel_->sets().show_sets(names,
                             chosen == nullptr ? QString() : QString::fromStdString(chosen->name));
    panel_->show_tubes(names_of(tools::shown_tubes(rack_, all_)));
}

}  // namespace pastoso::main
