// The brush editor: shown beside the canvas, and what is changed in it.
#pragma once

#include "main/studio.hpp"

#include <QObject>

namespace pastoso::panels {
class BrushEditor;
}

namespace pastoso::main {

class BrushJar;

class BrushEditing : public QObject {
    Q_OBJECT
  public:
    BrushEditing(Studio& studio, const BrushJar& jar);

  private:
    void show_or_hide();
    void make();
    void show();

    Studio& studio_;
    const BrushJar& jar_;
    panels::BrushEditor* editor_ = nullptr;  ///< the window's, once it was asked for
};

}  // namespace pastoso::main
