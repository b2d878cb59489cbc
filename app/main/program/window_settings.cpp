#include "main/program/window_settings.hpp"

#include "commands/command_names.hpp"
#include "core/user_data.hpp"
#include "main/canvas/undo_commands.hpp"
#include "main/dock_heights.hpp"
#include "main/files/start_commands.hpp"
#include "main/paint/light_choice.hpp"
#include "main/paint/well_commands.hpp"
#include "main/pen/brush_editing.hpp"
#include "main/program/tour_commands.hpp"
#include "panels/paint/medium_panel.hpp"
#include "panels/pen/brush_panel.hpp"
#include "tools/settings.hpp"

#include <cstddef>

#include <QMainWindow>

namespace pastoso::main {
namespace {

/// Of the panels' names: what was remembered of others is not used.
constexpr int kPanelsVersion = 4;

QByteArray from_text(const std::string& text) {
    return QByteArray::fromBase64(QByteArray::fromStdString(text));
}

std::string to_text(const QByteArray& bytes) {
    return bytes.toBase64().toStdString();
}

/// Of another version's commands, those that this one has.
std::vector<commands::Command> commands_named(const std::vector<std::string>& names) {
    std::vector<commands::Command> found;
    for (const std::string& name : names)
        if (const auto command = commands::command_named(name)) found.push_back(*command);
    return found;
}

/// As many as the palette shows without scrolling, and some more.
std::vector<std::string> recent_names(const commands::CommandRegistry& commands) {
    constexpr std::size_t kMostRecent = 24;
    std::vector<std::string> names;
    for (const commands::Command command : commands.recent())
        if (names.size() < kMostRecent) names.emplace_back(commands::name_of(command));
    return names;
}

}  // namespace

WindowSettings::WindowSettings(Studio& studio, const PanelSet& panels, LightChoice& light,
                               UndoCommands& undo, WellCommands& well, StartCommands& start,
                               BrushEditing& brush_editing, TourCommands& tour, DockHeights& heights)
    : studio_(studio),
      panels_(panels),
      light_(light),
      undo_(undo),
      well_(well),
      start_(start),
      brush_editing_(brush_editing),
      tour_(tour),
      heights_(heights),
      file_(studio, core::user_config_path("settings.json"),
            [](const auto& file) { tools::read_settings(file); }) {}

bool WindowSettings::recall() {
    QMainWindow& window = studio_.window();
    tools::Settings settings;
    file_.recall([&settings](const auto& file) { settings = tools::read_settings(file); });
    start_.set_shown_at_start(settings.show_start_page);
    tour_.set_seen(settings.tour_seen);
    undo_.set_memory(settings.undo_memory_MiB);
    light_.use_lamp({.azimuth_deg = settings.light_azimuth_deg,
                     .elevation_deg = settings.light_elevation_deg,
                     .ambient = settings.light_ambient});
    light_.use_varnish(settings.varnish);
    studio_.commands().set_recent(commands_named(settings.recent_commands));
    tools::Hand hand = studio_.easel().hand();
    hand.stabiliser = tools::stabiliser_of(settings.steadying);
    hand.reload_each_stroke = settings.reload_each_stroke;
    hand.turn_with_stroke = settings.turn_with_stroke;
    studio_.easel().adopt(hand);
    panels_.brushes->show_steadying(settings.steadying);
    panels_.physics->open_numbers(settings.medium_numbers_open);
    brush_editing_.set_page(settings.brush_editor_page);
    window.restoreGeometry(from_text(settings.window_place));
    const bool panels_stand = window.restoreState(from_text(settings.panels), kPanelsVersion);
    if (panels_stand && settings.panels_by_hand) heights_.leave_as_they_are();
    well_.set_sized(panels_stand);
    return panels_stand;
}

void WindowSettings::remember() {
    const tools::Hand& hand = studio_.easel().hand();
    tools::Settings settings;
    settings.steadying = panels_.brushes->steadying();
    settings.reload_each_stroke = hand.reload_each_stroke;
    settings.turn_with_stroke = hand.turn_with_stroke;
    settings.show_start_page = start_.shown_at_start();
    settings.tour_seen = tour_.seen();
    settings.undo_memory_MiB = undo_.memory_MiB();
    settings.light_azimuth_deg = light_.lamp().azimuth_deg;
    settings.light_elevation_deg = light_.lamp().elevation_deg;
    settings.light_ambient = light_.lamp().ambient;
    settings.varnish = light_.varnish();
    settings.recent_commands = recent_names(studio_.commands());
    settings.medium_numbers_open = panels_.physics->numbers_open();
    settings.brush_editor_page = brush_editing_.page();
    settings.window_place = to_text(studio_.window().saveGeometry());
    settings.panels = to_text(studio_.window().saveState(kPanelsVersion));
    settings.panels_by_hand = !heights_.follows();
    file_.remember([&settings](const auto& file) { tools::write_settings(settings, file); });
}

}  // namespace pastoso::main
