// Wet paint poured out, evenly or as a relief, as a layer apart from what it lies on.
#pragma once

#include "core/thread_pool.hpp"
#include "film/medium.hpp"
#include "film/state.hpp"
#include "grid/mask.hpp"
#include "grid/tiled_field.hpp"

#include <cstdint>
#include <optional>

namespace pastoso::layers {

/// From one paint to another along a line, of the same medium: before the line, across it, all is of the
/// first, beyond it of the second, and between them the share of the second grows evenly.
struct Gradient {
    film::PaintCoefficients second{};
    grid::Point from, to;  ///< in cells, apart
};

struct PouredPaint {
    film::Medium medium;
    film::PaintCoefficients paint{};
    double thickness_mm = 0.2;  ///< up to film::kMaxThickness_mm
    std::optional<Gradient> gradient{};
    /// Quanta of each cell, in place of the one thickness; null: that one. Outlives the pouring.
    const grid::TiledField<std::int32_t>* relief = nullptr;
};

/// The thickness in every cell of the mask, in whole quanta; null: of the whole canvas. What a cell
/// carries are the quanta nearest to what so much of its paint does.
film::FilmState poured_film(const PouredPaint& poured, grid::Shape shape, double cell_mm,
                            const grid::Mask* where, core::ThreadPool& pool);

}  // namespace pastoso::layers
