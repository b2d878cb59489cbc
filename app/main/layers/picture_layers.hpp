// Pictures put onto the canvas as layers of dry paint.
#pragma once

#include "main/studio.hpp"
#include "pigment/image.hpp"

#include <QObject>

namespace pastoso::main {

class PictureLayers : public QObject {
    Q_OBJECT
  public:
    explicit PictureLayers(Studio& studio);

    /// Puts a picture onto the canvas as a layer of dry paint, in the middle and as large as it fits.
    /// Throws core::InputError when it is none.
    void paint_picture(const QString& path);

    /// The same of one that is in memory, as a layer of that name.
    void paint_picture(pigment::Picture picture, const QString& name);

  private:
    void ask_paint_picture();

    Studio& studio_;
};

}  // namespace pastoso::main
