// What MainWindow finds again at the next start: the pen's settings, the panels, the painter's paints.

#include "core/error.hpp"
#include "core/user_data.hpp"
#include "main/main_window.hpp"
#include "main/view_commands.hpp"
#include "panels/brush_panel.hpp"
#include "panels/colour_panel.hpp"
#include "tools/settings.hpp"

#include <functional>

#include <QAction>
#include <QDockWidget>
#include <QInputDialog>

namespace pastoso::main {
namespace {

/// Of the panels' names: what was remembered of others is not used.
constexpr int kPanelsVersion = 3;

constexpr int kSettling_ms = 1000;

std::filesystem::path settings_file() {
    return core::user_config_path("settings.json");
}

std::filesystem::path export_file() {
    return core::user_config_path("export.json");
}

std::filesystem::path shelf_file() {
    return core::user_data_path("paints.json");
}

QByteArray from_text(const std::string& text) {
    return QByteArray::fromBase64(QByteArray::fromStdString(text));
}

std::string to_text(const QByteArray& bytes) {
    return bytes.toBase64().toStdString();
}

}  // namespace

/// A file that cannot be read is told, and left as it is.
void MainWindow::recall() {
    first_panels_ = saveState(kPanelsVersion);
    const auto read = [this](const std::function<void()>& reading) {
        try {
            reading();
            return true;
        } catch (const core::InputError& error) {
            report(QString::fromUtf8(error.what()));
            return false;
        }
    };
    tools::Settings settings;
    settings_usable_ = read([&] { settings = tools::read_settings(settings_file()); });
    shelf_usable_ = read([&] { colours_->show_shelf(tools::read_shelf(shelf_file())); });
    export_settings_usable_ =
        read([&] { export_settings_ = tools::read_export_settings(export_file()); });
    set_undo_memory(settings.undo_memory_MiB);
    view_commands_->light_from(settings.light_elevation_deg, settings.light_azimuth_deg);
    commands_.on(commands::Command::UndoMemory, [this](bool) { ask_undo_memory(); });
    tools::Hand hand = easel_->hand();
    hand.stabiliser = tools::stabiliser_of(settings.steadying);
    hand.reload_each_stroke = settings.reload_each_stroke;
    hand.turn_with_stroke = settings.turn_with_stroke;
    easel_->adopt(hand);
    brushes_->show_steadying(settings.steadying);
    restoreGeometry(from_text(settings.window_place));
    well_sized_ = restoreState(from_text(settings.panels), kPanelsVersion);
    paints_changed_.setSingleShot(true);
    paints_changed_.setInterval(kSettling_ms);
    connect(&paints_changed_, &QTimer::timeout, this, &MainWindow::remember_paints);
    connect(colours_, &panels::ColourPanel::shelf_changed, &paints_changed_,
            qOverload<>(&QTimer::start));
    commands_.on(commands::Command::ResetPanels, [this](bool) { reset_panels(); });
}

void MainWindow::remember() {
    remember_paints();
    if (!settings_usable_ || settings_file().empty()) return;
    const tools::Hand& hand = easel_->hand();
    tools::Settings settings;
    settings.steadying = brushes_->steadying();
    settings.reload_each_stroke = hand.reload_each_stroke;
    settings.turn_with_stroke = hand.turn_with_stroke;
    settings.undo_memory_MiB = undo_memory_MiB_;
    settings.light_azimuth_deg = canvas_->lighting().azimuth_deg;
    settings.light_elevation_deg = canvas_->lighting().elevation_deg;
    settings.window_place = to_text(saveGeometry());
    settings.panels = to_text(saveState(kPanelsVersion));
    try {
        tools::write_settings(settings, settings_file());
    } catch (const core::InputError& error) {
        report(QString::fromUtf8(error.what()));
    }
}

void MainWindow::remember_export() {
    if (!export_settings_usable_ || export_file().empty()) return;
    try {
        tools::write_export_settings(export_settings_, export_file());
    } catch (const core::InputError& error) {
        report(QString::fromUtf8(error.what()));
    }
}

void MainWindow::remember_paints() {
    paints_changed_.stop();
    if (!shelf_usable_ || shelf_file().empty()) return;
    try {
        tools::write_shelf(colours_->shelf(), shelf_file());
    } catch (const core::InputError& error) {
        report(QString::fromUtf8(error.what()));
    }
}

void MainWindow::ask_undo_memory() {
    constexpr int kStep_MiB = 256;
    QInputDialog dialog(this);
    dialog.setWindowTitle(tr("Memory for undo"));
    dialog.setLabelText(
        tr("The steps that you can return to may take so much memory, in MiB.\n"
           "The oldest are given up when it is full; 500 are kept at most."));
    dialog.setIntRange(tools::kLeastUndoMemory_MiB, tools::kMostUndoMemory_MiB);
    dialog.setIntStep(kStep_MiB);
    dialog.setIntValue(undo_memory_MiB_);
    if (dialog.exec() == QDialog::Accepted) set_undo_memory(dialog.intValue());
}

void MainWindow::set_undo_memory(int MiB) {
    undo_memory_MiB_ = MiB;
    session_->set_history_budget(static_cast<std::size_t>(MiB) << 20);
}

void MainWindow::reset_panels() {
    restoreState(first_panels_, kPanelsVersion);
    well_sized_ = false;
    QDockWidget* first = docks_.at(commands::Command::ToolPanel);
    first->raise();
    resizeDocks({first}, {1}, Qt::Horizontal);
}

}  // namespace pastoso::main
