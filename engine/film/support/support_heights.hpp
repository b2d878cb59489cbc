// The heights of a support, one per cell, in tiles that copies share: as levels of 16 bits where they
// were made, as floats where paint has dried on them.
#pragma once

#include "grid/tiled_field.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pastoso::film {

/// Every height of a support is a multiple of this: where the surface of the paint lies at such a height
/// too, its thickness is one as well, floats hold all three exactly up to 16 mm, and a lake at rest over
/// an uneven support stays exactly still.
inline constexpr double kSupportQuantum_mm = 0x1p-20;

/// The finest step, a power of two and a multiple of kSupportQuantum_mm, by which 16 bits reach a height
/// such as this.
double finest_level_mm(double highest_mm);

/// A tile's heights to read; one of the two pointers is null.
struct TileHeights {
    const float* heights_mm = nullptr;
    const std::uint16_t* levels = nullptr;  ///< in steps of level_mm
    float level_mm = 0.0F;

    float operator[](int cell) const {
        return heights_mm != nullptr ? heights_mm[cell] : static_cast<float>(levels[cell]) * level_mm;
    }
    /// The highest of some cells.
    template <class... Cells>
    float highest(Cells... cells) const {
        if (heights_mm != nullptr) return std::max({heights_mm[cells]...});
        return static_cast<float>(std::max({levels[cells]...})) * level_mm;
    }
    /// Copies `count` heights from `cell` on.
    void copy(int cell, int count, float* out_mm) const;
};

/// The storage of a tile's heights. Copies share it.
class HeightBlock {
  public:
    HeightBlock() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): floats are one of the two forms
    HeightBlock(grid::TileBlock<float> heights_mm) : heights_mm_(std::move(heights_mm)) {}
    HeightBlock(grid::TileBlock<std::uint16_t> levels, float level_mm)
        : levels_(std::move(levels)), level_mm_(level_mm) {}

    /// The same heights: in levels if whole steps of one size hold them, as floats otherwise.
    static HeightBlock smallest_of(grid::TileBlock<float> heights_mm);

    TileHeights read() const;
    bool in_levels() const { return static_cast<bool>(levels_); }
    explicit operator bool() const { return levels_ || heights_mm_; }
    std::size_t bytes() const;

    /// The heights as floats, for writing; who shares the storage keeps the old ones.
    float* write();
    friend bool operator==(const HeightBlock&, const HeightBlock&) = default;

  private:
    grid::TileBlock<float> heights_mm_;
    grid::TileBlock<std::uint16_t> levels_;
    float level_mm_ = 0.0F;
};

/// What TiledField is to other values; the background is the height 0.
class SupportHeights {
  public:
    SupportHeights() = default;
    explicit SupportHeights(grid::Shape shape)
        : shape_(shape),
          background_(grid::TileBlock<float>::filled(0.0F)),
          tiles_(static_cast<std::size_t>(shape.tile_count()), background_) {}

    const grid::Shape& shape() const { return shape_; }
    int tile_count() const { return static_cast<int>(tiles_.size()); }

    /// The 64 x 64 heights of a tile, those beyond the canvas included.
    TileHeights read(int tile) const { return tiles_[tile].read(); }
    float* write(int tile) { return tiles_[tile].write(); }

    float at(int x, int y) const {
        PASTOSO_CHECK(shape_.contains(x, y));
        return read(shape_.tile_at(x, y))[grid::Shape::cell_in_tile(x, y)];
    }
    void set(int x, int y, float height_mm) {
        PASTOSO_CHECK(shape_.contains(x, y));
        write(shape_.tile_at(x, y))[grid::Shape::cell_in_tile(x, y)] = height_mm;
    }

    const HeightBlock& block(int tile) const { return tiles_[tile]; }
    /// Different tiles may be replaced at the same time.
    void replace(int tile, HeightBlock block) { tiles_[tile] = std::move(block); }

    bool is_background(int tile) const { return tiles_[tile] == background_; }
    void reset(int tile) { tiles_[tile] = background_; }
    bool shares_tile(const SupportHeights& other, int tile) const {
        return tiles_[tile] == other.tiles_[tile];
    }

    /// Bytes of tile storage that this field holds, shared tiles counted in full.
    std::size_t allocated_bytes() const;

  private:
    grid::Shape shape_;
    HeightBlock background_;
    std::vector<HeightBlock> tiles_;
};

/// The heights of a tile as floats of its own, for a change.
grid::TileBlock<float> copied_heights(const TileHeights& tile);

}  // namespace pastoso::film
