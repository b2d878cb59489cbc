#include "screen/raster_scene.hpp"

namespace pastoso::screen {

bool same_place(const RasterScene& a, RasterScene b) {
    b.sight.painting = a.sight.painting;
    b.colours = a.colours;
    b.squint_px = a.squint_px;
    return a == b;
}

bool same_but_for_view(const RasterScene& a, RasterScene b) {
    b.view = a.view;
    return same_place(a, b);
}

bool same_light(const Sight& a, Sight b) {
    b.painting = a.painting;
    b.tracing = a.tracing;
    return a == b;
}

}  // namespace pastoso::screen
