// A piece of a texture as it looks, for dialogs.
#pragma once

#include "layers/texture/texture.hpp"

#include <QImage>
#include <QSize>

namespace pastoso::dialogs {

/// White paste lit low from the upper left, `px_per_mm` pixels a millimetre.
QImage texture_picture(const layers::Texture& texture, const QSize& size_px, double px_per_mm);

}  // namespace pastoso::dialogs
