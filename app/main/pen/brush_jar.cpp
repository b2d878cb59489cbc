#include "main/pen/brush_jar.hpp"

#include "appearance/picture_view.hpp"
#include "appearance/shown_message.hpp"
#include "appearance/shown_names.hpp"
#include "core/looking.hpp"
#include "core/text.hpp"
#include "core/user_data.hpp"
#include "dialogs/name_question.hpp"
#include "panels/pen/brush_list.hpp"
#include "panels/pen/brush_panel.hpp"
#include "panels/pen/curves_panel.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QEvent>
#include <QImage>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>

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

/// Bristles first, then what is stiff, then what is soft, then what does not touch.
Family family_of(const brush::Preset& preset) {
    if (preset.kind == brush::ToolKind::Droplets) return {6, QObject::tr("Drops and sprays")};
    if (preset.kind == brush::ToolKind::Air) return {7, QObject::tr("Air")};
    if (preset.paint.coat > 0.0) return {3, QObject::tr("Charcoal and pastels")};
    switch (preset.tip.shape) {
        case brush::TipShape::Knife:
        case brush::TipShape::Comb:
            return {1, QObject::tr("Knives and combs")};
        case brush::TipShape::Nib:
            return {2, QObject::tr("Pens")};
        case brush::TipShape::Pad:
            if (preset.dips) return {4, QObject::tr("Sponges and rollers")};
            return {5, QObject::tr("Rags and fingers")};
        default:
            return {0, QObject::tr("Brushes")};
    }
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
                           QObject::tr("Cannot be read"), 0.0, true,
                           appearance::shown_message(sentence)});
    return entries;
}

}  // namespace

std::filesystem::path BrushJar::folder() {
    return core::user_data_path("brushes");
}

BrushJar::BrushJar(Studio& studio, panels::BrushPanel* brushes, panels::CurvesPanel* curves)
    : studio_(studio), brushes_(brushes), curves_(curves) {
    make_thumbnails();
    connect(brushes_, &panels::BrushPanel::brush_taken, this, &BrushJar::take_brush);
    connect(brushes_, &panels::BrushPanel::faulty_clicked, this, [this](const QString& fault) {
        studio_.report(fault);
        studio_.show_hand();
    });
    studio_.commands().on(Command::SaveBrush, [this](bool) { save_brush(); });
    studio_.commands().on(Command::RenameBrush, [this](bool) { rename_brush(); });
    connect(brushes_, &panels::BrushPanel::rename_wanted,
            studio_.commands().action(Command::RenameBrush), &QAction::trigger);
    studio_.commands().on(Command::DeleteBrush, [this](bool) { delete_brush(); });
    connect(brushes_, &panels::BrushPanel::removal_wanted,
            studio_.commands().action(Command::DeleteBrush), &QAction::trigger);
    connect(curves_, &panels::CurvesPanel::edited, this, [this](const brush::Preset& preset) {
        studio_.easel().change_brush(preset);
        studio_.show_hand();
    });
    files_changed_.setSingleShot(true);
    files_changed_.setInterval(kSettling_ms);
    connect(&files_changed_, &QTimer::timeout, this, &BrushJar::reread);
    const auto soon = [this] { files_changed_.start(); };
    connect(&files_, &QFileSystemWatcher::fileChanged, this, soon);
    connect(&files_, &QFileSystemWatcher::directoryChanged, this, soon);
    connect(&studio_, &Studio::hand_changed, this, &BrushJar::show);
    studio_.window().installEventFilter(this);
}

/// For a painter who has just made the folder that is watched from now on.
bool BrushJar::eventFilter(QObject* window, QEvent* event) {
    if (event->type() == QEvent::ActivationChange && studio_.window().isActiveWindow() &&
        files_.directories().isEmpty() && !folder().empty() && core::is_there(folder())) {
        reread();
    }
    return QObject::eventFilter(window, event);
}

/// Painted as they come into view.
void BrushJar::make_thumbnails() {
    const double pixels = studio_.window().devicePixelRatioF();
    const QSize size = panels::kThumbnailSize * pixels;
    thumbnails_ = std::make_unique<session::ThumbnailPainter>(
        size.width(), size.height(),
        [panel = brushes_, pixels](const std::string& name, const pigment::Image8& thumbnail) {
            QImage image = appearance::view_of(thumbnail).copy();
            image.setDevicePixelRatio(pixels);
            QMetaObject::invokeMethod(panel, [panel, name = QString::fromStdString(name), image] {
                panel->show_thumbnail(name, image);
            });
        },
        studio_.teller());
    connect(brushes_, &panels::BrushPanel::thumbnail_wanted, this, [this](const QString& name) {
        const auto* entry = brush::find_entry(library_, name.toStdString());
        if (entry != nullptr) thumbnails_->want(entry->preset);
    });
}

void BrushJar::show(const tools::Hand& hand) {
    brushes_->show_brush(QString::fromStdString(hand.brush), hand.brush_width_mm);
    brushes_->show_stabiliser(hand.stabiliser);
    curves_->show_preset(tools::preset_in_hand(hand), kept_brush());
    for (const auto command : {Command::RenameBrush, Command::DeleteBrush})
        studio_.commands().action(command)->setEnabled(own_brush_in_hand());
}

