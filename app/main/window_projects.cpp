// Paintings in files: opening, saving, and what would be lost.

#include "commands/recent_paintings.hpp"
#include "core/error.hpp"
#include "main/main_window.hpp"
#include "main/view_commands.hpp"
#include "main/wait_cursor.hpp"
#include "panels/status_readings.hpp"
#include "panels/tracing_panel.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

namespace pastoso::main {
namespace {

using commands::Command;

QString with_ending(const QString& path) {
    return path.endsWith(QStringLiteral(".pastoso")) ? path : path + QStringLiteral(".pastoso");
}

}  // namespace

void MainWindow::connect_project_commands() {
    commands_.on(Command::OpenPainting, [this](bool) { ask_open_painting(); });
    commands_.on(Command::SavePainting, [this](bool) {
        if (path_.isEmpty())
            ask_save_painting();
        else
            save_painting(path_);
    });
    commands_.on(Command::SavePaintingAs, [this](bool) { ask_save_painting(); });
    recent_ = new QMenu(tr("Open re&cent"), this);
    connect(recent_, &QMenu::aboutToShow, this, &MainWindow::fill_recent);
    menuBar()->actions().front()->menu()->insertMenu(commands_.action(Command::SavePainting), recent_);
    connect(&project_saver_, &commands::ProjectSaver::finished, this,
            [this](const QString& path, const QString& error) {
                if (error.isEmpty()) {
                    if (journal_events_saved_)
                        session_->note_saved(path.toStdString(), *journal_events_saved_);
                    commands::remember_painting(path.toStdString());
                    report(tr("Saved %1.").arg(path));
                    return;
                }
                saved_changes_ = -1;
                setWindowModified(true);
                QMessageBox::warning(this, tr("Save"), error);
            });
}

void MainWindow::fill_recent() {
    recent_->clear();
    for (const std::filesystem::path& painting : commands::recent_paintings()) {
        const QString path = QString::fromStdString(painting.string());
        recent_->addAction(path, this, [this, path] {
            if (may_discard()) try_to_open(path);
        });
    }
    if (recent_->isEmpty()) recent_->addAction(tr("None yet"))->setEnabled(false);
}

/// The star of a painting that is not saved follows the name.
void MainWindow::show_title() {
    const document::CanvasSettings& canvas = session_->canvas();
    const QString name = path_.isEmpty() ? tr("Canvas") : QFileInfo(path_).fileName();
    setWindowTitle(tr("%1[*] %2 × %3 mm").arg(name).arg(canvas.width_mm).arg(canvas.height_mm));
}

void MainWindow::open_painting(const QString& path) {
    if (!project::is_project_path(path.toStdString())) {
        open_picture(path);
        return;
    }
    const WaitCursor waiting;
    auto pool = std::make_unique<core::ThreadPool>();
    project::LoadedProject project = project::load_project(path.toStdString(), *pool);
    auto painting = std::make_unique<document::Painting>(project.painting, *pool);
    const std::filesystem::path file = std::filesystem::absolute(path.toStdString());
    start_session(std::move(pool), std::move(painting), project.strokes,
                  {.painting = file, .write_start = [&file](const std::filesystem::path& start) {
                       std::filesystem::copy_file(file, start);
                   }});
    path_ = path;
    show_title();
    take_up_hand(project.strokes);
    readings_->show_canvas(session_->canvas());
    show_published();
    commands::remember_painting(path.toStdString());
    for (const std::string& note : project.notes)
        report(QString::fromStdString(note));
}

/// The brush that was in hand, as far as this window knows it; otherwise one is taken afresh.
void MainWindow::take_up_hand(const document::Recording& past) {
    try {
        easel_->adopt(tools::hand_after(easel_->hand(), past.events));
        const bool has_brush = std::any_of(
            past.events.begin(), past.events.end(),
            [](const auto& event) { return std::holds_alternative<document::TakeBrush>(event.action); });
        if (!has_brush) easel_->set_up();
    } catch (const core::InputError& error) {
        report(QString::fromUtf8(error.what()));
        easel_->set_up();
    }
    show_hand();
}

void MainWindow::save_painting(const QString& path) {
    tracing_->finish();
    session::Capture capture = session_->capture();
    path_ = path;
    saved_changes_ = capture.changes;
    journal_events_saved_ = capture.journal_events;
    show_title();
    setWindowModified(false);
    report(tr("Saving %1...").arg(path));
    project_saver_.save({std::move(capture.painting), std::move(capture.recording)}, path);
}

void MainWindow::try_to_open(const QString& path) {
    try {
        open_painting(path);
    } catch (const core::InputError& error) {
        QMessageBox::warning(this, tr("Open"), QString::fromUtf8(error.what()));
    }
}

void MainWindow::ask_open_painting() {
    if (!may_discard()) return;
    const QString path = QFileDialog::getOpenFileName(this, tr("Open"), QFileInfo(path_).path(),
                                                      tr("Paintings and pictures (*.pastoso *.ora %1);;"
                                                         "All files (*)")
                                                          .arg(picture_endings()));
    if (!path.isEmpty()) try_to_open(path);
}

bool MainWindow::ask_save_painting() {
    const QString proposal = path_.isEmpty() ? tr("painting.pastoso") : path_;
    QFileDialog dialog(this, tr("Save"), proposal, tr("Paintings (*.pastoso)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("pastoso"));
    dialog.selectFile(proposal);
    if (dialog.exec() != QDialog::Accepted) return false;
    save_painting(with_ending(dialog.selectedFiles().front()));
    return true;
}

/// Whether nothing would be lost with this painting, or the painter agrees to lose it.
bool MainWindow::may_discard() {
    tracing_->finish();
    session_->wait_until_applied();
    if (!project_saver_.wait().isEmpty()) saved_changes_ = -1;
    if (session_->status().changes == saved_changes_) return true;
    QMessageBox question(QMessageBox::Question, tr("Pastoso"),
                         tr("The painting on the easel has changes that are not saved."),
                         QMessageBox::Save | QMessageBox::Cancel, this);
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
    return project_saver_.wait().isEmpty();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    event->setAccepted(may_stop_export() && may_discard());
    if (!event->isAccepted()) return;
    exporter_.stop();
    view_commands_->leave_canvas_only();
    remember();
    session_->discard_journal();
}

}  // namespace pastoso::main
