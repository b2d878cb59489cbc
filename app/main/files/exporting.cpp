#include "main/files/exporting.hpp"

#include "appearance/shown_message.hpp"
#include "appearance/shown_number.hpp"
#include "core/looking.hpp"
#include "core/user_data.hpp"
#include "dialogs/export_dialog.hpp"
#include "journal/undo_reach.hpp"
#include "main/files/project_files.hpp"
#include "main/paint/light_choice.hpp"
#include "panels/parts/work_progress.hpp"
#include "recordings/recording_json.hpp"
#include "tools/export_names.hpp"

#include <utility>

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QMainWindow>
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
    return appearance::shown_number(mm, 3);
}

QString words_of(const recordings::ExportReport& report, const QString& name) {
    if (report.triangles > 0)
        return Exporting::tr("Exported %1: %n triangle(s), %2 × %3 mm.", nullptr,
                             static_cast<int>(report.triangles))
            .arg(name)
            .arg(appearance::shown_number(report.width_mm))
            .arg(appearance::shown_number(report.height_mm));
    if (report.files.size() > 1)
        return Exporting::tr("Exported %1 and %2 more; heights from %3 mm (black) to %4 mm (white).")
            .arg(name_of(report.files.front()))
            .arg(report.files.size() - 1)
            .arg(length_mm(report.heights.black_mm), length_mm(report.heights.white_mm));
    return Exporting::tr("Exported %1: %2 × %3 pixels.")
        .arg(name)
        .arg(report.width_px)
        .arg(report.height_px);
}

QString words_of(const recordings::TimelapseReport& report, const QString& name) {
    return Exporting::tr("Exported %1: %n frame(s) of %2 × %3 pixels.", nullptr,
                         static_cast<int>(report.frames))
        .arg(name)
        .arg(report.width_px)
        .arg(report.height_px);
}

QString words_of(const project::LayeredCopyReport& report, const QString& name) {
    return Exporting::tr("Saved %1: %n layer(s) of %2 × %3 pixels.", nullptr,
                         static_cast<int>(report.layers))
        .arg(name)
        .arg(report.width_px)
        .arg(report.height_px);
}

QString words_of(const commands::ExportOutcome& outcome) {
    const QString name = name_of(outcome.path);
    if (outcome.status() == files::ExportStatus::Written)
        return std::visit([&](const auto& report) { return words_of(report, name); }, outcome.report);
    const auto* film = std::get_if<recordings::TimelapseReport>(&outcome.report);
    if (film != nullptr && film->written > 0 && core::is_folder(outcome.path))
        return Exporting::tr("Stopped; %1 holds the pictures that are complete.").arg(name);
    return Exporting::tr("Stopped; %1 was not written.").arg(name);
}

/// Where pictures usually go; not everybody has such a folder.
std::filesystem::path first_folder() {
    const std::filesystem::path pictures =
        QStandardPaths::writableLocation(QStandardPaths::PicturesLocation).toStdString();
    return core::is_folder(pictures) ? pictures : std::filesystem::path(QDir::homePath().toStdString());
}

}  // namespace

Exporting::Exporting(Studio& studio, const ProjectFiles& files, const LightChoice& light)
    : studio_(studio),
      files_(files),
      light_(light),
      file_(studio, core::user_config_path("export.json")) {
    studio_.commands().on(Command::Export, [this](bool) { ask(settings_); });
    studio_.commands().on(Command::MakeTimelapse, [this](bool) {
        tools::ExportSettings film = settings_;
        film.form = ExportForm::Timelapse;
        ask(film);
    });
    studio_.commands().on(Command::ExportAgain, [this](bool) { repeat(); });
    studio_.commands().on(Command::StopExport, [this](bool) { exporter_.stop(); });
    studio_.commands().on(Command::SaveCopy, [this](bool) { ask_save_copy(); });
    studio_.commands().on(Command::SaveRecording, [this](bool) { ask_save_recording(); });
    studio_.commands().action(Command::StopExport)->setIconText(tr("Stop"));
    progress_ = new panels::WorkProgress(studio_.commands().action(Command::StopExport));
    progress_->setObjectName(QStringLiteral("export_progress"));
    studio_.window().statusBar()->insertPermanentWidget(0, progress_);
    connect(&exporter_, &commands::Exporter::progressed, progress_, &panels::WorkProgress::show_done);
    connect(&exporter_, &commands::Exporter::finished, this, &Exporting::end);
    connect(&studio_, &Studio::session_begun, this, [this] {
        exported_.reset();
        show_commands();
    });
    show_commands();
    recall();
}

void Exporting::show_commands() {
    studio_.commands().action(Command::ExportAgain)->setEnabled(exported_.has_value());
    studio_.commands().action(Command::StopExport)->setEnabled(exporter_.busy());
}

/// A file that cannot be read is told, and left as it is.
void Exporting::recall() {
    file_.recall([this](const auto& file) { settings_ = tools::read_export_settings(file); });
}

void Exporting::remember() {
    file_.remember([this](const auto& file) { tools::write_export_settings(settings_, file); });
}

/// Beside the painting, or where the last export went.
std::filesystem::path Exporting::proposal() const {
    if (exported_) return exported_->path;
    const std::filesystem::path painting = files_.path().toStdString();
    if (!painting.empty()) return core::absolute_path(painting).replace_extension();
    const std::filesystem::path last = settings_.folder;
    return (core::is_folder(last) ? last : first_folder()) / tr("painting").toStdString();
}

