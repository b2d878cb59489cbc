// The tiles of a surface on their way into an archive and back.
#pragma once

#include "core/thread_pool.hpp"
#include "project/project_index.hpp"
#include "project/tile_kinds.hpp"
#include "project/zip_file.hpp"

#include <string>
#include <vector>

namespace pastoso::project {

/// Adds entries "FOLDERkind-000.zst" ... to the archive and returns what the index says of them.
std::vector<TileEntry> add_tiles(const SurfaceSource& source, const std::string& folder,
                                 ZipWriter& archive, core::ThreadPool& pool);

/// Reads them into the surface, whose film has its shape. Throws InputError "FILE, ENTRY: ..." for the
/// first entry in which something is wrong.
void read_tiles(const ZipReader& archive, const std::vector<TileEntry>& entries,
                document::SurfaceState& surface, core::ThreadPool& pool);

/// Over the support's tiles that are not among the entries, because their name tells what they are;
/// nothing when there are none.
std::optional<std::uint64_t> bare_support_checksum(const film::SupportHeights& bare_support_mm,
                                                   const std::vector<TileEntry>& entries);

/// The content of an entry that is a Zstandard frame. Throws InputError "FILE, ENTRY: ..." when it is
/// not what the index says.
Bytes read_packed(const ZipReader& archive, const PackedEntry& packed);

/// Packs `content` into the archive.
PackedEntry add_packed(std::string entry, std::span<const std::byte> content, ZipWriter& archive);

}  // namespace pastoso::project
