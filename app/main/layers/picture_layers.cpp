#include "main/layers/picture_layers.hpp"

#include "files/image.hpp"
#include "main/files/picture_files.hpp"
#include "project/picture_import.hpp"

#include <utility>

#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>

namespace pastoso::main {
namespace {

document::PaintPicture layer_of(pigment::Picture picture, const QString& name,
                                const document::CanvasSettings& canvas) {
    const layers::PicturePlace place = project::fitted_place(picture.width, picture.height, canvas);
    return project::paint_of_picture(std::move(picture), name.toStdString(), place, canvas.px_per_mm);
}

}  // namespace

PictureLayers::PictureLayers(Studio& studio, Loading& loading) : studio_(studio), loading_(loading) {
    studio_.commands().on(commands::Command::LayerFromPicture, [this](bool) { ask_paint_picture(); });
}

void PictureLayers::paint_picture(const QString& path) {
    const QFileInfo file(path);
    loading_.begin(tr("Reading %1").arg(file.fileName()),
                   [this, path, name = file.completeBaseName(),
                    canvas = studio_.session().canvas()](const core::Progress&) {
                       const document::PaintPicture layer =
                           layer_of(files::read_picture(path.toStdString()).picture, name, canvas);
                       return [this, layer] { studio_.session().post(layer); };
                   });
}

void PictureLayers::paint_picture(pigment::Picture picture, const QString& name) {
    studio_.session().post(layer_of(std::move(picture), name, studio_.session().canvas()));
}

void PictureLayers::ask_paint_picture() {
    const QString path =
        QFileDialog::getOpenFileName(&studio_.window(), tr("Layer from a picture"), {},
                                     tr("Pictures (%1);;All files (*)").arg(picture_endings()));
    if (!path.isEmpty()) paint_picture(path);
}

}  // namespace pastoso::main
