#include "recordings/surface_json.hpp"

#include "packing/packed_bytes.hpp"
#include "recordings/consistency_record.hpp"
#include "recordings/tile_entries.hpp"
#include "recordings/tile_kinds.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace pastoso::recordings {
namespace {

using files::Json;
using files::JsonPlace;

constexpr std::int64_t kMostCounted = std::numeric_limits<std::int64_t>::max();

/// [[first, count], ...]
Json runs_json(const std::vector<int>& tiles) {
    Json runs = Json::array();
    for (std::size_t i = 0; i < tiles.size();) {
        std::size_t end = i + 1;
        while (end < tiles.size() && tiles[end] == tiles[end - 1] + 1)
            ++end;
        runs.push_back(Json::array({tiles[i], end - i}));
        i = end;
    }
    return runs;
}

/// The tiles that were met of each kind: none may come twice, which also bounds what a file can ask for.
using SeenTiles = std::map<std::string, std::vector<bool>, std::less<>>;

std::vector<int> read_runs(const JsonPlace& place, std::vector<bool>& seen) {
    const auto tile_count = static_cast<std::int64_t>(seen.size());
    std::vector<int> tiles;
    for (std::size_t i = 0; i < place.size(); ++i) {
        const JsonPlace run = place.element(i);
        if (run.size() != 2) run.fail("expected the first tile and how many there are.");
        const std::int64_t least = tiles.empty() ? 0 : tiles.back() + 1;
        const std::int64_t first = run.element(0).integer(least, tile_count - 1);
        const std::int64_t count = run.element(1).integer(1, tile_count - first);
        for (std::int64_t tile = first; tile < first + count; ++tile) {
            if (seen[tile]) run.fail("tile %1 comes twice.", tile);
            seen[tile] = true;
            tiles.push_back(static_cast<int>(tile));
        }
    }
    return tiles;
}

template <std::size_t kCount>
Json counts_json(std::int64_t thickness, const std::array<std::int64_t, kCount>& channels) {
    Json json{{"thickness", thickness}, {"channels", Json::array()}};
    for (const std::int64_t channel : channels)
        json["channels"].push_back(channel);
    return json;
}

template <std::size_t kCount>
void read_counts(const JsonPlace& place, std::int64_t& thickness,
                 std::array<std::int64_t, kCount>& channels) {
    place.allow_only({"thickness", "channels"});
    thickness = place.entry("thickness").integer(-kMostPaint, kMostPaint);
    const JsonPlace list = place.entry("channels");
    if (list.size() != kCount) list.fail("expected %1 numbers.", kCount);
    for (std::size_t k = 0; k < kCount; ++k)
        channels[k] = list.element(k).integer(-kMostPaint, kMostPaint);
}

const TileKind& read_kind(const JsonPlace& place) {
    const std::string name = place.text();
    const auto kinds = tile_kinds();
    const auto kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const TileKind& one) { return one.name == name; });
    if (kind == kinds.end()) place.fail("there is no such kind of tiles as \"%1\".", name);
    return *kind;
}

TileEntry read_tile_entry(const JsonPlace& place, const grid::Shape& shape, SeenTiles& seen) {
    place.allow_only({"kind", "tiles", "entry", "size", "packed"});
    const TileKind& kind = read_kind(place.entry("kind"));
    std::vector<bool>& met = seen[kind.name];
    met.resize(static_cast<std::size_t>(shape.tile_count()));
    TileEntry entry{kind.name, read_runs(place.entry("tiles"), met), {}};
    const std::size_t size = kind.bytes * entry.tiles.size();
    entry.packed = read_packed(place, std::max(size, kEntryBytes));
    if (entry.packed.size != size || size > std::max(kind.bytes, kEntryBytes))
        place.entry("size").fail("the tiles hold %1 bytes, which has to be the size and at most %2.",
                                 size, kEntryBytes);
    return entry;
}

/// Versions before 5 tell whether the paint is `varied`, of several media.
std::optional<film::Consistencies> read_surface_consistencies(const JsonPlace& surface) {
    const auto varied = surface.optional_entry("varied");
    if (!varied) return read_consistencies(surface.entry("consistency"));
    return varied->boolean() ? std::optional(film::Consistencies::several()) : std::nullopt;
}

}  // namespace

Json packed_json(const PackedEntry& packed) {
    return {{"entry", packed.entry}, {"size", packed.size}, {"packed", packed.packed_size}};
}

/// The names of entries are compared with those in an archive; they lead nowhere else.
PackedEntry read_packed(const JsonPlace& place, std::size_t most_bytes) {
    PackedEntry packed;
    packed.entry = place.entry("entry").text();
    if (!packed.entry.starts_with("pastoso/"))
        place.entry("entry").fail("expected a name that begins with pastoso/.");
    const auto most = static_cast<std::int64_t>(most_bytes);
    packed.size = static_cast<std::size_t>(place.entry("size").integer(0, most));
    const auto most_packed = static_cast<std::int64_t>(packing::most_packed_bytes(packed.size));
    packed.packed_size = static_cast<std::size_t>(place.entry("packed").integer(1, most_packed));
    return packed;
}

Json totals_json(const film::Totals& totals) {
    return counts_json(totals.thickness, totals.paint);
}
film::Totals read_totals(const JsonPlace& place) {
    film::Totals totals;
    read_counts(place, totals.thickness, totals.paint);
    return totals;
}

Json surface_json(const SurfaceIndex& surface) {
    Json entries = Json::array();
    for (const TileEntry& entry : surface.entries) {
        Json json{{"kind", entry.kind}, {"tiles", runs_json(entry.tiles)}};
        json.update(packed_json(entry.packed));
        entries.push_back(std::move(json));
    }
    return {{"cells", Json::array({surface.shape.width, surface.shape.height})},
            {"cell_mm", surface.cell_mm},
            {"consistency", consistencies_json(surface.consistencies.value())},
            {"media", media_json(surface.media)},
            {"fixed", counts_json(surface.fixed.thickness, surface.fixed.pigment)},
            {"evaporated", surface.evaporated},
            {"advances", surface.calls},
            {"run_off", totals_json(surface.runoff)},
            {"tile_entries", std::move(entries)}};
}

SurfaceIndex read_surface(const JsonPlace& place) {
    place.allow_only({"cells", "cell_mm", "varied", "consistency", "media", "fixed", "evaporated",
                      "advances", "run_off", "tile_entries"});
    SurfaceIndex surface;
    const JsonPlace cells = place.entry("cells");
    if (cells.size() != 2) cells.fail("expected a width and a height.");
    constexpr int kMostCells = 32768;
    surface.shape.width = static_cast<int>(cells.element(0).integer(1, kMostCells));
    surface.shape.height = static_cast<int>(cells.element(1).integer(1, kMostCells));
    surface.cell_mm = place.entry("cell_mm").number();
    surface.consistencies = read_surface_consistencies(place);
    if (const auto media = place.optional_entry("media"))
        surface.media = read_media(*media, surface.shape.tile_count());
    read_counts(place.entry("fixed"), surface.fixed.thickness, surface.fixed.pigment);
    surface.evaporated = place.entry("evaporated").integer(0, kMostPaint);
    surface.calls = place.entry("advances").integer(0, kMostCounted / 2);
    surface.runoff = read_totals(place.entry("run_off"));
    const JsonPlace entries = place.entry("tile_entries");
    SeenTiles seen;
    for (std::size_t i = 0; i < entries.size(); ++i)
        surface.entries.push_back(read_tile_entry(entries.element(i), surface.shape, seen));
    return surface;
}

}  // namespace pastoso::recordings
