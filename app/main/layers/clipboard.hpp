// Paint that is copied, cut and pasted; other programs get pictures of it, and theirs become layers.
#pragma once

#include "main/studio.hpp"

#include <optional>

#include <QObject>
#include <glm/vec2.hpp>

namespace pastoso::main {

class PictureLayers;

/// What the painting keeps of a copy is paint; the system's clipboard has a picture of it.
class Clipboard : public QObject {
    Q_OBJECT
  public:
    Clipboard(Studio& studio, PictureLayers& pictures);

  private:
    /// Of that layer; 0: all that is visible. Says whether there was paint.
    bool copy(document::LayerId layer);
    void cut();
    /// Paint: its middle there, or where it was copied.
    void paste(std::optional<glm::dvec2> middle_mm);
    document::LayerId active_layer() const;

    Studio& studio_;
    PictureLayers& pictures_;
};

}  // namespace pastoso::main
