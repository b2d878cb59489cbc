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

    /// Paint that is dragged here from another window: its middle there, or as that of the clipboard.
    void paste_dragged(const QMimeData& dragged, std::optional<glm::dvec2> middle_mm);

  private:
    /// Of that layer; 0: all that is visible. Says whether there was paint.
    bool copy(document::LayerId layer);
    void cut();
    /// Paint: its middle there, or where it was copied; where that is not on the canvas, in its middle.
    void paste(std::optional<glm::dvec2> middle_mm);
    /// Files of pictures, or one that is in memory, as layers.
    void paste_pictures(const QMimeData& held);
    /// Gives the painting the paint of another one that is held. Says why where it cannot; `name` stands
    /// for what holds it.
    bool bring(const QMimeData& held, const QString& name);
    void paste_copied(std::optional<glm::dvec2> middle_mm);
    document::LayerId active_layer() const;

    Studio& studio_;
    PictureLayers& pictures_;
};

}  // namespace pastoso::main
