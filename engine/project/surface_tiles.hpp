// The tiles of a surface on their way into an archive and back.
#pragma once

#include "core/thread_pool.hpp"
#include "project/project_index.hpp"
#include "project/zip_file.hpp"

#include <string>
#include <vector>

namespace pastoso::project {

/// The tiles of a surface on their way into an archive.
class TilePacking {
  public:
    /// Adds entries "FOLDERkind-000.zst" ... to the archive; their contents come with pack().
    /// `bare_support_mm` as in recordings::SurfaceSource.
    TilePacking(document::SurfaceState surface, const film::SupportHeights* bare_support_mm,
                const std::string& folder, ZipWriter& archive);
    ~TilePacking();
    TilePacking(TilePacking&&) noexcept;

    /// Once, before or while the archive is written.
    void pack(core::ThreadPool& pool);

    /// What the index says of them; sizes after pack().
    std::vector<TileEntry> entries() const;

  private:
    struct Work;
    document::SurfaceState surface_;
    const film::SupportHeights* bare_support_mm_;
    std::vector<Work> works_;
};

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
