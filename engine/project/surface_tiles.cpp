#include "project/surface_tiles.hpp"

#include "core/error.hpp"
#include "core/hash.hpp"
#include "project/project_layout.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <utility>

namespace pastoso::project {
namespace {

/// pool.run() of a body that may throw; what the lowest index threw is thrown.
void run_guarded(core::ThreadPool& pool, std::size_t count,
                 const std::function<void(std::size_t index, int worker)>& body) {
    std::vector<std::exception_ptr> thrown(count);
    pool.run(count, [&](std::size_t index, int worker) {
        try {
            body(index, worker);
        } catch (...) {
            thrown[index] = std::current_exception();
        }
    });
    for (const std::exception_ptr& exception : thrown)
        if (exception) std::rethrow_exception(exception);
}

std::string entry_name(const std::string& folder, const TileKind& kind, std::size_t number) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "-%03zu.zst", number);
    return folder + kind.name + digits;
}

/// What a thread packs with; large memory that is asked for again and again costs more than the packing.
struct Bench {
    packing::Packer packer;
    Bytes room;
};

const TileKind& kind_of(const TileEntry& entry) {
    const auto kinds = tile_kinds();
    return *std::find_if(kinds.begin(), kinds.end(),
                         [&](const TileKind& kind) { return kind.name == entry.kind; });
}

std::vector<int> tiles_of_kind(const std::vector<TileEntry>& entries, const std::string& kind) {
    std::vector<int> tiles;
    for (const TileEntry& entry : entries)
        if (entry.kind == kind) tiles.insert(tiles.end(), entry.tiles.begin(), entry.tiles.end());
    std::sort(tiles.begin(), tiles.end());
    return tiles;
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

void read_entry(const ZipReader& archive, const TileEntry& entry, SurfaceTarget& target) {
    const TileKind& kind = kind_of(entry);
    const Bytes content = read_packed(archive, entry.packed);
    for (std::size_t i = 0; i < entry.tiles.size(); ++i) {
        const core::Message fault = kind.decode(&content[i * kind.bytes], entry.tiles[i], target);
        if (!fault.empty()) archive.fail(entry.packed.entry, fault);
    }
}

/// A tile whose motion is followed needs the thickness that it is counted from.
void check_windows(const ZipReader& archive, const document::SurfaceState& surface) {
    for (const auto& awake : surface.solver.awake) {
        if (awake.activity.window_s > 0.0F && !awake.window_start)
            archive.fail(kIndexEntry, "tile %1 moves, but there is no \"window\" that it started from.",
                         awake.tile);
    }
}

/// A lower stratum is a part of the cell's paint.
void check_lower_strata(const ZipReader& archive, const film::FilmState& film) {
    for (int tile = 0; tile < film.shape.tile_count(); ++tile) {
        if (!film.lower.is_in(tile) && film.lower.paint.is_background(tile)) continue;
        const grid::Rect cells = film.shape.tile_cells(tile);
        for (int y = cells.y0; y < cells.y1; ++y)
            for (int x = cells.x0; x < cells.x1; ++x) {
                const int cell = grid::Shape::cell_in_tile(x, y);
                const film::LowerCell lower{film.lower.thickness.read(tile)[cell],
                                            film.lower.paint.read(tile)[cell]};
                if (film::is_part_of(lower, film.thickness.read(tile)[cell],
                                     film.paint.read(tile)[cell]))
                    continue;
                archive.fail(kIndexEntry,
                             "cell (%1, %2) holds a lower stratum that is no part of its paint.", x, y);
            }
    }
}

}  // namespace

/// Tiles of one kind that are packed together.
struct TilePacking::Work {
    const TileKind* kind;
    TileEntry entry;
    std::promise<Bytes> frame{};

    /// What it throws goes to whom the frame is for.
    void carry_out(const SurfaceSource& source, Bench& bench) {
        try {
            frame.set_value(packed(source, bench));
        } catch (...) {
            frame.set_exception(std::current_exception());
        }
    }

