// MainWindow's jar of brushes: the bundled ones and the painter's own, kept, renamed and thrown away.

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/user_data.hpp"
#include "main/main_window.hpp"
#include "panels/brush_panel.hpp"
#include "panels/curves_panel.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QEvent>
#include <QInputDialog>
#include <QMessageBox>

namespace pastoso::main {
namespace {

using commands::Command;

/// Long enough for a program that writes a file in pieces.
constexpr int kSettling_ms = 150;

/// The heading that a tool stands under, and its place among the headings.
struct Family {
    int rank;
    QString heading;
};

/// Bristles first, then what is stiff, then what is soft.
Family family_of(const brush::Preset& preset) {
    if (preset.kind == brush::ToolKind::Droplets) return {3, QObject::tr("Drops and sprays")};
    if (preset.kind == brush::ToolKind::Air) return {4, QObject::tr("Air")};
    switch (preset.tip.shape) {
        case brush::TipShape::Knife:
        case brush::TipShape::Comb:
            return {1, QObject::tr("Knives and combs")};
        case brush::TipShape::Pad:
            return {2, QObject::tr("Rags and fingers")};
        default:
            return {0, QObject::tr("Brushes")};
    }
}

std::filesystem::path brush_folder() {
    return core::user_data_path("brushes");
}

/// Tools by family, then what cannot be taken.
std::vector<panels::BrushEntry> entries_of(const brush::PresetLibrary& library) {
    std::vector<brush::PresetLibrary::Entry> tools = library.entries;
    std::stable_sort(tools.begin(), tools.end(), [](const auto& a, const auto& b) {
        return family_of(a.preset).rank < family_of(b.preset).rank;
    });
    std::vector<panels::BrushEntry> entries;
    for (const auto& [preset, own, file] : tools)
        entries.push_back(
            {QString::fromStdString(preset.name), family_of(preset).heading, preset.tip.width_mm, own});
    for (const auto& [file, sentence] : library.faults)
        entries.push_back({QString::fromStdString(file.filename().string()),
                           QObject::tr("Cannot be read"), 0.0, true, QString::fromStdString(sentence)});
    return entries;
}

}  // namespace

void MainWindow::connect_brush_commands() {
    commands_.on(Command::SaveBrush, [this](bool) { save_brush(); });
    commands_.on(Command::RenameBrush, [this](bool) { rename_brush(); });
    commands_.on(Command::DeleteBrush, [this](bool) { delete_brush(); });
    connect(curves_, &panels::CurvesPanel::edited, this, [this](const brush::Preset& preset) {
        easel_->change_brush(preset);
        show_hand();
    });
    brushes_changed_.setSingleShot(true);
    brushes_changed_.setInterval(kSettling_ms);
    connect(&brushes_changed_, &QTimer::timeout, this, &MainWindow::reread_brushes);
    const auto soon = [this] { brushes_changed_.start(); };
    connect(&brush_files_, &QFileSystemWatcher::fileChanged, this, soon);
    connect(&brush_files_, &QFileSystemWatcher::directoryChanged, this, soon);
}

/// For a painter who has just made the folder that is watched from now on.
void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::ActivationChange && isActiveWindow() &&
        brush_files_.directories().isEmpty() && !brush_folder().empty() &&
        std::filesystem::exists(brush_folder())) {
        reread_brushes();
    }
    QMainWindow::changeEvent(event);
}

// ---- the list

void MainWindow::read_brushes() {
    library_ = brush::load_presets(brush_folder());
    QStringList watched;
    if (std::filesystem::exists(brush_folder()))
        watched += QString::fromStdString(brush_folder().string());
    for (const auto& entry : library_.entries)
        if (entry.own) watched += QString::fromStdString(entry.file.string());
    for (const auto& fault : library_.faults)
        watched += QString::fromStdString(fault.file.string());
    if (!watched.isEmpty()) brush_files_.addPaths(watched);
    list_brushes();
    for (const auto& fault : library_.faults)
        report(QString::fromStdString(fault.sentence));
}

void MainWindow::list_brushes() {
    thumbnails_->forget();
    brushes_->show_brushes(entries_of(library_));
    brushes_->show_brush(QString::fromStdString(easel_->hand().brush), easel_->hand().brush_width_mm);
}

