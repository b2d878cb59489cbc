// What the window finds again at the next start: the pen's settings, and how window and panels stand.
#pragma once

#include "main/panel_set.hpp"
#include "main/program/remembered_file.hpp"
#include "main/studio.hpp"

#include <QByteArray>
#include <QObject>

namespace pastoso::main {

class BrushEditing;
class LightChoice;
class StartCommands;
class UndoCommands;
class WellCommands;

class WindowSettings : public QObject {
    Q_OBJECT
  public:
    WindowSettings(Studio& studio, const PanelSet& panels, LightChoice& light, UndoCommands& undo,
                   WellCommands& well, StartCommands& start, BrushEditing& brush_editing);

    /// A file that cannot be read is told, and left as it is.
    void recall();
    void remember();

  private:
    void reset_panels();

    Studio& studio_;
    const PanelSet& panels_;
    LightChoice& light_;
    UndoCommands& undo_;
    WellCommands& well_;
    StartCommands& start_;
    BrushEditing& brush_editing_;
    QByteArray first_panels_;  ///< how the panels stand unless the painter moves them
    RememberedFile file_;
};

}  // namespace pastoso::main
