// What a film differs in from one that came of it: the tiles that the two do not share, as they are or
// packed. With the newer film they give the older one back.
#pragma once

#include "film/state.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pastoso::document {

/// Tiles of one field.
template <class Block>
struct TileSet {
    std::vector<int> tiles;     ///< in ascending order
    std::vector<Block> blocks;  ///< none: the tile is background
};

/// What a film has besides its fields.
struct FilmSums {
    film::DriedTotals fixed{};
    std::int64_t evaporated = 0;
    film::Consistencies consistencies;
    std::vector<film::FilmNumbers> media{};
    std::vector<std::uint8_t> own_media{};  ///< of each tile
};

/// Named like the fields of a film.
struct FilmTiles {
    FilmTiles() = default;
    /// Both of one shape.
    FilmTiles(const film::FilmState& older, const film::FilmState& newer);

    /// Of the tiles' storage; it depends on the values alone.
    std::size_t bytes() const;
    /// Makes the older film of the newer one.
    void put_into(film::FilmState& film) const;

    TileSet<grid::TileBlock<std::int32_t>> thickness;
    TileSet<grid::TileBlock<film::PaintCell>> paint;
    struct {
        TileSet<grid::TileBlock<std::int32_t>> thickness;
        TileSet<grid::TileBlock<film::PaintCell>> paint;
    } lower;
    struct {
        TileSet<grid::TileBlock<std::int32_t>> thickness;
    } worked;
    struct {
        TileSet<grid::TileBlock<film::MediaCell>> foreign;
    } media;
    TileSet<grid::TileBlock<float>> velocity_x, velocity_y;
    TileSet<film::HeightBlock> support_mm;
    struct {
        TileSet<grid::TileBlock<std::int32_t>> soluble_thickness;
        TileSet<grid::TileBlock<film::PigmentCell>> soluble_pigment;
        TileSet<grid::TileBlock<film::StrataOptics>> optics;
        TileSet<grid::TileBlock<film::PigmentMixture>> uppermost;
    } strata;
    FilmSums sums;
};

/// The same, each tile a Zstandard frame of its own.
class PackedFilmTiles {
  public:
    PackedFilmTiles() = default;
    /// `older` is the film that the tiles are of. `rest` is called before each of them.
    PackedFilmTiles(
        const FilmTiles& tiles, const film::FilmState& older, const std::function<void()>& rest = [] {});

    /// Of the frames; it depends on the values alone.
    std::size_t bytes() const { return bytes_; }
    void put_into(film::FilmState& film) const;

  private:
    std::vector<TileSet<std::vector<std::byte>>> fields_;
    /// Heights in levels are mostly those of the bare support, which is kept anyway.
    TileSet<film::HeightBlock> levels_;
    std::size_t bytes_ = 0;
    FilmSums sums_;
};

}  // namespace pastoso::document
