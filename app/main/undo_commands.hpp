// Undo and redo, and how much memory the steps may take.
#pragma once

#include "main/studio.hpp"
#include "tools/settings.hpp"

#include <QObject>

namespace pastoso::main {

class LayerTransform;

class UndoCommands : public QObject {
    Q_OBJECT
  public:
    /// A frame of `transform` is what was done last.
    UndoCommands(Studio& studio, LayerTransform& transform);

    int memory_MiB() const { return memory_MiB_; }
    void set_memory(int MiB);

  private:
    void ask_memory();
    void apply_memory();
    void show_enabled(const session::Status& status);

    Studio& studio_;
    LayerTransform& transform_;
    int memory_MiB_ = tools::kUndoMemory_MiB;
};

}  // namespace pastoso::main
