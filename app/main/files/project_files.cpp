#include "main/files/project_files.hpp"

#include "appearance/shown_number.hpp"
#include "commands/recent_paintings.hpp"
#include "core/looking.hpp"
#include "dialogs/new_canvas_dialog.hpp"
#include "main/files/journal_starts.hpp"
#include "main/files/picture_files.hpp"
#include "project/import_open_raster.hpp"
#include "project/project.hpp"

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

project::LoadedProject imported(const std::filesystem::path& path, core::ThreadPool& pool,
                                const core::Progress& progress) {
    return project::is_open_raster_path(path) ? project::import_open_raster(path, {}, pool, progress)
                                              : project::import_picture(path, {}, pool, progress);
}

/// A project file's painting.
struct OpenedPainting {
    std::optional<commands::FileStamp> stamp;
    std::vector<core::Message> notes;
    SharedPainting painting;
};

OpenedPainting opened(const std::filesystem::path& file, const JournalTerms& terms,
                      const core::Progress& progress) {
    auto pool = std::make_unique<core::ThreadPool>();
    const auto stamp = commands::stamp_of(file);
    project::LoadedProject project = project::load_project(file, *pool, progress);
    MadePainting made = made_of(project.painting, std::move(project.strokes), std::move(pool));
    return {stamp, std::move(project.notes),
            std::make_shared<PreparedPainting>(
                std::move(made), journal::Beginning{.painting = file, .write_start = copied_start(file)},
                terms)};
}

/// What stands in no project.
SharedPainting unsaved(const std::shared_ptr<const project::Project>& project,
                       const JournalTerms& terms) {
    return std::make_shared<PreparedPainting>(
        made_of(project->painting, project->strokes, std::make_unique<core::ThreadPool>()),
        journal::Beginning{.write_start = saved_start(project), .is_saved = false}, terms);
}

}  // namespace

