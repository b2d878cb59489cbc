// How much of the canvas is seen, and where the pointer is on it.
#pragma once

#include "main/studio.hpp"

#include <QObject>

namespace pastoso::panels {
class StatusReadings;
}

namespace pastoso::main {

class ViewCommands : public QObject {
    Q_OBJECT
  public:
    ViewCommands(Studio& studio, panels::StatusReadings* readings);
};

}  // namespace pastoso::main
