// The tubes in the painter's order and the sets of them, found again at the next start, and squeezed out
// together.
#pragma once

#include "main/program/remembered_file.hpp"
#include "main/studio.hpp"
#include "tools/tube_rack.hpp"

#include <functional>
#include <optional>
#include <vector>

#include <QObject>

namespace pastoso::panels {
class PaintPanel;
}

namespace pastoso::main {

class TubeCommands : public QObject {
    Q_OBJECT
  public:
    TubeCommands(Studio& studio, panels::PaintPanel* tubes);

    /// A file that cannot be read is told, and left as it is.
    void recall();
    void remember();
    /// The paints and mixtures on the well, for the next painting.
    void remember_palette();

    /// Makes a set of the tubes that are shown. A name of blanks is told.
    void save_set(const QString& name);

    /// Gives the set that is shown another name. One that cannot be is told.
    void rename_set(const QString& name);

    /// Writes all sets to a file, and adds those of such a file. What goes wrong is told.
    void export_sets(const QString& path);
    void import_sets(const QString& path);

  private:
    void ask_export();
    void ask_import();
    std::optional<QString> asked_name(const QString& title, const QString& name);
    void change(const std::function<void(tools::TubeRack&)>& work);
    std::vector<document::Puddle> puddles() const;
    void squeeze_out(const tools::WellPalette& palette);
    void squeeze_set();
    void squeeze_last_palette();
    void show();

    Studio& studio_;
    panels::PaintPanel* panel_;
    tools::Tubes all_;  ///< as they ship
    tools::TubeRack rack_;
    RememberedFile file_;
    RememberedFile palette_file_;  ///< of the paints on the last well
};

}  // namespace pastoso::main
