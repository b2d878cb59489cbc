// The pictures of the layers in their panel, which follow the paint.
#pragma once

#include "main/studio.hpp"
#include "session/layer_painter.hpp"

#include <map>
#include <memory>

#include <QObject>
#include <QTimer>

class QDockWidget;

namespace pastoso::panels {
class LayerPanel;
}

namespace pastoso::main {

class LayerPictures : public QObject {
    Q_OBJECT
  public:
    /// `dock` holds `layers`.
    LayerPictures(Studio& studio, panels::LayerPanel* layers, QDockWidget* dock);

  private:
    void want();
    void forget();

    Studio& studio_;
    panels::LayerPanel* layers_;
    std::unique_ptr<session::LayerPainter> painter_;
    /// What the pictures show.
    std::map<document::LayerId, std::shared_ptr<const film::FilmState>> pictured_;
    QTimer changed_;  ///< soon after their paint
};

}  // namespace pastoso::main
