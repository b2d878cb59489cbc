// Mirrors, copies and guides on the canvas.
#pragma once

#include "main/studio.hpp"
#include "tools/guide_handles.hpp"
#include "tools/laid_guide.hpp"

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
    void lay(tools::GuideKind kind);
    void snap(bool snaps);
    void remove_guides();
    void show(const tools::Hand& hand);

    Studio& studio_;
    panels::GuidesPanel* guides_;
    double strength_ = 1.0;  ///< of the guide, when it last had some
};

}  // namespace pastoso::main
