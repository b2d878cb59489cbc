// Makes the picture of parts of a canvas, as a look shows it.
#pragma once

#include "core/thread_pool.hpp"
#include "screen/canvas_sheet.hpp"
#include "screen/quality.hpp"
#include "screen/raster_scene.hpp"
#include "shade/cell_layers.hpp"

#include <QImage>

namespace pastoso::screen {

/// Parts of one sheet.
class SheetPainter {
  public:
    /// `scale_top_mm` is of Look::Height. The layers are those below all parts; none: of every part they
    /// are made anew. All of them outlive the painter.
    SheetPainter(const RasterScene& scene, const document::Snapshot& seen, const CanvasSheet& sheet,
                 double scale_top_mm, Quality quality, const shade::CellLayers& layers,
                 core::ThreadPool& pool);

    /// In 16 bits, encoded.
    QImage paint(const grid::Rect& pixels) const;

    /// Of Look::Lit and Look::Flat, within the gamut.
    pigment::LinearImage light(const grid::Rect& pixels) const;

  private:
    const document::Snapshot& seen_;
    const CanvasSheet& sheet_;
    Look look_;
    double scale_top_mm_;
    pigment::WorkingSpace space_;
    core::ThreadPool& pool_;
    shade::Renderer renderer_;
};

/// The first draft of a huge canvas from far away: its colours in that light, without any relief, which
/// would be found for thousands of cells a pixel.
QImage flat_picture(const RasterScene& scene, const document::Snapshot& seen, const CanvasSheet& sheet,
                    const grid::Rect& pixels, core::ThreadPool& pool);

}  // namespace pastoso::screen
