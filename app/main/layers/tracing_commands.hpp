// The picture that is traced: below the paint, and in a panel beside the canvas.
#pragma once

#include "main/studio.hpp"

#include <QObject>

namespace pastoso::panels {
class TracingPanel;
}

namespace pastoso::main {

class TracingCommands : public QObject {
    Q_OBJECT
  public:
    TracingCommands(Studio& studio, panels::TracingPanel* panel);

    /// Lays a picture below the paint to be traced, in the middle and as large as it fits. Throws
    /// core::InputError when it is none.
    void trace_picture(const QString& path);

  private:
    void ask_trace_picture();
    void show(const document::Snapshot& painting);

    Studio& studio_;
    panels::TracingPanel* panel_;
};

}  // namespace pastoso::main
