// A painted surface but for its tiles, and parts of files, in JSON.
#pragma once

#include "files/json_place.hpp"
#include "recordings/surface_index.hpp"

namespace pastoso::recordings {

/// Of paint, in all surfaces together: what lies in their tiles, and what is painted after, can be added
/// without an overflow. A thousand times what the largest canvas can hold.
inline constexpr std::int64_t kMostPaint = std::int64_t{1} << 61;

/// {"entry": "pastoso/...", "size": ..., "packed": ...}.
files::Json packed_json(const PackedEntry& packed);
/// Reads the same, of at most so many bytes when unpacked.
PackedEntry read_packed(const files::JsonPlace& place, std::size_t most_bytes);

files::Json totals_json(const film::Totals& totals);
film::Totals read_totals(const files::JsonPlace& place);

files::Json surface_json(const SurfaceIndex& surface);
/// Reads the same; throws InputError with the place for anything that no surface has. Whether tiles come
/// twice is looked at, what they hold is not.
SurfaceIndex read_surface(const files::JsonPlace& place);

}  // namespace pastoso::recordings
