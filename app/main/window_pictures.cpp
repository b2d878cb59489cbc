// Pictures and files of other programs: on a canvas of their own, or as a layer of this one.

#include "core/error.hpp"
#include "io/image.hpp"
#include "main/main_window.hpp"
#include "main/wait_cursor.hpp"
#include "panels/status_readings.hpp"
#include "project/import_open_raster.hpp"

#include <utility>

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

namespace pastoso::main {
namespace {

project::LoadedProject imported(const std::filesystem::path& path, core::ThreadPool& pool) {
    return project::is_open_raster_path(path) ? project::import_open_raster(path, {}, pool)
                                              : project::import_picture(path, {}, pool);
}

}  // namespace

void MainWindow::connect_picture_commands() {
    commands_.on(commands::Command::LayerFromPicture, [this](bool) { ask_paint_picture(); });
}

QString MainWindow::picture_endings() {
    return QStringLiteral(
        "*.png *.jpg *.jpeg *.tif *.tiff *.webp *.exr *.hdr *.bmp *.tga *.gif *.psd *.pgm *.ppm");
}

void MainWindow::open_picture(const QString& path) {
    const WaitCursor waiting;
    auto pool = std::make_unique<core::ThreadPool>();
    const project::LoadedProject project = imported(path.toStdString(), *pool);
    auto painting = std::make_unique<document::Painting>(project.painting, *pool);
    core::ThreadPool& threads = *pool;
    start_session(
        std::move(pool), std::move(painting), project.strokes,
        {.write_start =
             [&](const std::filesystem::path& start) { project::save_project(start, project, threads); },
         .is_saved = false});
    saved_changes_ = -1;
    show_title();
    setWindowModified(true);
    take_up_hand(project.strokes);
    readings_->show_canvas(session_->canvas());
    show_published();
    for (const std::string& note : project.notes)
        report(QString::fromStdString(note));
}

void MainWindow::paint_picture(const QString& path) {
    const WaitCursor waiting;
    io::StoredPicture stored = io::read_picture(path.toStdString());
    const document::CanvasSettings& canvas = session_->canvas();
    const layers::PicturePlace place =
        project::fitted_place(stored.picture.width, stored.picture.height, canvas);
    session_->post(project::paint_of_picture(std::move(stored.picture),
                                             QFileInfo(path).completeBaseName().toStdString(), place,
                                             canvas.px_per_mm));
}

void MainWindow::ask_paint_picture() {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Layer from a picture"), {}, tr("Pictures (%1);;All files (*)").arg(picture_endings()));
    if (path.isEmpty()) return;
    try {
        paint_picture(path);
    } catch (const core::InputError& error) {
        QMessageBox::warning(this, tr("Layer from a picture"), QString::fromUtf8(error.what()));
    }
}

}  // namespace pastoso::main
