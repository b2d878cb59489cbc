// What a stroke found on the canvas before it touched it: a tool that reads the canvas must not take
// what it has just written for paint that was there.
#pragma once

#include "brush/gather_kernel.hpp"
#include "grid/tiled_field.hpp"

#include <cstdint>

namespace pastoso::brush {

/// What a pass has found in the cells of a tile.
struct FoundTile {
    const float* begun_mm = nullptr;
    const std::int32_t* found = nullptr;
    float expired_mm = 0.0F;  ///< who came before is gone

    /// Quanta in a cell: `thickness`, what lies there now, where no pass has begun.
    std::int32_t at(int cell, std::int32_t thickness) const {
        return begun_mm[cell] >= expired_mm ? found_thickness(found[cell]) : thickness;
    }
};

/// Every cell's thickness when the tip reached it on its present pass. A pass over a cell lasts for
/// `length_mm` of travel from the first touch, as long as a tip needs to pass; who comes again later
/// finds what lies there then. Holds no paint.
class PassMap {
  public:
    PassMap(grid::Shape canvas, double length_mm)
        : begun_mm_(canvas, kNever), found_(canvas), length_mm_(static_cast<float>(length_mm)) {}

    /// Where the tip is from now on, in travel since the stroke began.
    void set_travel(double travel_mm) { travel_mm_ = static_cast<float>(travel_mm); }

    /// Lets several threads gather these cells at once, as long as none gathers those of another.
    void prepare(const grid::Rect& cells) {
        const grid::Shape& canvas = found_.shape();
        const grid::Rect tiles = canvas.tiles_touching(cells);
        for (int row = tiles.y0; row < tiles.y1; ++row) {
            for (int column = tiles.x0; column < tiles.x1; ++column)
                tile(row * canvas.tiles_x() + column);
        }
    }

    /// What a gathering of cells of a tile reads and, where the tip comes anew, writes.
    PassTile tile(int tile) {
        return {begun_mm_.write(tile), found_.write(tile), travel_mm_, travel_mm_ - length_mm_};
    }

    /// What the tip found in a tile so far.
    FoundTile read(int tile) const {
        return {begun_mm_.read(tile), found_.read(tile), travel_mm_ - length_mm_};
    }

  private:
    static constexpr float kNever = -1e9F;
    grid::TiledField<float> begun_mm_;
    grid::TiledField<std::int32_t> found_;
    float length_mm_, travel_mm_ = 0.0F;
};

}  // namespace pastoso::brush
