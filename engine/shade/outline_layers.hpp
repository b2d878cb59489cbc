// What an outline is drawn from, beside the layers of the picture (cell_layers.hpp).
#pragma once

#include "core/thread_pool.hpp"
#include "shade/cell_layers.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::shade {

/// Values of the cells of a rectangle, row by row.
struct OutlineLayers {
    OutlineLayers() = default;
    /// Room for all but `covered`.
    explicit OutlineLayers(const grid::Rect& cells);

    grid::Rect cells;
    std::vector<float> share, cover;  ///< OutlineCells
    std::vector<std::uint8_t> near;   ///< the same
    std::vector<float> sharp;         ///< edge_sharpness() times share
    std::vector<float> support_mm;    ///< B-spline coefficients of what is dry
    std::vector<CellColour> covered;  ///< the cell's colour times its share
    std::vector<CellColour> dry;      ///< the colour of what lies dry

    /// The four rows that begin with number `first_row` of the rectangle.
    OutlineRows rows_from(int first_row) const;
};

/// Sets all but `covered` for a part of the cells.
void tell_outline(const film::FilmState& film, const pigment::Bands& ground, const grid::Rect& part,
                  const pigment::BandsToRgb& to_rgb, OutlineLayers& outline);

/// Of the cells of `layers`, which are the film's.
OutlineLayers outline_layers(const film::FilmState& film, const pigment::Bands& ground,
                             const CellLayers& layers, core::ThreadPool& pool,
                             const pigment::BandsToRgb& to_rgb = pigment::kBandsToLinearSrgb);

}  // namespace pastoso::shade
