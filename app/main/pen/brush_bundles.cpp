#include "main/pen/brush_bundles.hpp"

#include "main/pen/brush_jar.hpp"
#include "main/pen/brush_shelving.hpp"
#include "project/brush_bundle.hpp"

#include <algorithm>
#include <map>

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

/// With a tool of the painter's own, and all that else have them.
std::vector<project::BundledTag> tags_of(const std::vector<brush::Preset>& own,
                                         const std::vector<tools::BrushTag>& tags) {
    std::vector<project::BundledTag> with_own;
    const auto is_own = [&](const std::string& tool) {
        return std::ranges::find(own, tool, &brush::Preset::name) != own.end();
    };
    for (const tools::BrushTag& tag : tags)
        if (std::ranges::any_of(tag.tools, is_own)) with_own.push_back({tag.name, tag.tools});
    return with_own;
}

/// Under which names a bundle's tools are in the library once they are `added` to it.
std::map<std::string, std::string> names_there(const std::vector<brush::Preset>& presets,
                                               const brush::PresetLibrary& before,
                                               const std::vector<std::string>& added) {
    std::map<std::string, std::string> names;
    auto next = added.begin();
    for (const brush::Preset& preset : presets) {
        const auto* same = brush::find_entry(before, preset.name);
        const bool is_left_out = same != nullptr && same->preset == preset;
        names[preset.name] = is_left_out ? preset.name : *next++;
    }
    return names;
}

/// Of tools that are there.
std::vector<tools::BrushTag> tags_here(const std::vector<project::BundledTag>& tags,
                                       const std::map<std::string, std::string>& names,
                                       const brush::PresetLibrary& library) {
    std::vector<tools::BrushTag> here;
    for (const project::BundledTag& tag : tags) {
        tools::BrushTag& one = here.emplace_back(tools::BrushTag{tag.name, {}});
        for (const std::string& tool : tag.tools) {
            const auto named = names.find(tool);
            const std::string& name = named == names.end() ? tool : named->second;
            if (brush::find_entry(library, name) != nullptr) one.tools.push_back(name);
        }
    }
    return here;
}

}  // namespace

BrushBundles::BrushBundles(Studio& studio, BrushJar& jar, BrushShelving& shelf)
    : studio_(studio), jar_(jar), shelf_(shelf) {
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
        const auto [presets, tags] = project::read_brush_bundle(path.toStdString());
        const auto added = brush::add_presets(jar_.library(), presets, BrushJar::folder());
        const auto names = names_there(presets, jar_.library(), added);
        jar_.read();
        shelf_.add_tags(tags_here(tags, names, jar_.library()));
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
        const std::vector<brush::Preset> own = own_presets(jar_.library());
        project::write_brush_bundle({own, tags_of(own, shelf_.tags())}, path.toStdString());
        studio_.report(tr("Saved %1.").arg(path));
    });
}

}  // namespace pastoso::main