    Bytes packed(const SurfaceSource& source, Bench& bench) {
        const std::size_t bytes = kind->bytes;
        const std::size_t size = bytes * entry.tiles.size();
        if (bench.room.size() < size) bench.room.resize(size);
        const std::span content = std::span(bench.room).first(size);
        for (std::size_t i = 0; i < entry.tiles.size(); ++i)
            kind->encode(source, entry.tiles[i], &content[i * bytes]);
        Bytes result = bench.packer.packed(content);
        entry.packed.size = content.size();
        entry.packed.packed_size = result.size();
        return result;
    }
};

TilePacking::TilePacking(document::SurfaceState surface, const film::SupportHeights* bare_support_mm,
                         const std::string& folder, ZipWriter& archive)
    : surface_(std::move(surface)), bare_support_mm_(bare_support_mm) {
    const SurfaceSource source{surface_, bare_support_mm_};
    for (const TileKind& kind : tile_kinds()) {
        const std::vector<int> tiles = kind.tiles(source);
        const std::size_t at_once = std::max<std::size_t>(1, kEntryBytes / kind.bytes);
        for (std::size_t first = 0; first < tiles.size(); first += at_once) {
            const std::size_t last = std::min(tiles.size(), first + at_once);
            TileEntry entry{kind.name, {&tiles[first], &tiles[0] + last}, {}};
            entry.packed.entry = entry_name(folder, kind, first / at_once);
            works_.push_back({&kind, std::move(entry)});
            archive.add(works_.back().entry.packed.entry, works_.back().frame.get_future());
        }
    }
}

TilePacking::~TilePacking() = default;
TilePacking::TilePacking(TilePacking&&) noexcept = default;

void TilePacking::pack(core::ThreadPool& pool) {
    const SurfaceSource source{surface_, bare_support_mm_};
    std::vector<Bench> benches(static_cast<std::size_t>(pool.thread_count()));
    pool.run(works_.size(), [&](std::size_t index, int worker) {
        works_[index].carry_out(source, benches[static_cast<std::size_t>(worker)]);
    });
}

std::vector<TileEntry> TilePacking::entries() const {
    std::vector<TileEntry> entries;
    for (const Work& work : works_)
        entries.push_back(work.entry);
    return entries;
}

void read_tiles(const ZipReader& archive, const std::vector<TileEntry>& entries,
                document::SurfaceState& surface, core::ThreadPool& pool) {
    const int tile_count = surface.film.shape.tile_count();
    SurfaceTarget target{
        surface, listed_places(tiles_of_kind(entries, "awake"), tile_count, surface.solver.awake),
        listed_places(tiles_of_kind(entries, "pressure"), tile_count, surface.solver.pressures)};
    for (const int phase : {0, 1}) {
        std::vector<const TileEntry*> due;
        for (const TileEntry& entry : entries)
            if (kind_of(entry).phase == phase) due.push_back(&entry);
        run_guarded(pool, due.size(),
                    [&](std::size_t index, int) { read_entry(archive, *due[index], target); });
    }
    check_windows(archive, surface);
    check_lower_strata(archive, surface.film);
}

std::optional<std::uint64_t> bare_support_checksum(const film::SupportHeights& bare_support_mm,
                                                   const std::vector<TileEntry>& entries) {
    const std::vector<int> written = tiles_of_kind(entries, "support");
    std::vector<float> heights_mm(grid::kTileCells);
    core::Hash64 hash;
    bool any = false;
    for (int tile = 0; tile < bare_support_mm.tile_count(); ++tile) {
        if (bare_support_mm.is_background(tile)) continue;
        if (std::binary_search(written.begin(), written.end(), tile)) continue;
        any = true;
        bare_support_mm.read(tile).copy(0, grid::kTileCells, heights_mm.data());
        hash.add(std::span<const float>(heights_mm));
    }
    return any ? std::optional(hash.value()) : std::nullopt;
}

Bytes read_packed(const ZipReader& archive, const PackedEntry& packed) {
    const Bytes frame = archive.read(packed.entry, packed.packed_size);
    try {
        return packing::unpacked(frame, packed.size);
    } catch (const core::InputError& error) {
        archive.fail(packed.entry, error.message());
    }
}

PackedEntry add_packed(std::string entry, std::span<const std::byte> content, ZipWriter& archive) {
    Bytes frame = packing::packed(content);
    PackedEntry noted{entry, content.size(), frame.size()};
    archive.add(std::move(entry), std::move(frame));
    return noted;
}

}  // namespace pastoso::project
