#include "main/files/project_files.hpp"

#include "commands/recent_paintings.hpp"
#include "core/looking.hpp"
#include "dialogs/new_canvas_dialog.hpp"
#include "main/files/journal_starts.hpp"
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

namespace pastoso::main {
namespace {

using commands::Command;

project::LoadedProject imported(const std::filesystem::path& path, core::ThreadPool& pool) {
    return project::is_open_raster_path(path) ? project::import_open_raster(path, {}, pool)
                                              : project::import_picture(path, {}, pool);
}

}  // namespace

ProjectFiles::ProjectFiles(Studio& studio, bool keeps_journal)
    : studio_(studio), keeps_journal_(keeps_journal) {
    studio_.commands().on(Command::NewCanvas, [this](bool) { ask_new_canvas(); });
    studio_.commands().on(Command::OpenPainting, [this](bool) { ask_open_painting(); });
    studio_.commands().on(Command::SavePainting, [this](bool) { save(); });
    studio_.commands().on(Command::SavePaintingAs, [this](bool) { ask_save_painting(); });
    recent_ = new QMenu(tr("Open re&cent"), &studio_.window());
    connect(recent_, &QMenu::aboutToShow, this, &ProjectFiles::fill_recent);
    QAction* next = studio_.commands().action(Command::SavePainting);
    studio_.window().menuBar()->actions().front()->menu()->insertMenu(next, recent_);
    connect(&saver_, &commands::ProjectSaver::finished, this, &ProjectFiles::end_saving);
    connect(&studio_, &Studio::published, this, [this](const auto&, const session::Status& status) {
        if (watched_) saved_changes_ = status.changes;
        watched_ = watched_ && status.replaying;
        show_modified();
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
    const session::PaintSession::BeginJournal begin_journal = journal_for(beginning);
    std::unique_ptr<journal::JournalWriter> journal = begun_journal(begin_journal);
    studio_.put_up(std::move(pool), std::move(painting), std::move(past), std::move(journal),
                   begin_journal);
    saving_.reset();
    path_.clear();
    stamp_.reset();
    saved_changes_ = 0;
    watched_ = false;
    show_title();
}

void ProjectFiles::ask_new_canvas() {
    dialogs::NewCanvasDialog dialog(studio_.session().canvas(), studio_.live_px_per_mm(),
                                    &studio_.window());
    if (dialog.exec() == QDialog::Accepted) ask_to_put_up(dialog.settings());
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
    tell_arithmetic(recording);
}

void ProjectFiles::tell_arithmetic(const document::Recording& recording) {
    const std::string older = document::arithmetic_note(recording.arithmetic);
    if (!older.empty()) studio_.report_notes({}, {"Its strokes " + older});
}

void ProjectFiles::show_modified() {
    studio_.window().setWindowModified(studio_.session().status().changes != saved_changes_);
}

/// What is on the easel now is in no file.
void ProjectFiles::show_unsaved() {
    saved_changes_ = -1;
    show_title();
    show_modified();
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
    const QString painting = tr("%1[*] %2 × %3 mm").arg(name).arg(canvas.width_mm).arg(canvas.height_mm);
    studio_.window().setWindowTitle(place_.isEmpty() ? painting : tr("%1 - %2").arg(place_, painting));
}

void ProjectFiles::show_place(const QString& name) {
    place_ = name;
    show_title();
}

void ProjectFiles::open_painting(const QString& path) {
    if (!project::is_project_path(path.toStdString())) {
        open_picture(path);
        return;
    }
    const WaitCursor waiting;
    auto pool = std::make_unique<core::ThreadPool>();
    const std::filesystem::path file = core::absolute_path(path.toStdString());
    const auto stamp = commands::stamp_of(file);
    project::LoadedProject project = project::load_project(path.toStdString(), *pool);
    auto painting = std::make_unique<document::Painting>(project.painting, *pool);
    start(std::move(pool), std::move(painting), project.strokes,
          {.painting = file, .write_start = copied_start(file)});
    path_ = path;
    stamp_ = stamp;
    show_title();
    take_up_hand(project.strokes);
    studio_.show_published();
    commands::remember_painting(path.toStdString());
    studio_.report_notes(QFileInfo(path).fileName(), project.notes);
}

bool ProjectFiles::opens(const QString& path) {
    const QString ending = QStringLiteral("*.") + QFileInfo(path).suffix().toLower();
    const std::filesystem::path file = path.toStdString();
    return project::is_project_path(file) || project::is_open_raster_path(file) ||
           picture_endings().split(QLatin1Char(' ')).contains(ending);
}

void ProjectFiles::open_picture(const QString& path) {
    const WaitCursor waiting;
    core::ThreadPool pool;
    const auto project =
        std::make_shared<const project::LoadedProject>(imported(path.toStdString(), pool));
    put_up_unsaved(project);
    studio_.report_notes(QFileInfo(path).fileName(), project->notes);
}

void ProjectFiles::put_up_unsaved(std::shared_ptr<const project::Project> project) {
    auto pool = std::make_unique<core::ThreadPool>();
    auto painting = std::make_unique<document::Painting>(project->painting, *pool);
    start(std::move(pool), std::move(painting), project->strokes,
          {.write_start = saved_start(project), .is_saved = false});
    show_unsaved();
    take_up_hand(project->strokes);
    studio_.show_published();
}

/// The brush that was in hand, as far as this window knows it; otherwise one is taken afresh.
void ProjectFiles::take_up_hand(const document::Recording& past) {
    const bool known = studio_.attempt(
        [&] { studio_.easel().adopt(tools::hand_after(studio_.easel().hand(), past.events)); });
    const bool has_brush = std::any_of(past.events.begin(), past.events.end(), [](const auto& event) {
        return std::holds_alternative<document::TakeBrush>(event.action);
    });
    if (!known || !has_brush) studio_.easel().set_up();
    studio_.show_hand();
}

void ProjectFiles::try_to_open(const QString& path) {
    studio_.attempt(tr("Open"), [&] { open_painting(path); });
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

}  // namespace pastoso::main
