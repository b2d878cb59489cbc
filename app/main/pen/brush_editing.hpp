// The brush editor: shown beside the canvas, and what is changed in it.
#pragma once

#include "main/studio.hpp"

#include <QObject>

namespace pastoso::panels {
class BrushEditor;
class CurvesPanel;
}

namespace pastoso::main {

class BrushJar;

class BrushEditing : public QObject {
    Q_OBJECT
  public:
    /// `curves` of the tool in hand are hidden while the editor has them.
    BrushEditing(Studio& studio, const BrushJar& jar, panels::CurvesPanel* curves);

    /// The editor's page that is open, or will be (panels::BrushEditor::open_page).
    int page() const;
    void set_page(int page);

  private:
    void show_or_hide();
    void make();
    void show();

    Studio& studio_;
    const BrushJar& jar_;
    panels::CurvesPanel* curves_;
    panels::BrushEditor* editor_ = nullptr;  ///< the window's, once it was asked for
    int page_ = 0;                           ///< before that
};

}  // namespace pastoso::main
