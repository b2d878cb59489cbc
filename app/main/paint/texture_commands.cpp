#include "main/paint/texture_commands.hpp"

#include "files/image.hpp"
#include "main/files/picture_files.hpp"
#include "main/paint/lent_paint.hpp"
#include "project/picture_import.hpp"
#include "tools/selecting.hpp"

#include <utility>

#include <QFileInfo>
#include <QMainWindow>

namespace pastoso::main {
namespace {

/// What is outlined lies within it, or else the canvas.
layers::PicturePlace room_of(const document::Snapshot& painting) {
    const document::CanvasSettings& canvas = painting.bare->settings;
    const grid::Rect cells =
        painting.selection != nullptr ? tools::outlined_area(painting.selection) : grid::Rect{};
    if (cells.empty()) return {0.0, 0.0, canvas.width_mm, canvas.height_mm};
    const double cell_mm = painting.film.cell_mm;
    return {cell_mm * cells.x0, cell_mm * cells.y0, cell_mm * cells.width(), cell_mm * cells.height()};
}

/// In the middle of the room, as large as it fits.
layers::PressedTexture placed(layers::PressedTexture pressed, pigment::Picture picture,
                              const layers::PicturePlace& room, document::CanvasSettings canvas) {
    canvas.width_mm = room.width_mm;
    canvas.height_mm = room.height_mm;
    pressed.place = project::fitted_place(picture.width, picture.height, canvas);
    pressed.place.x_mm += room.x_mm;
    pressed.place.y_mm += room.y_mm;
    pressed.picture =
        project::paint_of_picture(std::move(picture), {}, pressed.place, canvas.px_per_mm).picture;
    return pressed;
}

}  // namespace

TextureCommands::TextureCommands(Studio& studio, Loading& loading) : studio_(studio), loading_(loading) {
    studio_.commands().on(commands::Command::LayTexture, [this](bool) { ask(); });
}

void TextureCommands::ask() {
    if (paint_is_lent(studio_)) return;
    chosen_.pressed.place = room_of(*studio_.session().snapshot());
    auto* dialog = new dialogs::TextureDialog(
        chosen_, tr("Pictures (%1);;All files (*)").arg(picture_endings()), &studio_.window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { take(dialog->chosen()); });
    dialog->show();
}

void TextureCommands::take(const dialogs::ChosenTexture& chosen) {
    using Form = dialogs::ChosenTexture::Form;
    chosen_ = chosen;
    if (chosen.form == Form::Pressed) return read_picture();
    if (chosen.form == Form::Sand)
        lay(chosen.sand);
    else
        lay(chosen.knifed);
    // A second coat has grains and passes of its own.
    ++chosen_.sand.seed;
    ++chosen_.knifed.seed;
}

void TextureCommands::read_picture() {
    loading_.begin(tr("Reading %1").arg(QFileInfo(chosen_.picture).fileName()),
                   [this, path = chosen_.picture.toStdString(), pressed = chosen_.pressed,
                    room = room_of(*studio_.session().snapshot()),
                    canvas = studio_.session().canvas()](const core::Progress&) {
                       const layers::PressedTexture texture =
                           placed(pressed, files::read_picture(path).picture, room, canvas);
                       return [this, texture] { lay(texture); };
                   });
}

/// A recording may have begun to be played since the dialog was opened.
void TextureCommands::lay(const layers::Texture& texture) {
    if (paint_is_lent(studio_)) return;
    studio_.easel().lay_texture({studio_.easel().hand().paint, texture});
    studio_.report(studio_.session().snapshot()->selection == nullptr
                       ? tr("The paste lies on the whole canvas, dry.")
                       : tr("The paste lies where it is selected, dry."));
}

}  // namespace pastoso::main
