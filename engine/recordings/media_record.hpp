// The media of a surface's or a brush's paint as a project file tells them.
#pragma once

#include "brush/brush.hpp"
#include "files/json_place.hpp"
#include "film/state.hpp"

namespace pastoso::recordings {

/// What a file's index tells of a surface's media; which of them is in each cell, its tiles tell.
struct MediaIndex {
    std::vector<film::FilmNumbers> numbers{};
    std::vector<std::uint8_t> own{};  ///< of each tile; none where all are of the first
};
MediaIndex media_index(const film::WetMedia& media);
/// Nothing where the index tells of none, as formats before 9 do.
void set_media(const MediaIndex& index, film::FilmState& film);

files::Json media_json(const MediaIndex& index);
/// Of a surface of so many tiles.
MediaIndex read_media(const files::JsonPlace& place, int tile_count);

files::Json held_media_json(const brush::HeldMedia& media);
brush::HeldMedia read_held_media(const files::JsonPlace& place);

/// Whether no cell holds more of all media, or of one that nobody tells of, than it holds paint.
bool are_possible(const film::WetMedia& media, const grid::TiledField<std::int32_t>& thickness);

}  // namespace pastoso::recordings
