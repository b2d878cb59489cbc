#include "main/layers/picture_layers.hpp"

#include "appearance/shown_message.hpp"
#include "core/error.hpp"
#include "files/image.hpp"
#include "main/files/picture_files.hpp"
#include "project/picture_import.hpp"

#include <utility>
#include <vector>

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

/// Of several, a file that is no picture keeps no other from the canvas.
void PictureLayers::paint_pictures(const QStringList& paths) {
    const auto make = [this, paths,
                       canvas = studio_.session().canvas()](const core::Progress& progress) {
        std::vector<document::PaintPicture> layers;
        std::vector<core::Message> faults;
        for (qsizetype i = 0; i < paths.size(); ++i) {
            progress(static_cast<double>(i) / static_cast<double>(paths.size()));
            try {
                layers.push_back(layer_of(files::read_picture(paths[i].toStdString()).picture,
                                          QFileInfo(paths[i]).completeBaseName(), canvas));
                layers.back().joins = layers.size() > 1;
            } catch (const core::InputError& error) {
                if (paths.size() == 1) throw;
                faults.push_back(error.message());
            }
        }
        return [this, layers, faults] {
            for (const document::PaintPicture& layer : layers)
                studio_.session().post(layer);
            for (const core::Message& fault : faults)
                studio_.report_refusal(appearance::shown_message(fault));
        };
    };
    loading_.begin(tr("Reading %1").arg(QFileInfo(paths.front()).fileName()), make);
}

void PictureLayers::paint_picture(pigment::Picture picture, const QString& name) {
    studio_.session().post(layer_of(std::move(picture), name, studio_.session().canvas()));
}

void PictureLayers::ask_paint_picture() {
    const QString path =
        QFileDialog::getOpenFileName(&studio_.window(), tr("Layer from a picture"), {},
                                     tr("Pictures (%1);;All files (*)").arg(picture_endings()));
    if (!path.isEmpty()) paint_pictures({path});
}

}  // namespace pastoso::main
