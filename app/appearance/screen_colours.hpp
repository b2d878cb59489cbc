// The colours of paint as the screen is to be given them. Canvas, swatches and small pictures go through
// it where they are painted; the theme's greys, icons and lines over a canvas do not.
#pragma once

#include "pigment/colour_cube.hpp"

#include <memory>

#include <QColor>
#include <QImage>
#include <QObject>
#include <QPixmap>

namespace pastoso::appearance {

using ScreenCube = std::shared_ptr<const pigment::ColourCube>;

class ScreenColours : public QObject {
    Q_OBJECT
  public:
    /// From the window's thread, as all calls. All widgets are painted anew.
    void use(ScreenCube cube, ScreenCube of_painting);

    /// Null where colours are shown as they are.
    const ScreenCube& cube() const { return cube_; }

    /// What a painting is shown through, where it is painted and looked at.
    const ScreenCube& of_painting() const { return of_painting_; }

    /// Whether canvases are seen as with half-closed eyes (screen/squint.hpp). All widgets are painted
    /// anew.
    void squint(bool squints);
    bool squints() const { return squints_; }

  Q_SIGNALS:
    void changed();

  private:
    void tell();

    ScreenCube cube_, of_painting_;
    bool squints_ = false;
};

/// Those of the program.
ScreenColours& screen_colours();

/// What is to be painted for a colour, or for a picture of at most 8 bits a channel.
QColor shown(const QColor& colour);
QImage shown(const QImage& picture);
QPixmap shown(const QPixmap& picture);

/// The same by a cube that was asked for before; on any thread. Null: as it is.
QImage shown_through(const ScreenCube& cube, const QImage& picture);

/// The same in a painting.
QColor shown_in_painting(const QColor& colour);
QImage shown_in_painting(const QImage& picture);

}  // namespace pastoso::appearance
