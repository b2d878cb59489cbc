// Time as it passes for the paint: paused, real, or faster.
#pragma once

#include "main/panel_set.hpp"
#include "main/studio.hpp"

#include <QObject>

class QLabel;

namespace pastoso::main {

class PaintTime : public QObject {
    Q_OBJECT
  public:
    PaintTime(Studio& studio, const PanelSet& panels);

  private:
    void connect_commands();
    void fill_box();
    void pause(bool paused);
    void step(int steps);
    void use(int index);
    void show();
    void show_note();

    Studio& studio_;
    const PanelSet& panels_;
    QLabel* note_;    ///< on the canvas, where the box is out of sight
    int chosen_ = 0;  ///< of the box
};

}  // namespace pastoso::main
