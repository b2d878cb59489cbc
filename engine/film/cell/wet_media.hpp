// Which media the wet paint of a canvas is of, where it is of several
// (docs/decisions/0072-paint-keeps-its-medium.md).
#pragma once

#include "film/cell/film_numbers.hpp"
#include "film/cell/paint_cell.hpp"
#include "grid/tiled_field.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::film {

struct FilmState;

/// So many at a time; when more come, the two that are most alike become one.
inline constexpr int kMostMedia = kPaintChannels;

/// How much of a cell's paint is of each medium, thickness quanta.
using MediaCell = PaintCell;

/// A tile has a medium of its own, and where there is other paint as well, its cells tell how much of
/// each: what they don't tell is of the tile's own. So a film of one medium costs nothing.
struct WetMedia {
    WetMedia() = default;
    explicit WetMedia(grid::Shape canvas) : own(canvas.tile_count(), 0), foreign(canvas) {}

    bool are_several() const { return numbers.size() > 1; }
    bool is_mixed(int tile) const { return !foreign.is_background(tile); }
    /// All paint is of this medium from now on.
    void become_one(const FilmNumbers& medium);
    /// Sets what is foreign in a tile, to nothing where no cell has any.
    void replace(int tile, grid::TileBlock<MediaCell> cells);

    std::vector<FilmNumbers> numbers;     ///< at most kMostMedia; none: all is of the solver's medium
    std::vector<std::uint8_t> own;        ///< of each tile, its index in `numbers`
    grid::TiledField<MediaCell> foreign;  ///< 0 in the tile's own channel and those of no medium
};

/// The index of a medium among those of the film, which it may be new to.
int add_medium(FilmState& state, const FilmNumbers& medium);

/// All that a cell of this thickness holds, by the media's places: its foreign media, and of the tile's
/// own the rest.
MediaCell all_media(const MediaCell& foreign, int own, std::int32_t thickness);
MediaCell media_in(const FilmState& state, int tile, int cell);

/// Says what the cells of a tile hold, all media told: the one of which there is most is the tile's own.
void set_media(FilmState& state, int tile, grid::TileBlock<MediaCell> amounts);

/// Keeps the shares in cells of a tile whose thickness, `before`, has changed by itself.
void keep_media_shares(FilmState& state, int tile, const std::int32_t* before);

/// Where the media of one film stand in another one, which may be new to them.
std::vector<int> places_of_media(const FilmState& from, FilmState& to);
/// Amounts by the places of one film by those of another one.
MediaCell at_places(const MediaCell& amounts, const std::vector<int>& places);

/// Makes the media of a tile those of the same tile in a film of the same shape.
void take_media(const FilmState& from, int tile, FilmState& to);

/// A number of what a cell holds: the mean over its media, by volume; of no paint that of the tile's
/// own.
double mixed_number(const FilmState& state, int tile, int cell, double FilmNumbers::*number);

/// Forgets traces of less than a 16384th of a cell's paint in a tile; if then all of its paint is of one
/// medium, that is the tile's own.
void settle_media(FilmState& state, int tile);

}  // namespace pastoso::film
