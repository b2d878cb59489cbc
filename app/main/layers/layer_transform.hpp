// The frame over the canvas that moves, scales and turns the paint of a layer.
#pragma once

#include "main/layers/active_part.hpp"
#include "main/studio.hpp"
#include "tools/transform_frame.hpp"

#include <optional>

#include <QObject>
#include <QPointer>
#include <QRect>
#include <QSizeF>

namespace pastoso::dialogs {
class TransformDialog;
}

namespace pastoso::panels {
class BrushPanel;
}

namespace pastoso::main {

class LayerTransform : public QObject {
    Q_OBJECT
  public:
    /// Taking a tool of `brushes` gives the frame up.
    LayerTransform(Studio& studio, panels::BrushPanel* brushes);

    bool active() const { return transforming_.has_value(); }

    /// Takes the frame away and leaves the paint as it is. False: there was none.
    bool end();
    bool cancel();  ///< the same, and says so

  Q_SIGNALS:
    void changed();  ///< active()

  private:
    void begin();
    void show(const grid::Rect& cells, const document::Snapshot& painting);
    void say_corner();
    QRect frame_on_view(const tools::TransformFrame& frame) const;
    void open_dialog(const tools::TransformFrame& frame, const QSizeF& canvas_mm);
    void apply();
    void follow(const document::Snapshot& painting, const session::Status& status);

    Studio& studio_;
    std::optional<ActivePart> transforming_;  ///< what the frame stands around
    QPointer<dialogs::TransformDialog> dialog_;
};

}  // namespace pastoso::main
