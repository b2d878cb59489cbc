// One value per cell of a canvas, in tiles that are allocated when first written and shared between copies.
#pragma once

#include <vector>

#include "core/check.hpp"
#include "grid/tile_block.hpp"

namespace pastoso::grid {

/// Copying a field costs one reference per tile: a copy is a snapshot. Tiles never written hold the
/// background value and cost nothing. One thread may write a field; others work on copies.
template <class T>
class TiledField {
  public:
    TiledField() = default;
    explicit TiledField(Shape shape, const T& background = T{})
        : shape_(shape), background_(TileBlock<T>::filled(background)), tiles_(shape.tile_count(), background_) {}

    const Shape& shape() const { return shape_; }
    int tile_count() const { return static_cast<int>(tiles_.size()); }

    /// The 64 x 64 values of a tile, those beyond the canvas included.
    const T* read(int tile) const { return tiles_[tile].read(); }

    /// The same for writing; other fields that share the tile keep the old values.
    T* write(int tile) {
        TileBlock<T>& block = tiles_[tile];
        if (!block.unique()) block = TileBlock<T>::copy_of(block.read());
        return block.write();
    }

    const T& at(int x, int y) const {
        PASTOSO_CHECK(shape_.contains(x, y));
        return read(shape_.tile_at(x, y))[Shape::cell_in_tile(x, y)];
    }
    void set(int x, int y, const T& value) {
        PASTOSO_CHECK(shape_.contains(x, y));
        write(shape_.tile_at(x, y))[Shape::cell_in_tile(x, y)] = value;
    }

    const TileBlock<T>& block(int tile) const { return tiles_[tile]; }
    void replace(int tile, TileBlock<T> block) { tiles_[tile] = std::move(block); }

    /// True when the tile was never written (or was reset): all its values are the background's.
    bool is_background(int tile) const { return tiles_[tile] == background_; }
    void reset(int tile) { tiles_[tile] = background_; }

    /// True when both fields hold the same storage for this tile, which makes their values equal.
    bool shares_tile(const TiledField& other, int tile) const { return tiles_[tile] == other.tiles_[tile]; }

    /// Bytes of tile storage that this field holds, shared tiles counted in full.
    std::size_t allocated_bytes() const {
        std::size_t count = 0;
        for (int tile = 0; tile < tile_count(); ++tile) count += is_background(tile) ? 0 : 1;
        return count * sizeof(T) * kTileCells;
    }

  private:
    Shape shape_;
    TileBlock<T> background_;
    std::vector<TileBlock<T>> tiles_;
};

}  // namespace pastoso::grid
