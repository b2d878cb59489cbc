// The swatches of the media, painted once they are to be seen.
#pragma once

#include "main/panel_set.hpp"
#include "main/studio.hpp"
#include "session/thumbnail_painter.hpp"

#include <memory>
#include <vector>

#include <QObject>

namespace pastoso::panels {
class MediumBox;
}

namespace pastoso::main {

class MediaSwatches : public QObject {
    Q_OBJECT
  public:
    MediaSwatches(Studio& studio, const PanelSet& panels);

  private:
    void paint_all();
    void show(const std::string& medium, const pigment::Image8& picture);

    Studio& studio_;
    std::vector<panels::MediumBox*> boxes_;
    double pixels_ = 1.0;  ///< of the screen for one of the layout
    std::unique_ptr<session::ThumbnailPainter> painter_;
};

}  // namespace pastoso::main
