#include "main/files/painting_again.hpp"

#include "appearance/shown_message.hpp"
#include "core/fault.hpp"
#include "dialogs/repaint_dialog.hpp"
#include "main/files/project_files.hpp"
#include "main/files/repaint_window.hpp"
#include "main/paint/light_choice.hpp"
#include "recordings/painting_export.hpp"

#include <utility>

#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMainWindow>

namespace pastoso::main {
namespace {

using commands::Command;
using Painted = std::shared_ptr<const project::Project>;

/// Beside the painting, with the cells in its name.
QString proposal(const QString& path, const project::Project& painted) {
    const QFileInfo file(path);
    const QString name = path.isEmpty() ? PaintingAgain::tr("painting") : file.completeBaseName();
    const QString cells = QString::number(painted.strokes.canvas.px_per_mm);
    const QString folder = path.isEmpty() ? QString() : file.path() + QLatin1Char('/');
    return folder + name + QLatin1Char('-') + cells + QStringLiteral(".pastoso");
}

recordings::ExportChoice picture_of(const LightChoice& light, const QString& path) {
    recordings::ExportChoice choice;
    choice.path = path.toStdString();
    choice.picture.light = light.name().toStdString();
    choice.lighting = light.lamp();
    choice.varnish = light.varnish();
    return choice;
}

QString written(const project::Project& painted, const recordings::ExportChoice& picture,
                const QString& name, const BackgroundExport::Stops& stops) {
    core::ThreadPool pool;
    if (project::is_project_path(picture.path)) {
        project::save_project(picture.path, painted, pool);
        return PaintingAgain::tr("Saved %1.").arg(name);
    }
    const recordings::ExportReport report =
        recordings::export_painting(painted.painting, picture, pool, [&](double) { return !stops(); });
    if (report.status == files::ExportStatus::Stopped) return {};
    return PaintingAgain::tr("Saved %1: %2 × %3 pixels.")
        .arg(name)
        .arg(report.width_px)
        .arg(report.height_px);
}

}  // namespace

PaintingAgain::PaintingAgain(Studio& studio, ProjectFiles& files, const LightChoice& light)
    : studio_(studio),
      files_(files),
      light_(light),
      saving_(studio),
      ending_([](std::unique_ptr<session::Repainter>& repainter) { repainter.reset(); },
              [tell = studio.teller()](auto&, const core::Message& fault) { tell(fault); }) {
    studio_.commands().on(Command::PaintAgain, [this](bool) { ask(); });
}

RepaintWindow* PaintingAgain::window() const {
    return qobject_cast<RepaintWindow*>(window_.data());
}

void PaintingAgain::ask() {
    if (RepaintWindow* open = window()) return open->come_to_front();
    const document::Recorder record = studio_.session().record();
    if (!record.changes_painting())
        return studio_.report(tr("Nothing has been painted yet that could be painted again."));
    const std::string name = tr("The painting").toStdString();
    auto* dialog = new dialogs::RepaintDialog(record.recording(), name, &studio_.window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, name] { start(dialog->strokes(), name); });
    dialog->open();
}

void PaintingAgain::start(const document::Recording& strokes, const std::string& name) {
    auto* window = new RepaintWindow(strokes, name, studio_.canvas(), &studio_.window());
    window_ = window;
    connect(window, &RepaintWindow::easel_wanted, this, &PaintingAgain::put_up);
    connect(window, &RepaintWindow::file_wanted, this, &PaintingAgain::ask_save);
    connect(window, &RepaintWindow::closes, this,
            [this, window] { ending_.add(window->take_repainter()); });
    window->show();
}

bool PaintingAgain::may_stop() {
    if (is_saving()) studio_.report(tr("The finer painting is still being written."));
    return !is_saving() && (window() == nullptr || window()->may_go());
}

void PaintingAgain::stop() {
    if (window() != nullptr) window()->let_go();
}

/// Not under a dialog that asks about the painting which is there.
void PaintingAgain::put_up(const Painted& painted) {
    if (QGuiApplication::modalWindow() != nullptr)
        return window()->tell(tr("Another question is open; answer it first."));
    files_.ask_to_put_up_unsaved(painted, [this] {
        if (window() != nullptr) window()->let_go();
    });
}

void PaintingAgain::ask_save(const Painted& painted) {
    const QString path = QFileDialog::getSaveFileName(
        window(), tr("Save"), proposal(files_.path(), *painted),
        tr("Paintings and pictures (%1)")
            .arg(QStringLiteral("*.pastoso *.png *.tif *.jpg *.webp *.exr")));
    if (!path.isEmpty()) save(painted, path);
}

void PaintingAgain::save(Painted painted, const QString& path) {
    const recordings::ExportChoice picture = picture_of(light_, path);
    const QString name = QFileInfo(path).fileName();
    saving_.start([this, painted = std::move(painted), picture,
                   name](const BackgroundExport::Stops& stops) -> QString {
        QString told;
        const core::Message fault =
            core::fault_of([&] { told = written(*painted, picture, name, stops); });
        if (!fault.empty()) told = appearance::shown_message(fault);
        const bool is_kept = fault.empty() && project::is_project_path(picture.path);
        QMetaObject::invokeMethod(
            this, [this, told, is_kept] { end_saving(told, is_kept); }, Qt::QueuedConnection);
        return told;
    });
}

/// The painter looks at either window.
void PaintingAgain::end_saving(const QString& told, bool is_kept) {
    if (window() == nullptr) return;
    window()->tell(told);
    if (is_kept) window()->keep();
}

}  // namespace pastoso::main
