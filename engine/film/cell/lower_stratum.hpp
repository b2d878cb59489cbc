// Wet paint below wet paint: the lower of two strata within a cell (docs/decisions/0056-two-wet-strata.md).
//
// FilmState::thickness and paint are the whole of a cell; what is told here is the part of it that lies
// below other paint. The upper stratum is the difference. So whoever does not care about the order of
// paints may look at the whole alone, what is laid on top changes the whole alone, and forgetting a lower
// stratum mixes the cell, exactly.
#pragma once

#include "film/cell/paint_cell.hpp"
#include "grid/tiled_field.hpp"

#include <cstdint>

namespace pastoso::film {

struct FilmState;

/// Thinner strata are not kept apart, quanta (0.5 um).
inline constexpr std::int32_t kLeastStratum_quanta = 1 << 14;

/// Thinner ones do not even begin, nor are they carried on (0.03 um).
inline constexpr std::int32_t kLostStratum_quanta = 1 << 10;

/// Paints that differ by less than this share of the more, in every channel of colour, look alike.
inline constexpr float kLikeShare = 0.1F;

/// An optical thickness K h or S h, in all of a cell, that changes no colour.
inline constexpr double kNoColour = 0.002;

/// The tiles are there only where a cell has two strata. Of a cell, with h and a its whole thickness and
/// amounts: 0 <= thickness < h and 0 <= paint <= a in every channel; both 0 where its paint is one.
struct LowerStratum {
    LowerStratum() = default;
    explicit LowerStratum(grid::Shape canvas) : thickness(canvas), paint(canvas) {}

    bool is_in(int tile) const { return !thickness.is_background(tile); }
    bool holds_any(int tile) const;
    void forget(int tile);
    /// Sets a tile, to nothing unless one of its cells has a lower stratum.
    void replace(int tile, grid::TileBlock<std::int32_t> tile_thickness,
                 grid::TileBlock<PaintCell> tile_paint);

    grid::TiledField<std::int32_t> thickness;  ///< h_l, quanta
    grid::TiledField<PaintCell> paint;         ///< what it carries
};

/// That of one cell.
struct LowerCell {
    std::int32_t thickness = 0;
    PaintCell paint{};
};

/// Whether it can be a part of a cell: the bounds above.
bool is_part_of(const LowerCell& lower, std::int32_t thickness, const PaintCell& paint);

/// Whether nobody sees that a cell has two strata: one is thinner than kLeastStratum_quanta, or what
/// they are made of looks alike.
bool looks_like_one(const LowerCell& lower, std::int32_t thickness, const PaintCell& paint);

/// The rest of a cell's paint.
PaintCell upper_paint(const PaintCell& lower, const PaintCell& whole);

/// A tile's lower stratum, for writing. There is none, and no memory for it, before a cell is set.
class LowerTile {
  public:
    LowerTile() = default;
    LowerTile(const LowerStratum& from, int tile);

    bool any() const { return static_cast<bool>(thickness_); }
    LowerCell at(int cell) const;
    void set(int cell, const LowerCell& lower);
    void clear(int cell);

    /// The tile may have come to nothing.
    void put_into(LowerStratum& stratum, int tile);

  private:
    grid::TileBlock<std::int32_t> thickness_;
    grid::TileBlock<PaintCell> paint_;
};

/// Lets the cells of a tile that look like one be one. True when something changed.
bool join_like_strata(FilmState& state, int tile);

}  // namespace pastoso::film
