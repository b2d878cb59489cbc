// The layers of shade/outline_layers.hpp as the shader's textures hold them. Only an enlarged picture
// draws outlines, so they are told when it is first looked at, and where it is.
#pragma once

#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "pigment/colour.hpp"

#include <vector>

#include <QRegion>

namespace pastoso::screen {

struct OutlineTexel {
    float cover = -0.5F;  ///< shade::OutlineCells
    float share = 0.0F;
    float support_mm = 0.0F;  ///< B-spline coefficient of what is dry
    float near = 0.0F;        ///< 1 where samples that begin here are near an outline
};

/// The colour of what lies dry.
struct DryTexel {
    float red = 0.0F, green = 0.0F, blue = 0.0F;
    float sharp = 0.0F;  ///< shade::edge_sharpness() times share
};

struct OutlinePatch {
    grid::Rect cells;
    std::vector<OutlineTexel> outline;  ///< row by row
    std::vector<DryTexel> dry;
};

/// Patches are squares of so many cells, from the border's first on, or less at the far edges.
inline constexpr int kOutlinePatch = 64;

/// The cells whose outlines the paint of a tile has a part in.
grid::Rect outlined_by(const grid::Shape& shape, int tile);

class CanvasOutlines {
  public:
    /// Nothing is known of a canvas.
    void reset(const grid::Shape& shape);

    /// The paint of these tiles is another.
    void forget(const std::vector<int>& tiles);

    /// All colours are others.
    void forget_all();

    /// Tells what is not known yet of these cells and the border around them.
    std::vector<OutlinePatch> update(const document::Snapshot& shown, const grid::Rect& cells,
                                     const pigment::BandsToRgb& to_rgb, core::ThreadPool& pool);

  private:
    grid::Shape shape_;
    QRegion unknown_;  ///< cells of the canvas and its border
};

}  // namespace pastoso::screen
