// The mixing well beside the canvas: opened, squeezed onto, wiped, and shown as it is.
#pragma once

#include "main/studio.hpp"

#include <memory>

#include <QObject>

class QDockWidget;

namespace pastoso::main {

class WellCommands : public QObject {
    Q_OBJECT
  public:
    /// `dock` holds the studio's well.
    WellCommands(Studio& studio, QDockWidget* dock);

    /// Whether it was given its size; if not, it gets room to mix in when it is opened.
    void set_sized(bool sized) { sized_ = sized; }

  private:
    void open(bool open);
    void squeeze();
    void show(const document::Snapshot& painting);

    Studio& studio_;
    QDockWidget* dock_;
    bool sized_ = false;
    std::shared_ptr<const document::Snapshot> shown_;
};

}  // namespace pastoso::main
