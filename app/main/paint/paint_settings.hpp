// The painter's own paints, found again at the next start, and palettes to choose from.
#pragma once

#include "main/program/remembered_file.hpp"
#include "main/studio.hpp"

#include <QObject>
#include <QTimer>

namespace pastoso::panels {
class ColourPanel;
}

namespace pastoso::main {

class PaintSettings : public QObject {
    Q_OBJECT
  public:
    PaintSettings(Studio& studio, panels::ColourPanel* colours);

    /// A file that cannot be read is told, and left as it is.
    void recall();
    /// What has changed since: another window may have kept other paints meanwhile.
    void remember();

    /// Shows the colours of a .gpl file to choose from. What is none is told.
    void open_palette(const QString& path);

  private:
    void write();
    void ask_palette();

    Studio& studio_;
    panels::ColourPanel* colours_;
    QTimer changed_;  ///< soon after the last of several changes
    RememberedFile file_;
};

}  // namespace pastoso::main
