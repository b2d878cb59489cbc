// Tools of the painter's own written into a bundle with their tags, and those of a bundle added to them.
#pragma once

#include "main/studio.hpp"

#include <QObject>

namespace pastoso::main {

class BrushJar;
class BrushShelving;

class BrushBundles : public QObject {
    Q_OBJECT
  public:
    BrushBundles(Studio& studio, BrushJar& jar, BrushShelving& shelf);

    /// A file with anything wrong in it is told, and nothing of it is added.
    void import_from(const QString& path);
    void export_to(const QString& path);

  private:
    void ask_import();
    void ask_export();

    Studio& studio_;
    BrushJar& jar_;
    BrushShelving& shelf_;
};

}  // namespace pastoso::main
