// What is done to the layers, by commands and in their panel.
#pragma once

#include "main/studio.hpp"

#include <QObject>

class QDockWidget;

namespace pastoso::panels {
class LayerPanel;
}

namespace pastoso::main {

class LayerCommands : public QObject {
    Q_OBJECT
  public:
    /// `dock` holds `layers`.
    LayerCommands(Studio& studio, panels::LayerPanel* layers, QDockWidget* dock);

  private:
    void add_layer();
    void remove_layers();
    void clear_layers();
    void group_layers();
    void ungroup_layers();
    void choose_neighbour(bool above);
    void move_layer(bool up);
    void show_commands();

    Studio& studio_;
    panels::LayerPanel* layers_;
};

}  // namespace pastoso::main
