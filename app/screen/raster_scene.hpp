// What a window's picture shows that the processor makes.
#pragma once

#include "appearance/screen_colours.hpp"
#include "screen/canvas_presenter.hpp"
#include "screen/view_transform.hpp"

#include <QSize>

namespace pastoso::screen {

struct RasterScene {
    Sight sight;
    ViewTransform view;
    QSize window_px;
    Rgb ground{};                      ///< around the canvas, encoded
    appearance::ScreenCube colours{};  ///< that the canvas is shown through
    double squint_px = 0.0;            ///< the blur of half-closed eyes (squint.hpp); 0: they are open
    friend bool operator==(const RasterScene&, const RasterScene&) = default;
};

/// Whether nothing but the paint and the colours of the screen are others.
bool same_place(const RasterScene& a, RasterScene b);

/// The same, but seen from where it may.
bool same_but_for_view(const RasterScene& a, RasterScene b);

/// Whether unchanged paint has the same picture, wherever it is seen from.
bool same_light(const Sight& a, Sight b);

}  // namespace pastoso::screen
