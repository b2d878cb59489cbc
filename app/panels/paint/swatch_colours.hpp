// The colours of paint as Qt takes them.
#pragma once

#include "tools/swatch.hpp"

#include <QColor>

namespace pastoso::panels {

inline QColor qcolor(const pigment::Srgb8& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

/// Of a flat spot of the paint, a recipe or as a brush holds it, on the canvas.
template <class Paint>
QColor shown_colour(const Paint& paint, const tools::SwatchView& view) {
    return qcolor(tools::swatch_colour(paint, view));
}

}  // namespace pastoso::panels
