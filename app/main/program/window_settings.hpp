// What the window finds again at the next start: the pen's settings, and how window and panels stand.
#pragma once

#include "main/panel_set.hpp"
#include "main/program/remembered_file.hpp"
#include "main/studio.hpp"

#include <QObject>

namespace pastoso::main {

class BrushEditing;
class DockHeights;
class LightChoice;
class StartCommands;
class TourCommands;
class UndoCommands;
class WellCommands;

class WindowSettings : public QObject {
    Q_OBJECT
  public:
    WindowSettings(Studio& studio, const PanelSet& panels, LightChoice& light, UndoCommands& undo,
                   WellCommands& well, StartCommands& start, BrushEditing& brush_editing,
                   TourCommands& tour, DockHeights& heights);

    /// Whether the panels stand as they were left; otherwise as before. A file that cannot be read is
    /// told, and left as it is.
    bool recall();
    void remember();

  private:
    Studio& studio_;
    const PanelSet& panels_;
    LightChoice& light_;
    UndoCommands& undo_;
    WellCommands& well_;
    StartCommands& start_;
    BrushEditing& brush_editing_;
    TourCommands& tour_;
    DockHeights& heights_;
    RememberedFile file_;
};

}  // namespace pastoso::main
