// Undo and redo, and how much memory the steps may take.
#pragma once

#include "main/studio.hpp"
#include "tools/settings.hpp"

#include <QObject>

namespace pastoso::panels {
class HistoryPanel;
}

namespace pastoso::main {

class LayerTransform;

class UndoCommands : public QObject {
    Q_OBJECT
  public:
    /// A frame of `transform` is what was done last.
    UndoCommands(Studio& studio, panels::HistoryPanel* history, LayerTransform& transform);

    int memory_MiB() const { return memory_MiB_; }
    void set_memory(int MiB);

  private:
    void apply_memory();
    void show_enabled(const session::Status& status);
    void show_steps();
    void go_back(int steps);

    Studio& studio_;
    panels::HistoryPanel* history_;
    std::shared_ptr<const session::Steps> shown_steps_;
    LayerTransform& transform_;
    int memory_MiB_ = tools::kUndoMemory_MiB;
};

}  // namespace pastoso::main
