// The kinds of data that tiles of a painted surface have, each with its form in a project file.
#pragma once

#include "core/message.hpp"
#include "document/painting_state.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace pastoso::recordings {

/// What is written of a surface.
struct SurfaceSource {
    const document::SurfaceState& surface;
    /// Tiles of the support that are shared with it can be made again: they are left out where no paint
    /// lies on them. May be null.
    const film::SupportHeights* bare_support_mm = nullptr;
};

/// What is read. The lists of the solver's memory hold the tiles already, still empty.
struct SurfaceTarget {
    document::SurfaceState& surface;
    std::vector<int> awake_at, pressure_at;  ///< places in these lists by tile, -1 for none
};

struct TileKind {
    const char* name;
    std::size_t bytes;  ///< of a tile
    /// Kinds of phase 1 are decoded with the help of those of phase 0.
    int phase;
    /// The tiles that hold something, in ascending order.
    std::vector<int> (*tiles)(const SurfaceSource& source);
    /// Null for kinds that are only read, in files of older versions.
    void (*encode)(const SurfaceSource& source, int tile, std::byte* out);
    /// Returns what is wrong with the values, as a sentence; empty when they are what a painting can
    /// hold. Different tiles may be decoded at the same time.
    core::Message (*decode)(const std::byte* in, int tile, SurfaceTarget& target);
};

/// In the order of the file.
std::span<const TileKind> tile_kinds();

}  // namespace pastoso::recordings
