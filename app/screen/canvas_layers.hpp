// The layers of shade/cell_layers.hpp as the shader's textures hold them, brought up to date with as
// little work as a change of the paint or of the light asks for.
#pragma once

#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "screen/page_layout.hpp"
#include "shade/render.hpp"
#include "shade/surface.hpp"
#include "shade/tile_colour.hpp"

#include <vector>

#include <QRegion>

namespace pastoso::screen {

struct SurfaceTexel {
    float height_mm = 0.0F;  ///< B-spline coefficient
    float shadow_mm = 0.0F;
    float sky = 1.0F;
};

struct SurfacePatch {
    grid::Rect cells;
    std::vector<SurfaceTexel> texels;  ///< row by row
};

struct ColourPatch {
    grid::Rect cells;
    std::vector<shade::CellColour> colours;  ///< row by row
};

/// The cells of a tile, with the border where it lies at the canvas's edge.
grid::Rect tile_with_border(const grid::Shape& shape, int tile);

/// What an update changed, in cells of the canvas (border cells have negative or too large numbers).
struct LayerChanges {
    QRegion surface;
    std::vector<ColourPatch> colours;
    std::vector<int> tiles;  ///< whose paint it is
};

/// The tiles whose picture may differ between two snapshots of one canvas. Tiles that share their
/// storage are equal, so this looks at handles alone. All tiles when `shown` is null.
std::vector<int> changed_tiles(const document::Snapshot* shown, const document::Snapshot& next);

/// The cells whose relief, sky or shadow may be another where the paint of these tiles is: they and the
/// cells around them that the prefilter, the sky's share and the shadows reach. `range` holds all
/// heights before and after; so many cells `beyond` the canvas belong to it, too.
QRegion relief_region(const film::FilmState& film, const std::vector<int>& tiles,
                      const shade::Lighting& lighting, const shade::HeightRange& range, int beyond);

class CanvasLayers {
  public:
    /// Makes the layers those of `next`, given that they are those of `shown` (null: of nothing).
    LayerChanges update(const document::Snapshot* shown, const document::Snapshot& next,
                        const shade::Lighting& lighting, core::ThreadPool& pool,
                        const pigment::BandsToRgb& to_rgb = pigment::kBandsToLinearSrgb);

    /// Makes the shadows those of another light.
    void relight(const document::Snapshot& shown, const shade::Lighting& lighting,
                 core::ThreadPool& pool);

    /// All colours as they are seen in another light; relief and shadows stay.
    static std::vector<ColourPatch> recolour(const document::Snapshot& shown,
                                             const pigment::BandsToRgb& to_rgb, core::ThreadPool& pool);

    /// Row by row, the border included; `stride` texels from row to row.
    const SurfaceTexel* surface(int x, int y) const { return surface_.data() + index(x, y); }
    int stride() const { return shape_.width + 2 * kLayerBorder; }
    grid::Rect cells_with_border() const;

    /// Copies of these cells, in pieces that are quickly put onto a graphics card.
    std::vector<SurfacePatch> patches(const QRegion& cells) const;

  private:
    std::ptrdiff_t index(int x, int y) const {
        return static_cast<std::ptrdiff_t>(y + kLayerBorder) * stride() + (x + kLayerBorder);
    }
    void reset(const grid::Shape& shape);
    void fill_surface(const film::FilmState& film, const grid::Rect& cells);
    void fill_shadow(const film::FilmState& film, const grid::Rect& cells,
                     const shade::Lighting& lighting);

    grid::Shape shape_;
    shade::TileRanges ranges_;
    shade::HeightRange range_;
    std::vector<SurfaceTexel> surface_;
};

}  // namespace pastoso::screen
