// Texture paste on what is painted on: sand, modelling paste, or a picture pressed in.
#pragma once

#include "dialogs/texture_dialog.hpp"
#include "main/files/loading.hpp"
#include "main/studio.hpp"

#include <QObject>

namespace pastoso::main {

class TextureCommands : public QObject {
    Q_OBJECT
  public:
    TextureCommands(Studio& studio, Loading& loading);

  private:
    void ask();
    void take(const dialogs::ChosenTexture& chosen);
    void read_picture();
    void lay(const layers::Texture& texture);

    Studio& studio_;
    Loading& loading_;
    dialogs::ChosenTexture chosen_;
};

}  // namespace pastoso::main
