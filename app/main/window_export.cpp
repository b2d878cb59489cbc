// What MainWindow makes of the painting for other programs, while the painter goes on painting.

#include "core/error.hpp"
#include "dialogs/export_dialog.hpp"
#include "io/recording_json.hpp"
#include "journal/undo_reach.hpp"
#include "main/main_window.hpp"
#include "panels/work_progress.hpp"
#include "tools/export_names.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <QStatusBar>

namespace pastoso::main {
namespace {

using commands::Command;
using tools::ExportForm;

QString text_of(const std::filesystem::path& path) {
    return QString::fromStdString(path.string());
}

QString name_of(const std::filesystem::path& path) {
    return text_of(path.filename());
}

QString length_mm(double mm) {
    return QString::number(mm, 'f', 3);
}

QString words_of(const io::ExportReport& report, const QString& name) {
    if (report.triangles > 0)
        return MainWindow::tr("Exported %1: %2 triangles, %3 × %4 mm.")
            .arg(name)
            .arg(report.triangles)
            .arg(report.width_mm)
            .arg(report.height_mm);
    if (report.files.size() > 1)
        return MainWindow::tr("Exported %1 and %2 more; heights from %3 mm (black) to %4 mm (white).")
            .arg(name_of(report.files.front()))
            .arg(report.files.size() - 1)
            .arg(length_mm(report.heights.black_mm), length_mm(report.heights.white_mm));
    return MainWindow::tr("Exported %1: %2 × %3 pixels.")
        .arg(name)
        .arg(report.width_px)
        .arg(report.height_px);
}

QString words_of(const io::TimelapseReport& report, const QString& name) {
    return MainWindow::tr("Exported %1: %2 frames of %3 × %4 pixels.")
        .arg(name)
        .arg(report.frames)
        .arg(report.width_px)
        .arg(report.height_px);
}

QString words_of(const commands::ExportOutcome& outcome) {
    const QString name = name_of(outcome.path);
    if (outcome.status() == io::ExportStatus::Written)
        return std::visit([&](const auto& report) { return words_of(report, name); }, outcome.report);
    const auto* film = std::get_if<io::TimelapseReport>(&outcome.report);
    if (film != nullptr && film->written > 0 && std::filesystem::is_directory(outcome.path))
        return MainWindow::tr("Stopped; %1 holds the pictures that are complete.").arg(name);
    return MainWindow::tr("Stopped; %1 was not written.").arg(name);
}

bool is_folder(const std::filesystem::path& path) {
    std::error_code unseen;
    return !path.empty() && std::filesystem::is_directory(path, unseen);
}

/// Where pictures usually go; not everybody has such a folder.
std::filesystem::path first_folder() {
    const std::filesystem::path pictures =
        QStandardPaths::writableLocation(QStandardPaths::PicturesLocation).toStdString();
    return is_folder(pictures) ? pictures : std::filesystem::path(QDir::homePath().toStdString());
}

}  // namespace

void MainWindow::connect_export() {
    commands_.on(Command::Export, [this](bool) { ask_export(); });
    commands_.on(Command::ExportAgain, [this](bool) { export_again(); });
    commands_.on(Command::StopExport, [this](bool) { exporter_.stop(); });
    commands_.on(Command::SaveRecording, [this](bool) { ask_save_recording(); });
    commands_.action(Command::StopExport)->setIconText(tr("Stop"));
    export_progress_ = new panels::WorkProgress(commands_.action(Command::StopExport));
    statusBar()->insertPermanentWidget(0, export_progress_);
    connect(&exporter_, &commands::Exporter::progressed, export_progress_,
            &panels::WorkProgress::show_done);
    connect(&exporter_, &commands::Exporter::finished, this, &MainWindow::end_export);
    show_export_commands();
}

void MainWindow::show_export_commands() {
    commands_.action(Command::ExportAgain)->setEnabled(exported_.has_value());
    commands_.action(Command::StopExport)->setEnabled(exporter_.busy());
}

/// Beside the painting, or where the last export went.
std::filesystem::path MainWindow::export_proposal() const {
    if (exported_) return exported_->path;
    const std::filesystem::path painting = path_.toStdString();
    if (!painting.empty()) return std::filesystem::absolute(painting).replace_extension();
    const std::filesystem::path last = export_settings_.folder;
    return (is_folder(last) ? last : first_folder()) / tr("painting").toStdString();
}

tools::ExportLight MainWindow::export_light() const {
    return {light_.toStdString(), canvas_->lighting()};
}

bool MainWindow::may_begin_export() {
    if (exporter_.busy())
        report(tr("%1 is still being written; wait for it, or stop it.").arg(name_of(exporter_.path())));
    return !exporter_.busy();
}

void MainWindow::ask_export() {
    if (!may_begin_export()) return;
    const auto painting = session_->snapshot();
    dialogs::ExportSubject subject{{painting->film.shape, painting->film.cell_mm},
                                   session_->recording()};
    const auto& events = subject.film.events;
    subject.has_strokes = std::any_of(events.begin(), events.end(), [](const document::Event& event) {
        return journal::changes_painting(event.action);
    });
    subject.film.events.clear();
    subject.light = export_light();
    auto* dialog = new dialogs::ExportDialog(std::move(subject), export_settings_, export_proposal(),
                                             exported_.has_value(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog] { export_painting(dialog->settings(), dialog->path()); });
    dialog->open();
}

/// Numbered pictures go into a folder of their own each time.
void MainWindow::export_again() {
    if (!exported_ || !may_begin_export()) return;
    const Exported last = *exported_;
    const bool is_sequence = is_folder(last.path);
    export_painting(last.settings,
                    is_sequence ? tools::untaken(last.path, ExportForm::Timelapse) : last.path);
    exported_ = last;
}

void MainWindow::export_painting(const tools::ExportSettings& settings,
                                 const std::filesystem::path& path) {
    session::Capture capture = session_->capture();
    commands::ExportJob job;
    if (settings.form == ExportForm::Timelapse) {
        job.recording = std::move(capture.recording);
        job.choice = tools::timelapse_choice(settings, path, export_light());
    } else {
        job.painting = std::move(capture.painting);
        job.choice = tools::export_choice(settings, path, export_light());
    }
    exporter_.start(std::move(job));
    exported_ = {settings, path};
    export_settings_ = settings;
    export_settings_.folder = path.parent_path().string();
    remember_export();
    export_progress_->show_work(tr("Exporting %1").arg(name_of(path)), text_of(path));
    show_export_commands();
}

void MainWindow::end_export(const commands::ExportOutcome& outcome) {
    export_progress_->hide();
    show_export_commands();
    const bool closes = std::exchange(closes_after_export_, false);
    if (!outcome.error.empty()) {
        QMessageBox::warning(this, tr("Export"), QString::fromStdString(outcome.error));
        return;
    }
    report(words_of(outcome));
    if (closes && outcome.status() == io::ExportStatus::Written) close();
}

/// Whether the window may close as far as an export is concerned.
bool MainWindow::may_stop_export() {
    if (!exporter_.busy()) return true;
    QMessageBox question(QMessageBox::Question, tr("Pastoso"),
                         tr("%1 is still being written.").arg(name_of(exporter_.path())),
                         QMessageBox::Cancel, this);
    QPushButton* wait = question.addButton(tr("Close when it is done"), QMessageBox::AcceptRole);
    QPushButton* stop = question.addButton(tr("Stop it"), QMessageBox::DestructiveRole);
    question.setDefaultButton(wait);
    question.exec();
    if (question.clickedButton() == stop) return true;
    if (question.clickedButton() != wait) return false;
    closes_after_export_ = exporter_.busy();
    if (closes_after_export_)
        report(tr("The window closes as soon as %1 is written.").arg(name_of(exporter_.path())));
    return !closes_after_export_;
}

void MainWindow::ask_save_recording() {
    const QString path = QFileDialog::getSaveFileName(this, tr("Export recording"), tr("painting.json"),
                                                      tr("Recordings (*.json)"));
    if (path.isEmpty()) return;
    try {
        io::write_recording_json(path.toStdString(), session_->recording());
        report(tr("Saved %1.").arg(path));
    } catch (const core::InputError& error) {
        QMessageBox::warning(this, tr("Export recording"), QString::fromUtf8(error.what()));
    }
}

}  // namespace pastoso::main
