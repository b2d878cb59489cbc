#include "main/pen/brush_bundles.hpp"

#include "main/pen/brush_jar.hpp"
#include "project/brush_bundle.hpp"

#include <QFileDialog>
#include <QMainWindow>

namespace pastoso::main {
namespace {

std::vector<brush::Preset> own_presets(const brush::PresetLibrary& library) {
    std::vector<brush::Preset> own;
    for (const auto& entry : library.entries)
        if (entry.own) own.push_back(entry.preset);
    return own;
}

}  // namespace

BrushBundles::BrushBundles(Studio& studio, BrushJar& jar) : studio_(studio), jar_(jar) {
    studio_.commands().on(commands::Command::ImportBrushes, [this](bool) { ask_import(); });
    studio_.commands().on(commands::Command::ExportBrushes, [this](bool) { ask_export(); });
}

void BrushBundles::ask_import() {
    const QString path = QFileDialog::getOpenFileName(&studio_.window(), tr("Import tools"), QString(),
                                                      tr("Bundles of tools (*.zip)"));
    if (!path.isEmpty()) import_from(path);
}

void BrushBundles::import_from(const QString& path) {
    studio_.attempt(tr("Import tools"), [&] {
        const auto presets = project::read_brush_bundle(path.toStdString());
        const auto added = brush::add_presets(jar_.library(), presets, BrushJar::folder());
        jar_.read();
        studio_.report(added.empty() ? tr("You have all tools of that bundle already.")
                                     : tr("%n tool(s) added to your own.", nullptr,
                                          static_cast<int>(added.size())));
    });
    studio_.show_hand();
}

void BrushBundles::ask_export() {
    if (own_presets(jar_.library()).empty())
        return studio_.report(tr("You have no tools of your own yet; save the one in hand first."));
    const QString path = QFileDialog::getSaveFileName(
        &studio_.window(), tr("Export my tools"), tr("my-tools.zip"), tr("Bundles of tools (*.zip)"));
    if (!path.isEmpty()) export_to(path);
}

void BrushBundles::export_to(const QString& path) {
    studio_.attempt(tr("Export my tools"), [&] {
        project::write_brush_bundle(own_presets(jar_.library()), path.toStdString());
        studio_.report(tr("Saved %1.").arg(path));
    });
}

}  // namespace pastoso::main
