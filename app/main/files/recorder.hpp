// What is recorded of the painting: how much it is, and to be watched.
#pragma once

#include "main/studio.hpp"

#include <cstdint>

#include <QObject>
#include <QPointer>

namespace pastoso::panels {
class RecorderPanel;
}

namespace pastoso::main {

class ReplayWindow;

class Recorder : public QObject {
    Q_OBJECT
  public:
    Recorder(Studio& studio, panels::RecorderPanel* panel);

    /// Null while none is open.
    ReplayWindow* replay_window() const;

  private:
    void watch();

    Studio& studio_;
    panels::RecorderPanel* panel_;
    std::int64_t past_strokes_ = 0;  ///< before this session
    QPointer<QObject> window_;
};

}  // namespace pastoso::main