// ---- the list

void BrushJar::read() {
    library_ = brush::load_presets(folder());
    QStringList watched;
    if (core::is_there(folder())) watched += QString::fromStdString(folder().string());
    for (const auto& entry : library_.entries)
        if (entry.own) watched += QString::fromStdString(entry.file.string());
    for (const auto& fault : library_.faults)
        watched += QString::fromStdString(fault.file.string());
    if (!watched.isEmpty()) files_.addPaths(watched);
    list();
    for (const auto& fault : library_.faults)
        studio_.report(appearance::shown_message(fault.sentence));
}

void BrushJar::list() {
    thumbnails_->forget();
    brushes_->show_brushes(entries_of(library_));
    brushes_->show_brush(QString::fromStdString(studio_.easel().hand().brush),
                         studio_.easel().hand().brush_width_mm);
}

/// A tool in hand that was not changed in the meantime follows its file.
void BrushJar::reread() {
    const brush::Preset before = kept_brush();
    read();
    const brush::Preset now = kept_brush();
    if (tools::preset_in_hand(studio_.easel().hand()) == before && !(now == before)) {
        studio_.easel().change_brush(now);
        studio_.report(tr("%1 was read again; the next stroke is painted with it.")
                           .arg(appearance::shown_name(now.name)));
    }
    studio_.show_hand();
}

void BrushJar::take_brush(const QString& name, double width_mm) {
    const auto* entry = brush::find_entry(library_, name.toStdString());
    if (entry != nullptr) studio_.easel().take_brush(entry->preset, width_mm);
    studio_.show_hand();
}

void BrushJar::take(const QString& name) {
    const auto* entry = brush::find_entry(library_, name.toStdString());
    if (entry != nullptr) take_brush(name, entry->preset.tip.width_mm);
}

brush::Preset BrushJar::kept_brush() const {
    const auto* entry = brush::find_entry(library_, studio_.easel().hand().brush);
    return entry != nullptr ? entry->preset : tools::preset_in_hand(studio_.easel().hand());
}

bool BrushJar::own_brush_in_hand() const {
    const auto* entry = brush::find_entry(library_, studio_.easel().hand().brush);
    return entry != nullptr && entry->own;
}

// ---- the painter's own

std::optional<QString> BrushJar::asked_name(const QString& title, const QString& name) {
    return dialogs::ask_name({.title = title, .label = tr("Name of the tool:"), .proposal = name},
                             &studio_.window());
}

bool BrushJar::confirmed(const QString& question, const QString& action) {
    QMessageBox box(QMessageBox::Question, tr("Pastoso"), question, QMessageBox::Cancel,
                    &studio_.window());
    box.addButton(action, QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    return box.exec() != QMessageBox::Cancel;
}

void BrushJar::save_brush() {
    const tools::Hand& hand = studio_.easel().hand();
    const QString old_name = QString::fromStdString(hand.brush);
    const auto name =
        asked_name(tr("Save as my own"),
                   own_brush_in_hand() ? old_name : tr("My %1").arg(appearance::shown_name(old_name)));
    if (!name) return;
    brush::Preset preset = tools::sized_preset_in_hand(hand);
    preset.name = name->toStdString();
    const auto* same = brush::find_entry(library_, preset.name);
    const bool in_the_way =
        (same != nullptr && same->own) || core::is_there(brush::preset_file(preset.name, folder()));
    if (in_the_way &&
        !confirmed(tr("There is already a tool of your own named \"%1\".").arg(*name), tr("Overwrite")))
        return;
    studio_.attempt([&] {
        const std::filesystem::path file = brush::save_preset(preset, folder());
        if (same != nullptr && same->own && same->file != file) brush::delete_preset(*same);
        studio_.easel().change_brush(preset);
        read();
        studio_.report(tr("Kept \"%1\" among your own.").arg(*name));
    });
    studio_.show_hand();
}

void BrushJar::rename_brush() {
    const auto* entry = brush::find_entry(library_, studio_.easel().hand().brush);
    if (entry == nullptr || !entry->own) return;
    const auto typed = asked_name(tr("Rename"), QString::fromStdString(entry->preset.name));
    if (!typed) return;
    studio_.attempt([&] {
        const std::string before = entry->preset.name, name = typed->toStdString();
        brush::rename_preset(library_, *entry, name);
        Q_EMIT renamed(before, name);
        brush::Preset preset = tools::preset_in_hand(studio_.easel().hand());
        preset.name = name;
        studio_.easel().change_brush(preset);
        read();
    });
    studio_.show_hand();
}

void BrushJar::delete_brush() {
    const auto* entry = brush::find_entry(library_, studio_.easel().hand().brush);
    if (entry == nullptr || !entry->own) return;
    const QString name = QString::fromStdString(entry->preset.name);
    if (!confirmed(tr("Throw your tool \"%1\" away? Its file is deleted.").arg(name), tr("Delete")))
        return;
    studio_.attempt([&] {
        brush::delete_preset(*entry);
        read();
        studio_.report(tr("\"%1\" is thrown away; what you have in hand stays.").arg(name));
    });
    studio_.show_hand();
}

}  // namespace pastoso::main