/// A tool in hand that was not changed in the meantime follows its file.
void MainWindow::reread_brushes() {
    const brush::Preset before = kept_brush();
    read_brushes();
    const brush::Preset now = kept_brush();
    if (tools::preset_in_hand(easel_->hand()) == before && !(now == before)) {
        easel_->change_brush(now);
        report(tr("%1 was read again; the next stroke is painted with it.")
                   .arg(QString::fromStdString(now.name)));
    }
    show_hand();
}

void MainWindow::take_brush(const QString& name, double width_mm) {
    const auto* entry = brush::find_entry(library_, name.toStdString());
    if (entry != nullptr) easel_->take_brush(entry->preset, width_mm);
    show_hand();
}

/// The tool in hand as it is kept, or itself where it is kept nowhere.
brush::Preset MainWindow::kept_brush() const {
    const auto* entry = brush::find_entry(library_, easel_->hand().brush);
    return entry != nullptr ? entry->preset : tools::preset_in_hand(easel_->hand());
}

bool MainWindow::own_brush_in_hand() const {
    const auto* entry = brush::find_entry(library_, easel_->hand().brush);
    return entry != nullptr && entry->own;
}

// ---- the painter's own

bool MainWindow::ask_name(const QString& title, QString& name) {
    bool accepted = false;
    name =
        QInputDialog::getText(this, title, tr("Name of the tool:"), QLineEdit::Normal, name, &accepted)
            .trimmed();
    return accepted && !name.isEmpty();
}

bool MainWindow::confirmed(const QString& question, const QString& action) {
    QMessageBox box(QMessageBox::Question, tr("Pastoso"), question, QMessageBox::Cancel, this);
    box.addButton(action, QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    return box.exec() != QMessageBox::Cancel;
}

void MainWindow::save_brush() {
    const tools::Hand& hand = easel_->hand();
    const QString old_name = QString::fromStdString(hand.brush);
    QString name = own_brush_in_hand() ? old_name : tr("My %1").arg(old_name);
    if (!ask_name(tr("Save as my own"), name)) return;
    brush::Preset preset = brush::resized(tools::preset_in_hand(hand), hand.brush_width_mm);
    preset.name = name.toStdString();
    const auto* same = brush::find_entry(library_, preset.name);
    const bool in_the_way = (same != nullptr && same->own) ||
                            std::filesystem::exists(brush::preset_file(preset.name, brush_folder()));
    if (in_the_way &&
        !confirmed(tr("There is already a tool of your own named \"%1\".").arg(name), tr("Overwrite")))
        return;
    try {
        const std::filesystem::path file = brush::save_preset(preset, brush_folder());
        if (same != nullptr && same->own && same->file != file) brush::delete_preset(*same);
        easel_->change_brush(preset);
        read_brushes();
        report(tr("Kept \"%1\" among your own.").arg(name));
    } catch (const core::InputError& error) {
        report(QString::fromUtf8(error.what()));
    }
    show_hand();
}

void MainWindow::rename_brush() {
    const auto* entry = brush::find_entry(library_, easel_->hand().brush);
    if (entry == nullptr || !entry->own) return;
    QString name = QString::fromStdString(entry->preset.name);
    if (!ask_name(tr("Rename"), name)) return;
    try {
        brush::rename_preset(library_, *entry, name.toStdString());
        brush::Preset preset = tools::preset_in_hand(easel_->hand());
        preset.name = name.toStdString();
        easel_->change_brush(preset);
        read_brushes();
    } catch (const core::InputError& error) {
        report(QString::fromUtf8(error.what()));
    }
    show_hand();
}

void MainWindow::delete_brush() {
    const auto* entry = brush::find_entry(library_, easel_->hand().brush);
    if (entry == nullptr || !entry->own) return;
    const QString name = QString::fromStdString(entry->preset.name);
    if (!confirmed(tr("Throw your tool \"%1\" away? Its file is deleted.").arg(name), tr("Delete")))
        return;
    try {
        brush::delete_preset(*entry);
        read_brushes();
        report(tr("\"%1\" is thrown away; what you have in hand stays.").arg(name));
    } catch (const core::InputError& error) {
        report(QString::fromUtf8(error.what()));
    }
    show_hand();
}

}  // namespace pastoso::main
