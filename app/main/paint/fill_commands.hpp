// Even films of paint, of one colour or graded between two, poured over what is selected.
#pragma once

#include "main/studio.hpp"

#include <QObject>

namespace pastoso::panels {
class BrushPanel;
}

namespace pastoso::main {

class FillCommands : public QObject {
    Q_OBJECT
  public:
    /// Taking a tool of `brushes` ends the gradients.
    FillCommands(Studio& studio, panels::BrushPanel* brushes);

    void end_gradients() { draw_gradients(false); }

    /// With the paint in hand; so thick while it is wet.
    void tone_ground(double thickness_mm);

  Q_SIGNALS:
    void gradients_begin();  ///< a press draws the line of one from now on, and does nothing else

  private:
    void listen_to_line();
    void draw_gradients(bool on);
    void pour(document::FillWithPaint fill);
    void ask_thickness();
    void ask_for_ground();

    Studio& studio_;
    bool drawing_ = false;
    double thickness_mm_ = document::FillWithPaint{}.thickness_mm;
    double ground_mm_ = document::ToneGround{}.thickness_mm;
};

}  // namespace pastoso::main
