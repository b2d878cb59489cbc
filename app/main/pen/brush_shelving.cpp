#include "main/pen/brush_shelving.hpp"

#include "core/user_data.hpp"
#include "dialogs/name_question.hpp"
#include "main/pen/brush_jar.hpp"
#include "panels/pen/brush_panel.hpp"

#include <QAction>
#include <QMainWindow>

namespace pastoso::main {

using commands::Command;

namespace {

std::vector<std::string> texts(const QStringList& names) {
    std::vector<std::string> texts;
    for (const QString& name : names)
        texts.push_back(name.toStdString());
    return texts;
}

/// By name, as they stand now.
std::vector<std::string> all_tools(const panels::BrushPanel& panel, const tools::BrushShelf& shelf) {
    std::vector<std::string> names;
    for (const panels::BrushEntry& entry : panels::chosen_brushes(panel.brushes(), shelf, {}))
        if (entry.fault.isEmpty()) names.push_back(entry.name.toStdString());
    return names;
}

}  // namespace

BrushShelving::BrushShelving(Studio& studio, const BrushJar& jar, panels::BrushPanel* brushes)
    : studio_(studio),
      brushes_(brushes),
      file_(studio, core::user_data_path("brush-shelf.json"),
            [](const auto& file) { tools::read_brush_shelf(file); }) {
    studio_.commands().on(Command::FavouriteBrush, [this](bool favourite) { set_favourite(favourite); });
    connect(&studio_, &Studio::hand_changed, this, &BrushShelving::note);
    connect(brushes_, &panels::BrushPanel::arranged, this, &BrushShelving::arrange);
    connect(brushes_, &panels::BrushPanel::tagged, this, &BrushShelving::set_tag);
    connect(brushes_, &panels::BrushPanel::new_tag_wanted, this, &BrushShelving::ask_tag);
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
    show();
}

/// What is shown without an order of its own stands in that of all tools.
void BrushShelving::arrange(const panels::BrushChoice& choice, const QStringList& shown) {
    using Kind = panels::BrushChoice::Kind;
    const std::vector<std::string> names = texts(shown);
    const bool searched = !choice.typed.trimmed().isEmpty();
    if (searched || choice.kind == Kind::All || choice.kind == Kind::Family || choice.kind == Kind::Own)
        shelf_.order = tools::rearranged(all_tools(*brushes_, shelf_), names);
    else if (choice.kind == Kind::Favourites)
        shelf_.favourites = tools::rearranged(shelf_.favourites, names);
    else if (choice.kind == Kind::Tag)
        tools::arrange_tag(choice.name.toStdString(), names, shelf_);
    show();
}

void BrushShelving::set_tag(const QString& tool, const QString& tag, bool tagged) {
    if (!tools::set_tag(tool.toStdString(), tag.toStdString(), tagged, shelf_))
        return studio_.report(tr("A tag needs a name."));
    show();
}

void BrushShelving::add_tags(const std::vector<tools::BrushTag>& tags) {
    for (const tools::BrushTag& tag : tags)
        for (const std::string& tool : tag.tools)
            tools::set_tag(tool, tag.name, true, shelf_);
    show();
}

void BrushShelving::ask_tag(const QString& tool) {
    const auto name = dialogs::ask_name(
        {.title = tr("New tag"), .label = tr("Name of the tag:"), .proposal = {}}, &studio_.window());
    if (name) set_tag(tool, *name, true);
}

void BrushShelving::show() {
    brushes_->show_shelf(shelf_);
    remember();
}

}  // namespace pastoso::main
