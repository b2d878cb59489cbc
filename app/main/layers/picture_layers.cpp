#include "main/layers/picture_layers.hpp"

#include "files/image.hpp"
#include "main/files/picture_files.hpp"
#include "main/wait_cursor.hpp"
#include "project/picture_import.hpp"

#include <utility>

#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>

namespace pastoso::main {

PictureLayers::PictureLayers(Studio& studio) : studio_(studio) {
    studio_.commands().on(commands::Command::LayerFromPicture, [this](bool) { ask_paint_picture(); });
}

void PictureLayers::paint_picture(const QString& path) {
    const WaitCursor waiting;
    paint_picture(files::read_picture(path.toStdString()).picture, QFileInfo(path).completeBaseName());
}

void PictureLayers::paint_picture(pigment::Picture picture, const QString& name) {
    const document::CanvasSettings& canvas = studio_.session().canvas();
    const layers::PicturePlace place = project::fitted_place(picture.width, picture.height, canvas);
    studio_.session().post(
        project::paint_of_picture(std::move(picture), name.toStdString(), place, canvas.px_per_mm));
}

void PictureLayers::ask_paint_picture() {
    const QString path =
        QFileDialog::getOpenFileName(&studio_.window(), tr("Layer from a picture"), {},
                                     tr("Pictures (%1);;All files (*)").arg(picture_endings()));
    if (!path.isEmpty()) studio_.attempt(tr("Layer from a picture"), [&] { paint_picture(path); });
}

}  // namespace pastoso::main
