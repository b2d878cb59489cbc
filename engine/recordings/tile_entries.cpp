#include "recordings/tile_entries.hpp"

#include <algorithm>
#include <cstdio>

namespace pastoso::recordings {
namespace {

std::string entry_name(const std::string& folder, const TileKind& kind, std::size_t number) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "-%03zu.zst", number);
    return folder + kind.name + digits;
}

/// Fills a list of the solver's memory with its tiles. Returns the place of each.
template <class Listed>
std::vector<int> listed_places(const std::vector<int>& tiles, int tile_count,
                               std::vector<Listed>& list) {
    std::vector<int> places(static_cast<std::size_t>(tile_count), -1);
    list.resize(tiles.size());
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        list[i].tile = tiles[i];
        places[static_cast<std::size_t>(tiles[i])] = static_cast<int>(i);
    }
    return places;
}

core::Message fault_of_lower_stratum(const film::FilmState& film, int tile) {
    const grid::Rect cells = film.shape.tile_cells(tile);
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x) {
            const int cell = grid::Shape::cell_in_tile(x, y);
            const film::LowerCell lower{film.lower.thickness.read(tile)[cell],
                                        film.lower.paint.read(tile)[cell]};
            if (!film::is_part_of(lower, film.thickness.read(tile)[cell], film.paint.read(tile)[cell]))
                return core::message("cell (%1, %2) holds a lower stratum that is no part of its paint.",
                                     x, y);
        }
    return {};
}

}  // namespace

const TileKind& kind_of(const TileEntry& entry) {
    const auto kinds = tile_kinds();
    return *std::find_if(kinds.begin(), kinds.end(),
                         [&](const TileKind& kind) { return kind.name == entry.kind; });
}

std::vector<TileEntry> tile_entries(const SurfaceSource& source, const std::string& folder) {
    std::vector<TileEntry> entries;
    for (const TileKind& kind : tile_kinds()) {
        const std::vector<int> tiles = kind.tiles(source);
        const std::size_t at_once = std::max<std::size_t>(1, kEntryBytes / kind.bytes);
        for (std::size_t first = 0; first < tiles.size(); first += at_once) {
            const std::size_t last = std::min(tiles.size(), first + at_once);
            TileEntry entry{kind.name, {&tiles[first], &tiles[0] + last}, {}};
            entry.packed.entry = entry_name(folder, kind, first / at_once);
            entry.packed.size = kind.bytes * entry.tiles.size();
            entries.push_back(std::move(entry));
        }
    }
    return entries;
}

void encode_tiles(const SurfaceSource& source, const TileEntry& entry, std::span<std::byte> out) {
    const TileKind& kind = kind_of(entry);
    for (std::size_t i = 0; i < entry.tiles.size(); ++i)
        kind.encode(source, entry.tiles[i], &out[i * kind.bytes]);
}

std::vector<int> tiles_of_kind(const std::vector<TileEntry>& entries, const std::string& kind) {
    std::vector<int> tiles;
    for (const TileEntry& entry : entries)
        if (entry.kind == kind) tiles.insert(tiles.end(), entry.tiles.begin(), entry.tiles.end());
    std::sort(tiles.begin(), tiles.end());
    return tiles;
}

SurfaceTarget target_of(const std::vector<TileEntry>& entries, document::SurfaceState& surface) {
    const int tile_count = surface.film.shape.tile_count();
    return {surface, listed_places(tiles_of_kind(entries, "awake"), tile_count, surface.solver.awake),
            listed_places(tiles_of_kind(entries, "pressure"), tile_count, surface.solver.pressures)};
}

core::Message decode_tiles(std::span<const std::byte> content, const TileEntry& entry,
                           SurfaceTarget& target) {
    const TileKind& kind = kind_of(entry);
    core::Message fault;
    for (std::size_t i = 0; i < entry.tiles.size() && fault.empty(); ++i)
        fault = kind.decode(&content[i * kind.bytes], entry.tiles[i], target);
    return fault;
}

core::Message fault_between_tiles(const film::FilmState& film) {
    core::Message fault;
    for (int tile = 0; tile < film.shape.tile_count() && fault.empty(); ++tile)
        if (film.lower.is_in(tile) || !film.lower.paint.is_background(tile))
            fault = fault_of_lower_stratum(film, tile);
    if (fault.empty() && !are_possible(film.media, film.thickness))
        fault = core::message("a cell holds more of its media than it holds paint.");
    return fault;
}

}  // namespace pastoso::recordings
