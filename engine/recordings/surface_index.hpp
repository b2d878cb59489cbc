// What a file tells of a painted surface beside its tiles, and which tiles it has.
#pragma once

#include "document/canvas.hpp"
#include "document/painting_state.hpp"
#include "recordings/media_record.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::recordings {

/// Part of a file that is a Zstandard frame with a checksum of its own.
struct PackedEntry {
    std::string entry;            ///< its name
    std::size_t size = 0;         ///< of the content
    std::size_t packed_size = 0;  ///< of the frame
};

/// Tiles of one kind, one after the other.
struct TileEntry {
    std::string kind;
    std::vector<int> tiles;  ///< in ascending order
    PackedEntry packed;
};

/// A painted surface but for its tiles.
struct SurfaceIndex {
    grid::Shape shape{};
    double cell_mm = 0.0;
    /// Left out where formats before 5 say that it is of one medium.
    std::optional<film::Consistencies> consistencies{};
    MediaIndex media{};  ///< none in formats before 9
    film::DriedTotals fixed{};
    std::int64_t evaporated = 0;
    std::int64_t calls = 0;
    film::Totals runoff{};
    std::vector<TileEntry> entries{};
};

/// All but the entries, which stay empty.
SurfaceIndex surface_index(const document::SurfaceState& surface);

/// The surface with all but its tiles.
document::SurfaceState empty_surface(const SurfaceIndex& index);

/// Whether a painting can have cells of that size.
inline bool is_possible_cell(double cell_mm) {
    return cell_mm >= 1.0 / document::kMaxPxPerMm && cell_mm <= 1.0 / document::kMinPxPerMm;
}

/// The largest of what the account counts of a surface, without sign.
double largest_count(const SurfaceIndex& surface);

}  // namespace pastoso::recordings
