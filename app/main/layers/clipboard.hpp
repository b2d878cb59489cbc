// Paint that is copied, cut and pasted, in other paintings, too; other programs get pictures of it, and
// theirs become layers.
#pragma once

#include "main/studio.hpp"

#include <optional>

#include <QObject>
#include <glm/vec2.hpp>

class QMimeData;

namespace pastoso::main {

class PictureLayers;

/// What the painting keeps of a copy is paint; the system's clipboard has the same for other paintings,
/// and a picture of it for other programs.
class Clipboard : public QObject {
    Q_OBJECT
  public:
    Clipboard(Studio& studio, PictureLayers& pictures);

  private:
    /// Of that layer; 0: all that is visible. Says whether there was paint.
    bool copy(document::LayerId layer);
    void cut();
    /// Paint: its middle there, or where it was copied; where that is not on the canvas, in its middle.
    void paste(std::optional<glm::dvec2> middle_mm);
    /// Gives the painting the paint of another one that the clipboard holds. Says why where it cannot.
    bool bring(const QMimeData& held);
    void paste_copied(std::optional<glm::dvec2> middle_mm);
    document::LayerId active_layer() const;

    Studio& studio_;
    PictureLayers& pictures_;
};

}  // namespace pastoso::main
