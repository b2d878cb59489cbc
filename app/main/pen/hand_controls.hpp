// What the painter does with the brush in hand, the paint on it and the easel before it, by commands and
// in the panels.
#pragma once

#include "main/panel_set.hpp"
#include "main/studio.hpp"

#include <QObject>

namespace pastoso::main {

class HandControls : public QObject {
    Q_OBJECT
  public:
    HandControls(Studio& studio, const PanelSet& panels);

  private:
    void connect_commands();
    void connect_panels();
    void use_medium(const QString& name);
    void thin(double paint_share);
    void step_width(int steps);
    void set_width(double width_mm);
    void show(const tools::Hand& hand);

    Studio& studio_;
    const PanelSet& panels_;
};

}  // namespace pastoso::main