ProjectFiles::ProjectFiles(Studio& studio, Loading& loading, bool keeps_journal)
    : studio_(studio), loading_(loading), keeps_journal_(keeps_journal) {
    studio_.commands().on(Command::NewCanvas, [this](bool) { ask_new_canvas(); });
    studio_.commands().on(Command::OpenPainting, [this](bool) { ask_open_painting(); });
    studio_.commands().on(Command::SavePainting, [this](bool) { save(); });
    studio_.commands().on(Command::SavePaintingAs, [this](bool) { ask_save_painting(); });
    studio_.commands().on(Command::SaveVersion, [this](bool) { save_version(); });
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

void ProjectFiles::start(MadePainting canvas) {
    PreparedPainting painting(std::move(canvas), {}, journal_terms());
    put_up(painting);
}

/// What was painted while the other one was made nobody has agreed to lose.
void ProjectFiles::make(const QString& words, Loading::Make work) {
    studio_.session().wait_until_applied();
    given_up_changes_ = studio_.session().status().changes;
    loading_.replace(words, [this, work = std::move(work)](const core::Progress& progress) {
        return Loading::TakeOver([this, take_over = work(progress)] {
            if (may_replace()) take_over();
        });
    });
}

bool ProjectFiles::may_replace() {
    studio_.session().wait_until_applied();
    return studio_.session().status().changes == given_up_changes_ || may_discard();
}

void ProjectFiles::put_up(PreparedPainting& painting) {
    studio_.messages().solve(panels::Matter::Journal);
    journal_ = painting.journal_number;
    if (!painting.journal_fault.empty()) show_trouble({.reason = painting.journal_fault});
    MadePainting& made = painting.made;
    studio_.put_up(std::move(made.pool), std::move(made.painting), std::move(made.past),
                   std::move(painting.journal), std::move(painting.begin_journal));
    saving_.reset();
    path_.clear();
    stamp_.reset();
    saved_changes_ = given_up_changes_ = 0;
    watched_ = false;
    show_title();
}

void ProjectFiles::ask_new_canvas() {
    dialogs::NewCanvasDialog dialog(studio_.session().canvas(), studio_.live_px_per_mm(),
                                    &studio_.window());
    if (dialog.exec() != QDialog::Accepted || !may_discard()) return;
    const std::optional<double> ground_mm = dialog.ground_mm();
    new_canvas(dialog.settings(), [this, ground_mm] {
        if (ground_mm) Q_EMIT ground_wanted(*ground_mm);
    });
}

void ProjectFiles::new_canvas(const document::CanvasSettings& canvas, const Then& then) {
    make(tr("Making the canvas"), [this, canvas, then, terms = journal_terms()](const auto&) {
        const auto painting =
            std::make_shared<PreparedPainting>(bare_painting(canvas), journal::Beginning{}, terms);
        return [this, painting, then] {
            put_up_new(*painting);
            if (then) then();
        };
    });
}

/// A symmetry stands in the middle of the new canvas as it stood in that of the old one.
void ProjectFiles::put_up_new(PreparedPainting& painting) {
    const document::CanvasSettings canvas = painting.made.painting->settings();
    put_up(painting);
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

void ProjectFiles::tell_arithmetic(const document::Recording& recording) {
    const core::Message older = document::arithmetic_note(recording.arithmetic);
    if (!older.empty()) studio_.report_notes({}, {core::message("its strokes %1", older)});
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
    const QString painting = tr("%1[*] %2 × %3 mm")
                                 .arg(name)
                                 .arg(appearance::shown_number(canvas.width_mm))
                                 .arg(appearance::shown_number(canvas.height_mm));
    studio_.window().setWindowTitle(place_.isEmpty() ? painting : tr("%1 - %2").arg(place_, painting));
}

void ProjectFiles::show_place(const QString& name) {
    place_ = name;
    show_title();
}

void ProjectFiles::open_painting(const QString& path) {
    if (!project::is_project_path(path.toStdString())) return open_picture(path);
    const QString name = QFileInfo(path).fileName();
    const std::filesystem::path file = core::absolute_path(path.toStdString());
    make(tr("Opening %1").arg(name), [=, this, terms = journal_terms()](const core::Progress& progress) {
        return [=, this, from = opened(file, terms, progress)] {
            const document::Recording past = from.painting->made.past;
            put_up(*from.painting);
            path_ = path;
            stamp_ = from.stamp;
            show_title();
            take_up_hand(past);
            studio_.show_published();
            commands::remember_painting(file);
            studio_.report_notes(name, from.notes);
        };
    });
}

bool ProjectFiles::opens(const QString& path) {
    const QString ending = QStringLiteral("*.") + QFileInfo(path).suffix().toLower();
    const std::filesystem::path file = path.toStdString();
    return project::is_project_path(file) || project::is_open_raster_path(file) ||
           picture_endings().split(QLatin1Char(' ')).contains(ending);
}

void ProjectFiles::open_picture(const QString& path) {
    const QString name = QFileInfo(path).fileName();
    make(tr("Opening %1").arg(name), [=, this, terms = journal_terms()](const core::Progress& progress) {
        core::ThreadPool pool;
        const auto project =
            std::make_shared<const project::LoadedProject>(imported(path.toStdString(), pool, progress));
        return [=, this, painting = unsaved(project, terms)] {
            put_up_new_to_save(*painting);
            studio_.report_notes(name, project->notes);
        };
    });
}

void ProjectFiles::put_up_unsaved(std::shared_ptr<const project::Project> project, const Then& then) {
    make(tr("Putting it on the easel"),
         [this, project = std::move(project), then, terms = journal_terms()](const auto&) {
             return [this, then, painting = unsaved(project, terms)] {
                 put_up_new_to_save(*painting);
                 if (then) then();
             };
         });
}

void ProjectFiles::put_up_new_to_save(PreparedPainting& painting) {
    const document::Recording past = painting.made.past;
    put_up(painting);
    show_unsaved();
    take_up_hand(past);
    studio_.show_published();
}

/// The brush that was in hand, as far as this window knows it; otherwise one is taken afresh.
void ProjectFiles::take_up_hand(const document::Recording& past) {
    tools::Hand hand = studio_.easel().hand();
    hand.brush_aside.reset();
    const bool known =
        studio_.attempt([&] { studio_.easel().adopt(tools::hand_after(std::move(hand), past.events)); });
    const bool has_brush = std::any_of(past.events.begin(), past.events.end(), [](const auto& event) {
        return std::holds_alternative<document::TakeBrush>(event.action);
    });
    if (!known || !has_brush) studio_.easel().set_up();
    studio_.show_hand();
}

void ProjectFiles::ask_open_painting() {
    if (!may_discard()) return;
    const QString path =
        QFileDialog::getOpenFileName(&studio_.window(), tr("Open"), QFileInfo(path_).path(),
                                     tr("Paintings and pictures (*.pastoso *.ora %1);;"
                                        "All files (*)")
                                         .arg(picture_endings()));
    if (!path.isEmpty()) open_painting(path);
}

}  // namespace pastoso::main
