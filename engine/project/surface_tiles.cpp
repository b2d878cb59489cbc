#include "project/surface_tiles.hpp"

#include "core/error.hpp"
#include "core/hash.hpp"
#include "project/project_layout.hpp"
#include "recordings/tile_entries.hpp"

#include <algorithm>
#include <exception>
#include <functional>
#include <utility>

namespace pastoso::project {
namespace {

using recordings::SurfaceSource;
using recordings::SurfaceTarget;

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

/// What a thread packs with; large memory that is asked for again and again costs more than the packing.
struct Bench {
    packing::Packer packer;
    Bytes room;
};

void read_entry(const ZipReader& archive, const TileEntry& entry, SurfaceTarget& target) {
    const Bytes content = read_packed(archive, entry.packed);
    const core::Message fault = recordings::decode_tiles(content, entry, target);
    if (!fault.empty()) archive.fail(entry.packed.entry, fault);
}

/// A tile whose motion is followed needs the thickness that it is counted from.
void check_windows(const ZipReader& archive, const document::SurfaceState& surface) {
    for (const auto& awake : surface.solver.awake) {
        if (awake.activity.window_s > 0.0F && !awake.window_start)
            archive.fail(kIndexEntry, "tile %1 moves, but there is no \"window\" that it started from.",
                         awake.tile);
    }
}

}  // namespace

/// Tiles of one kind that are packed together.
struct TilePacking::Work {
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
        const std::size_t size = entry.packed.size;
        if (bench.room.size() < size) bench.room.resize(size);
        const std::span content = std::span(bench.room).first(size);
        recordings::encode_tiles(source, entry, content);
        Bytes result = bench.packer.packed(content);
        entry.packed.packed_size = result.size();
        return result;
    }
};

TilePacking::TilePacking(document::SurfaceState surface, const film::SupportHeights* bare_support_mm,
                         const std::string& folder, ZipWriter& archive)
    : surface_(std::move(surface)), bare_support_mm_(bare_support_mm) {
    for (TileEntry& entry : recordings::tile_entries({surface_, bare_support_mm_}, folder)) {
        works_.push_back({std::move(entry)});
        archive.add(works_.back().entry.packed.entry, works_.back().frame.get_future());
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
    SurfaceTarget target = recordings::target_of(entries, surface);
    for (const int phase : {0, 1}) {
        std::vector<const TileEntry*> due;
        for (const TileEntry& entry : entries)
            if (recordings::kind_of(entry).phase == phase) due.push_back(&entry);
        run_guarded(pool, due.size(),
                    [&](std::size_t index, int) { read_entry(archive, *due[index], target); });
    }
    check_windows(archive, surface);
    const core::Message fault = recordings::fault_between_tiles(surface.film);
    if (!fault.empty()) archive.fail(kIndexEntry, fault);
}

std::optional<std::uint64_t> bare_support_checksum(const film::SupportHeights& bare_support_mm,
                                                   const std::vector<TileEntry>& entries) {
    const std::vector<int> written = recordings::tiles_of_kind(entries, "support");
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
