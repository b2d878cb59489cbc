// Pens and mouse as the painter has set them up: their dialog, their other end, found again at the next
// start.
#pragma once

#include "main/program/remembered_file.hpp"
#include "main/studio.hpp"
#include "tools/eraser_end.hpp"
#include "tools/pen_settings.hpp"

#include <QObject>

namespace pastoso::panels {
class PenDialog;
}

namespace pastoso::main {

class PenCommands : public QObject {
    Q_OBJECT
  public:
    explicit PenCommands(Studio& studio);

    /// A file that cannot be read is told, and left as it is.
    void recall();

  private:
    void show_dialog();
    void use(const tools::PenSettings& settings);
    void remember();
    void turn_pen(bool eraser_end);
    void turn_wheel(int notches);
    void give(const QString& name);
    void tap(int fingers);

    Studio& studio_;
    tools::PenSettings settings_;
    tools::EraserEnd eraser_;
    panels::PenDialog* dialog_ = nullptr;
    RememberedFile file_;
};

}  // namespace pastoso::main
