// Pictures put onto the canvas as layers of dry paint.
#pragma once

#include "main/files/loading.hpp"
#include "main/studio.hpp"
#include "pigment/image.hpp"

#include <QObject>

namespace pastoso::main {

class PictureLayers : public QObject {
    Q_OBJECT
  public:
    PictureLayers(Studio& studio, Loading& loading);

    /// Reads pictures beside the window and puts each onto the canvas as a layer of dry paint, in the
    /// middle and as large as it fits, above the one before. All are one undo step.
    void paint_pictures(const QStringList& paths);

    /// The same of one that is in memory, as a layer of that name.
    void paint_picture(pigment::Picture picture, const QString& name);

  private:
    void ask_paint_picture();

    Studio& studio_;
    Loading& loading_;
};

}  // namespace pastoso::main
