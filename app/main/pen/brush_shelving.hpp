// The tools as the painter has put them, found again at the next start.
#pragma once

#include "main/program/remembered_file.hpp"
#include "main/studio.hpp"
#include "tools/brush_shelf.hpp"

#include <vector>

#include <QObject>

namespace pastoso::panels {
class BrushPanel;
struct BrushChoice;
}

namespace pastoso::main {

class BrushJar;

class BrushShelving : public QObject {
    Q_OBJECT
  public:
    BrushShelving(Studio& studio, const BrushJar& jar, panels::BrushPanel* brushes);

    /// A file that cannot be read is told, and left as it is.
    void recall();
    void remember();

    /// A tag of blanks is told.
    void set_tag(const QString& tool, const QString& tag, bool tagged);

    const std::vector<tools::BrushTag>& tags() const { return shelf_.tags; }
    /// Gives tools these tags besides those that they have.
    void add_tags(const std::vector<tools::BrushTag>& tags);

  private:
    void note(const tools::Hand& hand);
    void set_favourite(bool favourite);
    void arrange(const panels::BrushChoice& choice, const QStringList& shown);
    void ask_tag(const QString& tool);
    void show();

    Studio& studio_;
    panels::BrushPanel* brushes_;
    tools::BrushShelf shelf_;
    RememberedFile file_;
};

}  // namespace pastoso::main