tools::ExportLight Exporting::light() const {
    return {light_.name().toStdString(), light_.lamp(), light_.varnish()};
}

bool Exporting::may_begin() {
    if (exporter_.busy())
        studio_.report(
            tr("%1 is still being written; wait for it, or stop it.").arg(name_of(exporter_.path())));
    return !exporter_.busy();
}

void Exporting::ask(const tools::ExportSettings& settings) {
    if (!may_begin()) return;
    const auto painting = studio_.session().snapshot();
    const document::Recorder record = studio_.session().record();
    dialogs::ExportSubject subject{{painting->film.shape, painting->film.cell_mm},
                                   {record.canvas(), {}, record.end_tick()},
                                   record.changes_painting()};
    subject.light = light();
    auto* dialog = new dialogs::ExportDialog(std::move(subject), settings, proposal(),
                                             exported_.has_value(), &studio_.window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog] { start(dialog->settings(), dialog->path()); });
    dialog->open();
}

/// Numbered pictures go into a folder of their own each time.
void Exporting::repeat() {
    if (!exported_ || !may_begin()) return;
    const Exported last = *exported_;
    const bool is_sequence = core::is_folder(last.path);
    start(last.settings, is_sequence ? tools::untaken(last.path, ExportForm::Timelapse) : last.path);
    exported_ = last;
}

void Exporting::start(const tools::ExportSettings& settings, const std::filesystem::path& path) {
    session::Capture capture = studio_.session().capture();
    commands::ExportJob job;
    if (settings.form == ExportForm::Timelapse) {
        job.record = std::move(capture.record);
        job.choice = tools::timelapse_choice(settings, path, light());
    } else {
        job.painting = std::move(capture.painting);
        job.choice = tools::export_choice(settings, path, light());
    }
    exported_ = {settings, path};
    settings_ = settings;
    settings_.folder = path.parent_path().string();
    remember();
    begin(std::move(job));
}

void Exporting::begin(commands::ExportJob job) {
    const std::filesystem::path path = path_of(job);
    exporter_.start(std::move(job));
    progress_->show_work(tr("Exporting %1").arg(name_of(path)), text_of(path));
    show_commands();
}

void Exporting::ask_save_copy() {
    if (!may_begin()) return;
    const QString open_raster = tr("OpenRaster (*.ora)"), photoshop = tr("Photoshop (*.psd)");
    QString kind = open_raster;
    const QString proposed = text_of(proposal().replace_extension(".ora"));
    const QString path =
        QFileDialog::getSaveFileName(&studio_.window(), tr("Save a copy"), proposed,
                                     open_raster + QStringLiteral(";;") + photoshop, &kind);
    if (path.isEmpty()) return;
    std::filesystem::path file = path.toStdString();
    if (!file.has_extension()) file += kind == photoshop ? ".psd" : ".ora";
    start_copy(file);
}

void Exporting::start_copy(const std::filesystem::path& path) {
    const project::LayeredCopy copy{path};
    studio_.attempt(tr("Save a copy"), [&] {
        project::check_layered_copy(copy);
        begin({studio_.session().capture().painting, {}, copy});
    });
}

void Exporting::end(const commands::ExportOutcome& outcome) {
    progress_->hide();
    show_commands();
    const bool closes = std::exchange(closes_after_, false);
    if (!outcome.error.empty()) {
        studio_.messages().raise({panels::Matter::Export,
                                  tr("%1 Nothing was exported: make room or choose another place.")
                                      .arg(appearance::shown_message(outcome.error)),
                                  tr("Export..."), [this] { ask(settings_); }});
        return;
    }
    studio_.messages().solve(panels::Matter::Export);
    studio_.report(words_of(outcome));
    if (closes && outcome.status() == files::ExportStatus::Written) studio_.window().close();
}

/// Whether the window may close as far as an export is concerned.
bool Exporting::may_stop() {
    if (!exporter_.busy()) return true;
    QMessageBox question(QMessageBox::Question, tr("Pastoso"),
                         tr("%1 is still being written.").arg(name_of(exporter_.path())),
                         QMessageBox::Cancel, &studio_.window());
    QPushButton* wait = question.addButton(tr("Close when it is done"), QMessageBox::AcceptRole);
    QPushButton* stop = question.addButton(tr("Stop it"), QMessageBox::DestructiveRole);
    question.setDefaultButton(wait);
    question.exec();
    if (question.clickedButton() == stop) return true;
    if (question.clickedButton() != wait) return false;
    closes_after_ = exporter_.busy();
    if (closes_after_)
        studio_.report(tr("The window closes as soon as %1 is written.").arg(name_of(exporter_.path())));
    return !closes_after_;
}

void Exporting::ask_save_recording() {
    const QString path = QFileDialog::getSaveFileName(&studio_.window(), tr("Export recording"),
                                                      tr("painting.json"), tr("Recordings (*.json)"));
    if (path.isEmpty()) return;
    studio_.attempt(tr("Export recording"), [&] {
        recordings::write_recording_json(path.toStdString(), studio_.session().recording());
        studio_.report(tr("Saved %1.").arg(path));
    });
}

}  // namespace pastoso::main
