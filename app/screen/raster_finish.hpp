// Brings a canvas that the processor drew into the colours and levels of the screen, as kFinishShader
// does it.
#pragma once

#include "core/thread_pool.hpp"
#include "screen/raster_scene.hpp"

#include <QImage>
#include <QRect>

namespace pastoso::screen {

/// A part of the window, with the ground around the canvas. `canvas` has 16 bits a channel
/// (QImage::Format_RGBX64), `image` eight.
void finish_part(const QImage& canvas, const QRect& part, const RasterScene& scene,
                 core::ThreadPool& pool, QImage& image);

/// The whole window as with half-closed eyes (squint.hpp).
void finish_squinted(const QImage& canvas, const RasterScene& scene, core::ThreadPool& pool,
                     QImage& image);

}  // namespace pastoso::screen
