// The picture that is traced: below the paint, and in a panel beside the canvas.
#pragma once

#include "main/files/loading.hpp"
#include "main/studio.hpp"
#include "pigment/image.hpp"

#include <memory>

#include <QObject>

namespace pastoso::panels {
class TracingPanel;
}

namespace pastoso::main {

class TracingCommands : public QObject {
    Q_OBJECT
  public:
    TracingCommands(Studio& studio, Loading& loading, panels::TracingPanel* panel);

    /// Reads a picture beside the window and lays it below the paint to be traced, in the middle and as
    /// large as it fits.
    void trace_picture(const QString& path);

    /// The same of one that is in memory.
    void trace_picture(pigment::Picture picture);

  private:
    void ask_trace_picture();
    void lay(const std::shared_ptr<const pigment::Picture>& picture);
    void show(const document::Snapshot& painting);

    Studio& studio_;
    Loading& loading_;
    panels::TracingPanel* panel_;
};

}  // namespace pastoso::main
