// What a stroke found on the canvas before it touched it: a tool that reads the canvas must not take
// what it has just written for paint that was there.
#pragma once

#include "grid/tiled_field.hpp"

#include <cstdint>

namespace pastoso::brush {

/// Every cell's thickness when the tip reached it on its present pass. A pass over a cell lasts for
/// `length_mm` of travel from the first touch, as long as a tip needs to pass; who comes again later
/// finds what lies there then. Holds no paint.
class PassMap {
  public:
    PassMap(grid::Shape canvas, double length_mm)
        : begun_mm_(canvas, kNever), found_(canvas), length_mm_(static_cast<float>(length_mm)) {}

    /// Where the tip is from now on, in travel since the stroke began.
    void set_travel(double travel_mm) { travel_mm_ = static_cast<float>(travel_mm); }

    /// Begins a pass over those of `count` neighbouring cells of a tile that are not being passed over,
    /// which hold `thickness`, and writes what was found in all of them, in quanta.
    void find(int tile, int first_cell, int count, const std::int32_t* thickness, std::int32_t* found) {
        float* begun = begun_mm_.write(tile) + first_cell;
        std::int32_t* kept = found_.write(tile) + first_cell;
        const float expired = travel_mm_ - length_mm_;
#pragma GCC ivdep  // the columns do not overlap
        for (int i = 0; i < count; ++i) {
            const bool anew = begun[i] < expired;
            begun[i] = anew ? travel_mm_ : begun[i];
            kept[i] = anew ? thickness[i] : kept[i];
            found[i] = kept[i];
        }
    }

  private:
    static constexpr float kNever = -1e9F;
    grid::TiledField<float> begun_mm_;
    grid::TiledField<std::int32_t> found_;
    float length_mm_, travel_mm_ = 0.0F;
};

}  // namespace pastoso::brush
