// The tiles of a surface put together to parts of a file, as bytes that are to be packed.
#pragma once

#include "core/message.hpp"
#include "recordings/surface_index.hpp"
#include "recordings/tile_kinds.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace pastoso::recordings {

/// Tiles are put together up to this size, so that a few threads share the work evenly.
inline constexpr std::size_t kEntryBytes = std::size_t{4} << 20;

const TileKind& kind_of(const TileEntry& entry);

/// What there is of a surface, in parts named "FOLDERkind-000.zst" ...; the packed sizes are still 0.
std::vector<TileEntry> tile_entries(const SurfaceSource& source, const std::string& folder);

/// Writes entry.packed.size bytes.
void encode_tiles(const SurfaceSource& source, const TileEntry& entry, std::span<std::byte> out);

/// The tiles of one kind in all entries, in ascending order.
std::vector<int> tiles_of_kind(const std::vector<TileEntry>& entries, const std::string& kind);

/// The surface, whose film has its shape, ready for the tiles of these entries.
SurfaceTarget target_of(const std::vector<TileEntry>& entries, document::SurfaceState& surface);

/// Puts the tiles of an entry into the surface, those of phase 0 (TileKind) first. `content` is as long
/// as the entry says. Returns what is wrong, as a sentence; empty when nothing is.
core::Message decode_tiles(std::span<const std::byte> content, const TileEntry& entry,
                           SurfaceTarget& target);

/// What is wrong with a film whose tiles have all been read: where a lower stratum is no part of its
/// cell's paint, or media are more than there is paint. Empty when nothing is.
core::Message fault_between_tiles(const film::FilmState& film);

}  // namespace pastoso::recordings
