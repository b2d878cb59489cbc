// Mirrors, copies, ruler and ellipse on the canvas.
#pragma once

#include "main/studio.hpp"
#include "tools/guide_handles.hpp"

#include <QObject>

namespace pastoso::panels {
class GuidesPanel;
}

namespace pastoso::main {

class GuideCommands : public QObject {
    Q_OBJECT
  public:
    GuideCommands(Studio& studio, panels::GuidesPanel* guides);

  private:
    void set_symmetry(const brush::Symmetry& symmetry);
    void set_mirrors(bool upright, bool level);
    void move_guide(const tools::Guide& guide);
    void lay_ruler(bool lies);
    void lay_ellipse(bool lies);
    void remove_guides();
    void show(const tools::Hand& hand);

    Studio& studio_;
    panels::GuidesPanel* guides_;
};

}  // namespace pastoso::main
