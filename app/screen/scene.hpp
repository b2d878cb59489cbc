// What a frame shows, and from where.
#pragma once

#include "screen/canvas_textures.hpp"
#include "screen/view_transform.hpp"
#include "shade/render.hpp"

#include <QRegion>

namespace pastoso::screen {

struct Scene {
    CanvasTextures* canvas = nullptr;
    double cell_mm = 0.25;
    ViewTransform view;
    shade::Lighting lighting;
    Look look = Look::Lit;
    double scale_top_mm = 1.0;  ///< of Look::Height
    pigment::WorkingSpace space = pigment::WorkingSpace::Srgb;
    Rgb ground{};        ///< around the canvas, as the screen takes it
    QRegion outlines{};  ///< device pixels in which they are drawn
};

}  // namespace pastoso::screen
