// The five layers of cell values that a picture is made from; the window keeps the same as textures.
#pragma once

#include "core/thread_pool.hpp"
#include "shade/render.hpp"
#include "shade/sampling.hpp"
#include "shade/surface.hpp"
#include "shade/tile_colour.hpp"

#include <vector>

namespace pastoso::shade {

/// Values of the cells of a rectangle, row by row.
struct CellLayers {
    CellLayers() = default;
    explicit CellLayers(const grid::Rect& cells);

    grid::Rect cells;
    std::vector<float> height_mm;  ///< B-spline coefficients, surface.hpp
    std::vector<float> shadow_mm;  ///< shadow.hpp
    std::vector<float> sky;        ///< sky.hpp
    std::vector<CellColour> colour;

    /// Where the layers hold cell (x, y) of the canvas.
    std::ptrdiff_t index(int x, int y) const {
        return static_cast<std::ptrdiff_t>(y - cells.y0) * cells.width() + (x - cells.x0);
    }

    /// The four rows that begin with number `first_row` of the rectangle.
    LayerRows rows_from(int first_row) const;
};

/// Stretches of rows that together make up the rectangle, for the threads.
std::vector<grid::Rect> bands_of(const grid::Rect& cells);

/// Beyond the canvas a picture of it may need the layers of so many cells.
inline constexpr int kLayersAround = 8;

/// Makes these parts of the layers anew. `range` is that of the whole canvas.
void fill_layers(const film::FilmState& film, const pigment::Bands& ground,
                 const std::vector<grid::Rect>& parts, const Lighting& lighting,
                 const HeightRange& range, core::ThreadPool& pool, const pigment::BandsToRgb& to_rgb,
                 CellLayers& layers);

/// The layers of some of their cells.
CellLayers part_of(const CellLayers& layers, const grid::Rect& cells);

/// `range` is that of the whole canvas.
CellLayers cell_layers(const film::FilmState& film, const pigment::Bands& ground,
                       const grid::Rect& cells, const Lighting& lighting, const HeightRange& range,
                       core::ThreadPool& pool,
                       const pigment::BandsToRgb& to_rgb = pigment::kBandsToLinearSrgb);
CellLayers cell_layers(const film::FilmState& film, const pigment::Bands& ground,
                       const grid::Rect& cells, const Lighting& lighting, core::ThreadPool& pool,
                       const pigment::BandsToRgb& to_rgb = pigment::kBandsToLinearSrgb);

}  // namespace pastoso::shade
