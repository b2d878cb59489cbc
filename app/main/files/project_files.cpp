#include "main/files/project_files.hpp"

#include "commands/recent_paintings.hpp"
#include "core/error.hpp"
#include "dialogs/new_canvas_dialog.hpp"
#include "main/files/picture_files.hpp"
#include "main/wait_cursor.hpp"
#include "project/import_open_raster.hpp"
#include "project/project.hpp"
#include "recordings/canvas_support.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

namespace pastoso::main {
namespace {

using commands::Command;

QString with_ending(const QString& path) {
    return path.endsWith(QStringLiteral(".pastoso")) ? path : path + QStringLiteral(".pastoso");
}

project::LoadedProject imported(const std::filesystem::path& path, core::ThreadPool& pool) {
    return project::is_open_raster_path(path) ? project::import_open_raster(path, {}, pool)
                                              : project::import_picture(path, {}, pool);
}

}  // namespace

ProjectFiles::ProjectFiles(Studio& studio, bool keeps_journal)
    : studio_(studio), keeps_journal_(keeps_journal) {
    studio_.commands().on(Command::NewCanvas, [this](bool) { ask_new_canvas(); });
    studio_.commands().on(Command::OpenPainting, [this](bool) { ask_open_painting(); });
    studio_.commands().on(Command::SavePainting, [this](bool) {
        if (path_.isEmpty())
            ask_save_painting();
        else
            save_painting(path_);
    });
    studio_.commands().on(Command::SavePaintingAs, [this](bool) { ask_save_painting(); });
    recent_ = new QMenu(tr("Open re&cent"), &studio_.window());
    connect(recent_, &QMenu::aboutToShow, this, &ProjectFiles::fill_recent);
    QAction* save = studio_.commands().action(Command::SavePainting);
    studio_.window().menuBar()->actions().front()->menu()->insertMenu(save, recent_);
    connect(&saver_, &commands::ProjectSaver::finished, this,
            [this](const QString& path, const QString& error) {
                if (error.isEmpty()) {
                    if (journal_events_saved_)
                        studio_.session().note_saved(path.toStdString(), *journal_events_saved_);
                    commands::remember_painting(path.toStdString());
                    studio_.report(tr("Saved %1.").arg(path));
                    return;
                }
                saved_changes_ = -1;
                studio_.window().setWindowModified(true);
                QMessageBox::warning(&studio_.window(), tr("Save"), error);
            });
    connect(&studio_, &Studio::published, this, [this](const auto&, const session::Status& status) {
        if (watched_) saved_changes_ = status.changes;
        watched_ = watched_ && status.replaying;
        studio_.window().setWindowModified(status.changes != saved_changes_);
        if (save_waits_ && !status.stroke_in_progress) save_by_itself();
    });
}

void ProjectFiles::start(const document::CanvasSettings& canvas) {
    auto pool = std::make_unique<core::ThreadPool>();
    auto painting = recordings::make_painting(canvas, *pool);
    start(std::move(pool), std::move(painting), {}, {.canvas = canvas});
}

void ProjectFiles::start(std::unique_ptr<core::ThreadPool> pool,
                         std::unique_ptr<document::Painting> painting, document::Recording past,
                         journal::Beginning beginning) {
    beginning.canvas = painting->settings();
    beginning.tick = painting->tick();
    auto journal = new_journal(beginning);
    studio_.put_up(std::move(pool), std::move(painting), std::move(past), std::move(journal));
    journal_events_saved_.reset();
    path_.clear();
    saved_changes_ = 0;
    watched_ = false;
    show_title();
}

void ProjectFiles::ask_new_canvas() {
    dialogs::NewCanvasDialog dialog(studio_.session().canvas(), &studio_.window());
    if (dialog.exec() != QDialog::Accepted || !may_discard()) return;
    try {
        new_canvas(dialog.settings());
    } catch (const core::InputError& error) {
        QMessageBox::warning(&studio_.window(), tr("New canvas"), QString::fromUtf8(error.what()));
    }
}

/// A symmetry stands in the middle of the new canvas as it stood in that of the old one.
void ProjectFiles::new_canvas(const document::CanvasSettings& canvas) {
    {
        const WaitCursor waiting;
        start(canvas);
    }
    tools::Easel& easel = studio_.easel();
    easel.set_up();
    brush::Symmetry symmetry = easel.hand().symmetry;
    if (symmetry.mirror || symmetry.count > 1) {
        symmetry.centre_x_mm = 0.5 * canvas.width_mm;
        symmetry.centre_y_mm = 0.5 * canvas.height_mm;
        easel.set_symmetry(symmetry);
        studio_.show_hand();
    }
    studio_.show_published();
}

void ProjectFiles::replay(const document::Recording& recording) {
    if (!(recording.canvas == studio_.session().canvas())) new_canvas(recording.canvas);
    studio_.session().play(recording.events);
    studio_.easel().lend_brush(true);
    studio_.easel().adopt(tools::hand_after(studio_.easel().hand(), recording.events));
    studio_.show_hand();
}

/// What is on the easel now is in no file.
void ProjectFiles::show_unsaved() {
    saved_changes_ = -1;
    show_title();
    studio_.window().setWindowModified(true);
}

void ProjectFiles::fill_recent() {
    recent_->clear();
    for (const std::filesystem::path& painting : commands::recent_paintings()) {
        const QString path = QString::fromStdString(painting.string());
        recent_->addAction(path, this, [this, path] { ask_to_open(path); });
    }
    if (recent_->isEmpty()) recent_->addAction(tr("None yet"))->setEnabled(false);
}

/// The star of a painting that is not saved follows the name.
void ProjectFiles::show_title() {
    const document::CanvasSettings& canvas = studio_.session().canvas();
    const QString name = path_.isEmpty() ? tr("Canvas") : QFileInfo(path_).fileName();
    studio_.window().setWindowTitle(
        tr("%1[*] %2 × %3 mm").arg(name).arg(canvas.width_mm).arg(canvas.height_mm));
}

void ProjectFiles::open_painting(const QString& path) {
    if (!project::is_project_path(path.toStdString())) {
        open_picture(path);
        return;
    }
    const WaitCursor waiting;
    auto pool = std::make_unique<core::ThreadPool>();
    project::LoadedProject project = project::load_project(path.toStdString(), *pool);
    auto painting = std::make_unique<document::Painting>(project.painting, *pool);
    const std::filesystem::path file = std::filesystem::absolute(path.toStdString());
    start(std::move(pool), std::move(painting), project.strokes,
          {.painting = file, .write_start = [&file](const std::filesystem::path& start) {
               std::filesystem::copy_file(file, start);
           }});
    path_ = path;
    show_title();
    take_up_hand(project.strokes);
    studio_.show_published();
    commands::remember_painting(path.toStdString());
    for (const std::string& note : project.notes)
        studio_.report(QString::fromStdString(note));
}

void ProjectFiles::open_picture(const QString& path) {
    const WaitCursor waiting;
    auto pool = std::make_unique<core::ThreadPool>();
    const project::LoadedProject project = imported(path.toStdString(), *pool);
    auto painting = std::make_unique<document::Painting>(project.painting, *pool);
    core::ThreadPool& threads = *pool;
    start(
        std::move(pool), std::move(painting), project.strokes,
        {.write_start =
             [&](const std::filesystem::path& start) { project::save_project(start, project, threads); },
         .is_saved = false});
    show_unsaved();
    take_up_hand(project.strokes);
    studio_.show_published();
    for (const std::string& note : project.notes)
        studio_.report(QString::fromStdString(note));
}

/// The brush that was in hand, as far as this window knows it; otherwise one is taken afresh.
void ProjectFiles::take_up_hand(const document::Recording& past) {
    try {
        studio_.easel().adopt(tools::hand_after(studio_.easel().hand(), past.events));
        const bool has_brush = std::any_of(
            past.events.begin(), past.events.end(),
            [](const auto& event) { return std::holds_alternative<document::TakeBrush>(event.action); });
        if (!has_brush) studio_.easel().set_up();
    } catch (const core::InputError& error) {
        studio_.report(QString::fromUtf8(error.what()));
        studio_.easel().set_up();
    }
    studio_.show_hand();
}

void ProjectFiles::save_painting(const QString& path) {
    Q_EMIT about_to_keep();
    session::Capture capture = studio_.session().capture();
    path_ = path;
    saved_changes_ = capture.changes;
    journal_events_saved_ = capture.journal_events;
    show_title();
    studio_.window().setWindowModified(false);
    studio_.report(tr("Saving %1...").arg(path));
    saver_.save(std::move(capture.painting), std::move(capture.record), path);
}

/// Saving ends a stroke in progress, so it waits for the hand.
void ProjectFiles::save_by_itself() {
    const session::Status status = studio_.session().status();
    const bool needed = !path_.isEmpty() && status.changes != saved_changes_;
    save_waits_ = needed && status.stroke_in_progress;
    if (needed && !save_waits_) save_painting(path_);
}

void ProjectFiles::try_to_open(const QString& path) {
    try {
        open_painting(path);
    } catch (const core::InputError& error) {
        QMessageBox::warning(&studio_.window(), tr("Open"), QString::fromUtf8(error.what()));
    }
}

void ProjectFiles::ask_open_painting() {
    if (!may_discard()) return;
    const QString path =
        QFileDialog::getOpenFileName(&studio_.window(), tr("Open"), QFileInfo(path_).path(),
                                     tr("Paintings and pictures (*.pastoso *.ora %1);;"
                                        "All files (*)")
                                         .arg(picture_endings()));
    if (!path.isEmpty()) try_to_open(path);
}

bool ProjectFiles::ask_save_painting() {
    const QString proposal = path_.isEmpty() ? tr("painting.pastoso") : path_;
    QFileDialog dialog(&studio_.window(), tr("Save"), proposal, tr("Paintings (*.pastoso)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("pastoso"));
    dialog.selectFile(proposal);
    if (dialog.exec() != QDialog::Accepted) return false;
    save_painting(with_ending(dialog.selectedFiles().front()));
    return true;
}

/// Whether nothing would be lost with this painting, or the painter agrees to lose it.
bool ProjectFiles::may_discard() {
    Q_EMIT about_to_keep();
    studio_.session().wait_until_applied();
    if (!saver_.wait().isEmpty()) saved_changes_ = -1;
    if (studio_.session().status().changes == saved_changes_) return true;
    QMessageBox question(QMessageBox::Question, tr("Pastoso"),
                         tr("The painting on the easel has changes that are not saved."),
                         QMessageBox::Save | QMessageBox::Cancel, &studio_.window());
    question.addButton(tr("Discard them"), QMessageBox::DestructiveRole);
    question.setDefaultButton(QMessageBox::Save);
    const int answer = question.exec();
    if (answer == QMessageBox::Cancel) return false;
    if (answer != QMessageBox::Save) return true;
    if (!path_.isEmpty())
        save_painting(path_);
    else if (!ask_save_painting())
        return false;
    const WaitCursor waiting;
    return saver_.wait().isEmpty();
}

}  // namespace pastoso::main
