// What a frame shows, and from where.
#pragma once

#include "shade/render.hpp"
#include "view/canvas_textures.hpp"
#include "view/view_transform.hpp"

#include <QRegion>

namespace pastoso::view {

struct Scene {
    CanvasTextures* canvas = nullptr;
    double cell_mm = 0.25;
    ViewTransform view;
    shade::Lighting lighting;
    Look look = Look::Lit;
    double scale_top_mm = 1.0;  ///< of Look::Height
    pigment::WorkingSpace space = pigment::WorkingSpace::Srgb;
    Rgb ground{};  ///< around the canvas, as the screen takes it
    QRegion outlines{};  ///< device pixels in which they are drawn
};

}  // namespace pastoso::view
