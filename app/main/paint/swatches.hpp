// Shows every swatch of paint in the window, and what the brush holds, as a flat spot of it will look on
// the canvas.
#pragma once

#include "main/panel_set.hpp"
#include "main/studio.hpp"
#include "tools/swatch.hpp"

#include <QObject>

namespace pastoso::main {

class Swatches : public QObject {
    Q_OBJECT
  public:
    Swatches(Studio& studio, const PanelSet& panels);

    /// Of the tool and medium in hand, on the present canvas, in its light.
    const tools::SwatchView& view() const { return view_; }

  private:
    void follow_hand(const tools::Hand& hand);
    void follow_ground(const document::Snapshot& painting);
    void follow_light();
    void show(const tools::SwatchView& view);
    void show_paint_in_hand();

    Studio& studio_;
    const PanelSet& panels_;
    tools::SwatchView view_;
    brush::LoadProfile load_;
};

}  // namespace pastoso::main
